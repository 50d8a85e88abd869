// Final gather: the last reflection of the light, collected at one point.
//
// Patches hold what surfaces send each other as one number each; interpolated, it has no contact shadows, and colour bleeds no
// farther into a corner than a patch is fine. So a point sends rays of its own over its half sphere and adds up what arrives
// along them from the solved patches (M. F. Cohen and J. R. Wallace, "Radiosity and Realistic Image Synthesis", 1993, section 10.4;
// H. E. Rushmeier, "Realistic Image Synthesis for Scenes with Radiatively Participating Media", 1988). What errors the patches have
// is then seen only in the mean over all that the point sees.
//
// Where a ray ends, what lights bring there is found by a shadow ray, since that has edges; all else is the patch's.
// Where most of the light comes from few patches, rays also go to points of these on purpose (gather_guide.h), and where it comes in through a
// window, to points of it (openings.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/radiosity/display/gather_guide.h"
#include "techniques/radiosity/display/openings.h"
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/lights/pixel_light.h"
#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

/// What is gathered.
struct GatherSolution {
    const RoomCache& cache;
    const Sources& sources;
    const GatherGuide& guide;
    const Openings& openings; ///< empty where what comes in through them is a small part of the light
    std::span<const dvec3> reflectedIrradiance; ///< of each patch, W/m^2: all but the direct light of lights
    dvec3 outside{0.0};                         ///< radiance where a ray meets nothing
    std::uint64_t version = 0;                  ///< changes with any of them
};

/// What has been gathered depends on this: while it is equal, it is kept.
struct GatherKey {
    std::uint64_t solution = 0;
    trace::SeenFrom seenFrom;
    std::vector<scene::Light> lights;
    std::size_t rays = 0; ///< of a point
    friend bool operator==(const GatherKey&, const GatherKey&) = default;
};

/// The sum over some rays; the irradiance by all but direct light is their mean, W/m^2.
struct Gathered {
    dvec3 irradiance{0.0};
    double nearness = 0; ///< of 1 / distance of what was met, 1/m
    std::size_t met = 0; ///< how many met something
    // Of the luminance of that irradiance, what chosen points of patches and openings bring; and the sum of it over their distance, 1/m.
    double fromChosen = 0, nearnessOfChosen = 0;
};

/// Which rays of an endless sequence that fills the half sphere evenly. Sequences of another shift (in the unit square) are other ones.
struct GatherRays {
    dvec2 shift{0.0};
    std::size_t first = 0, count = 0;
};

/// From what a pixel shows, along these rays, and where light comes from few patches, or in through openings, along as many to them. `light` must be complete.
Gathered gather(const GatherSolution& solution, const PixelLight& light, ivec2 pixel, const GatherRays& rays);

} // namespace shadowlab::radiosity
