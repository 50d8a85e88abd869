// What the lights of a scene bring to its patches before anything is reflected, and how much of it others take away.
//
// What would arrive with nothing in between is known (light_source.h). Where something may stand in between, lines from points of
// the patch to the light are tried: the share of what comes by free ones, times that.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <functional>

#include "techniques/radiosity/lights/light_source.h"

namespace shadowlab::radiosity {

/// Of one light, for each patch.
struct DirectLight {
    std::vector<dvec3> irradiance; ///< H_i, W/m^2, the mean over the patch, in the light's colour
    /// 0..1: what arrives, as a share of what would with nothing in between; 0 where nothing would. Where it is neither 0 nor 1, it is
    /// found by 64 lines: as many chosen by chance would miss it by up to 1/16 (one standard deviation), these by half as much.
    std::vector<double> visible;
    /// 0..1: the share of the light's area that is seen, on average: what is behind the patch's plane is not.
    std::vector<double> seenArea;
};

class DirectLightBuilder {
public:
    /// Patches and occlusion must live as long. `receivesShadow`: of each patch, 1 or 0; 0: lit as if nothing stood between.
    DirectLightBuilder(LightSource source, const std::vector<Patch>& patches, const Occlusion& occlusion,
                       std::vector<std::uint8_t> receivesShadow);

    /// Goes on until all is done (true) or the time has come, but always a bit. The numbers are the same for any deadlines and
    /// any number of threads.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// 0..1 of all patches.
    [[nodiscard]] double done() const;
    [[nodiscard]] DirectLight take() { return std::move(light_); }

private:
    void fill(std::size_t i);
    void sampleLines(std::size_t i, const Blockers& blockers);

    LightSource source_;
    const std::vector<Patch>& patches_;
    const Occlusion& occlusion_;
    std::vector<std::uint8_t> receivesShadow_;
    DirectLight light_;
    std::size_t next_ = 0; ///< patch
};

/// What arrives at a point.
struct Arriving {
    dvec3 irradiance{0.0}; ///< W/m^2, in the light's colour
    /// As in DirectLight; of lights without an area 1 where nothing stands in between, whichever way the surface faces.
    double seenArea = 0;
};

/// Does something stand between two points?
using IsBlocked = std::function<bool(const dvec3& fromCentred, const dvec3& toCentred)>;

/// At a point of a surface with that unit normal, by 64 lines to a light with an area and one to others. `isBlocked`: asked of the point
/// and points of the light.
Arriving arrivingAt(const dvec3& positionCentred, const dvec3& normal, const LightSource& source,
                    const IsBlocked& isBlocked);

} // namespace shadowlab::radiosity
