// Final gather: the last reflection of the light, collected by each pixel for itself.
//
// Patches hold what surfaces send each other as one number each; interpolated, it has no contact shadows, and colour bleeds no
// farther into a corner than a patch is fine. So each pixel sends rays of its own over its half sphere and adds up what arrives
// along them from the solved patches (M. F. Cohen and J. R. Wallace, "Radiosity and Realistic Image Synthesis", 1993, section 10.4;
// H. E. Rushmeier, "Realistic Image Synthesis for Scenes with Radiatively Participating Media", 1988). What errors the patches have
// is then seen only in the mean over all that a pixel sees.
//
// Where a ray ends, what lights without an area bring there is found by a shadow ray, since that has edges; all else is the patch's.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/lights/pixel_light.h"
#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

class PixelGather {
public:
    /// What is gathered.
    struct Solution {
        const RoomCache& cache;
        const Sources& sources;
        std::span<const dvec3> reflectedIrradiance; ///< of each patch, W/m^2: all but the direct light of lights
        dvec3 outside{0.0};                         ///< radiance where a ray meets nothing
        std::uint64_t version = 0;                  ///< changes with any of them
    };
    /// One ray more for each pixel until all have `samples` (true) or the deadline has passed, but always does some work. Begins anew
    /// when the solution, the scene or the eye is another one. `light` must be complete.
    bool advance(const Solution& solution, const PixelLight& light, std::size_t samples, Deadline deadline);

    /// How many rays each pixel has sent; nothing can be shown before the first.
    [[nodiscard]] std::size_t samples() const { return done_; }
    /// The irradiance by all but direct light, W/m^2, the mean of the rays so far; row 0 is at the bottom. Of pixels without a surface 0.
    [[nodiscard]] std::vector<vec4> irradianceFromBelow() const;

private:
    /// What the sums are of.
    struct Key {
        std::uint64_t solution = 0;
        trace::SeenFrom seenFrom;
        std::vector<scene::Light> lights;
        friend bool operator==(const Key&, const Key&) = default;
    };
    void gatherBlock(const Solution& solution, const PixelLight& light, std::size_t block);
    [[nodiscard]] dvec3 arrivingAlong(const Solution& solution, const PixelLight& light, const trace::SurfacePoint& from,
                                      const dvec3& directionWorld) const;
    [[nodiscard]] dvec3 radiosityAt(const Solution& solution, const PixelLight& light, const trace::SurfacePoint& point) const;

    Key key_;
    ivec2 size_{0};
    std::vector<dvec3> sums_; ///< of each pixel, rows from the top
    std::size_t done_ = 0, nextBlock_ = 0;
};

} // namespace shadowlab::radiosity
