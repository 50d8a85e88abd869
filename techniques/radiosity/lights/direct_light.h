// The direct light on patches: what the lights bring before anything is reflected, and how much of it is blocked.
//
// What would arrive with nothing in between is known (light_source.h). Where something may block it, lines between points of the
// patch and the light are tested: the unblocked share of their weights, times that.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <functional>

#include "techniques/radiosity/lights/light_source.h"
#include "techniques/radiosity/patches/patch_cells.h"

namespace shadowlab::radiosity {

/// The direct light of one light, for each patch.
struct DirectLight {
    std::vector<dvec3> irradiance; ///< H_i, W/m^2, the mean over the patch, in the light's colour
    /// 0..1: the share of the unoccluded light that arrives; 0 where none would. Where it is neither 0 nor 1 it is estimated by
    /// 64 lines: with random lines its standard deviation would be up to 1/16; with these Hammersley points it is half of that.
    std::vector<double> visible;
    /// 1: something may stand before a part of the patch, also where all 64 lines arrive or none does; 0: all points of it have the same answer.
    std::vector<std::uint8_t> mayHaveEdge;
    /// Where on the patch it arrives, by the same lines: the share of each cell. 0 in all of them: nowhere.
    std::vector<PatchCells::Shares> cells;
    /// 0..1: the mean share of the light's area that is seen; what lies behind the patch's plane is not.
    std::vector<double> seenArea;
};

class DirectLightBuilder {
public:
    /// Patches and occlusion must outlive this object. `receivesShadow`: for each patch, 1 or 0; with 0 it is lit as if nothing
    /// were in between.
    DirectLightBuilder(LightSource source, const std::vector<Patch>& patches, const Occlusion& occlusion,
                       std::vector<std::uint8_t> receivesShadow);

    /// Continues until all is done (true) or the deadline has passed, but always does some work. The numbers do not depend on
    /// deadlines or on the number of threads.
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

/// The direct light at one point.
struct Arriving {
    dvec3 irradiance{0.0}; ///< W/m^2, in the light's colour
    /// As in DirectLight; for lights without an area 1 where nothing is in between, whichever way the surface faces.
    double seenArea = 0;
};

/// Is the line between two points blocked?
using IsBlocked = std::function<bool(const dvec3& fromCentred, const dvec3& toCentred)>;

/// The direct light at a point of a surface with that unit normal, by 64 lines to a light with an area and one to others.
/// `isBlocked` is called with the point and points of the light.
Arriving arrivingAt(const dvec3& positionCentred, const dvec3& normal, const LightSource& source,
                    const IsBlocked& isBlocked);

} // namespace shadowlab::radiosity
