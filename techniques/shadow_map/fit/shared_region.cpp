// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/shared_region.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/query/view/clip_polygon.h"

namespace shadowlab::shadow_map {

namespace {

/// Of the steps that divide `whole` by a power of two, the largest of which `part` has kRegionSteps. A share of the casters'
/// own size and no round number of metres: at any scale the same scene has the same map.
double stepOf(double part, double whole) {
    const double share = std::max(part, 1e-6 * whole) / whole;
    return whole * std::exp2(std::ceil(std::log2(share))) / kRegionSteps;
}

} // namespace

Box boxInView(std::span<const scene::Bounds> boxes, const dvec3& originWorld, const dmat4& lightViewFromLightRelative) {
    Box range;
    for (const scene::Bounds& box : boxes)
        for (int i = 0; i < 8; ++i)
            range.include(transformPoint(lightViewFromLightRelative, box.corner(i) - originWorld));
    return range;
}

Box around(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

Box sharedRegion(const Box& casters, std::span<const scene::Bounds> receivers, const dvec3& originWorld,
                 const dmat4& lightViewFromLightRelative) {
    const dvec4 sides[4] = {dvec4(1, 0, 0, -casters.lower.x), dvec4(-1, 0, 0, casters.upper.x),
                            dvec4(0, 1, 0, -casters.lower.y), dvec4(0, -1, 0, casters.upper.y)};
    Box seen;
    for (const scene::Bounds& box : receivers)
        for (int face = 0; face < 6; ++face) {
            std::vector<dvec4> polygon = scene::boxFaceWorld(box, face);
            for (dvec4& corner : polygon)
                corner = dvec4(transformPoint(lightViewFromLightRelative, dvec3(corner) - originWorld), 1.0);
            for (const dvec4& side : sides)
                polygon = scene::clippedPolygon(polygon, side);
            for (const dvec4& corner : polygon)
                seen.include(dvec3(corner));
        }
    // All casters beyond all receivers shadow nothing.
    if (seen.isEmpty() || casters.upper.z < seen.lower.z) return {};
    const dvec3 extent = seen.upper - seen.lower, whole = casters.upper - casters.lower;
    const double size = std::max({whole.x, whole.y, whole.z, extent.x, extent.y, extent.z, 1e-30});
    const double sideways = stepOf(std::max(extent.x, extent.y), size);
    const dvec3 step(sideways, sideways, stepOf(extent.z, size));
    Box region{casters.lower + glm::floor((seen.lower - casters.lower) / step) * step,
               casters.lower + glm::ceil((seen.upper - casters.lower) / step) * step};
    for (int axis = 0; axis < 2; ++axis) {
        region.lower[axis] = std::max(region.lower[axis], casters.lower[axis]);
        region.upper[axis] = std::min(region.upper[axis], casters.upper[axis]);
    }
    return region;
}

} // namespace shadowlab::shadow_map
