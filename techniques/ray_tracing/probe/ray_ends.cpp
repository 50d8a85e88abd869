// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/ray_ends.h"

#include <algorithm>
#include <limits>

namespace shadowlab::ray_tracing {

namespace {

// Toward the sun: a little beyond where the ray leaves the scene.
constexpr double kBeyond = 1.05;

} // namespace

scene::Bounds boundsOf(const scene::Scene& scene) {
    scene::Bounds bounds;
    for (const scene::Bounds& box : scene::objectBounds(scene))
        bounds.include(box);
    return bounds;
}

dvec3 endBeyond(const scene::Bounds& bounds, const dvec3& fromWorld, const dvec3& directionWorld) {
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        if (directionWorld[axis] != 0) {
            const double side = directionWorld[axis] > 0 ? bounds.upperWorld[axis] : bounds.lowerWorld[axis];
            leave = std::min(leave, std::max(0.0, (side - fromWorld[axis]) / directionWorld[axis]));
        }
    const double size = glm::length(bounds.upperWorld - bounds.lowerWorld);
    return fromWorld + std::min(kBeyond * leave + 0.02 * size, size) * directionWorld;
}

dvec3 shadowRayEnd(const trace::SceneTracer& tracer, const trace::SurfacePoint& point, int light,
                   const scene::Bounds& bounds) {
    if (tracer.objectOf(point).receivesShadow)
        if (const auto blockerWorld = tracer.blockedAtWorld(point, light)) return *blockerWorld;
    const scene::Light& source = tracer.scene().light(light);
    if (source.type != scene::LightType::directional) return source.positionWorld;
    return endBeyond(bounds, tracer.positionWorld(point), -source.directionWorld);
}

} // namespace shadowlab::ray_tracing
