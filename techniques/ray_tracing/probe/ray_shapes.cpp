// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/ray_shapes.h"

#include <algorithm>
#include <limits>

#include "techniques/foundation/base/look.h"

namespace shadowlab::ray_tracing {

namespace {

// Rays to a directional light end a little beyond the scene's bounding box.
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

namespace {

// Cells of the view with one path each: few enough to follow each ray by eye, enough to hit every larger object.
constexpr int kColumns = 6, kRows = 4;

// Points per side of a cell that are tested for shadow: small shadows lie between the centres of cells.
constexpr int kTriedPixels = 8;

/// The rays of one pixel.
struct RayPath {
    dvec3 pointWorld;
    bool isSent = false; ///< is a shadow ray sent?
    std::optional<dvec3> blockerWorld;
};

/// The path of a cell: of its points in shadow the one whose blocker is farthest away; else its centre.
std::optional<RayPath> pathIn(const trace::SceneTracer& tracer, const trace::EyeRays& rays, dvec2 corner, dvec2 size,
                              int light) {
    const auto pathAt = [&](dvec2 pixel) -> std::optional<RayPath> {
        const trace::SurfacePoint point = tracer.eyePoint(rays, pixel);
        if (!point) return std::nullopt;
        RayPath path{tracer.positionWorld(point), false, {}};
        path.isSent = tracer.facesLight(point, light) && tracer.objectOf(point).receivesShadow;
        if (path.isSent) path.blockerWorld = tracer.blockedAtWorld(point, light);
        return path;
    };
    std::optional<RayPath> best = pathAt(corner + 0.5 * size);
    double longest = 0;
    for (int y = 0; y < kTriedPixels; ++y)
        for (int x = 0; x < kTriedPixels; ++x) {
            const auto path = pathAt(corner + (dvec2(x, y) + 0.5) / static_cast<double>(kTriedPixels) * size);
            if (!path || !path->blockerWorld) continue;
            const double length = glm::length(*path->blockerWorld - path->pointWorld);
            if (length <= longest) continue;
            best = path;
            longest = length;
        }
    return best;
}

} // namespace

std::vector<SceneShape> rayShapes(const trace::SceneTracer& tracer, const View& view, int light) {
    using enum SceneShape::Kind;
    SceneShape eyeRays{"eye rays", look::kEyeRay, lines, {}};
    SceneShape arriving{"shadow rays: lit", look::kEqualDepth, lines, {}};
    SceneShape blocked{"shadow rays: blocked", look::kOccluded, lines, {}};
    const scene::Light& source = tracer.scene().light(light);
    const scene::Bounds bounds = boundsOf(tracer.scene());

    const trace::EyeRays rays = tracer.eyeRays(view.camera, view.size);
    const dvec2 cell = dvec2(view.size) / dvec2(kColumns, kRows);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const auto path = pathIn(tracer, rays, dvec2(column, row) * cell, cell, light);
            if (!path) continue;
            eyeRays.pointsWorld.insert(eyeRays.pointsWorld.end(), {view.camera.positionWorld, path->pointWorld});
            if (!path->isSent) continue;
            const dvec3 endWorld = path->blockerWorld ? *path->blockerWorld
                                   : source.type == scene::LightType::directional
                                       ? endBeyond(bounds, path->pointWorld, -source.directionWorld)
                                       : source.positionWorld;
            std::vector<dvec3>& points = (path->blockerWorld ? blocked : arriving).pointsWorld;
            points.insert(points.end(), {path->pointWorld, endWorld});
        }
    return {eyeRays, arriving, blocked};
}

} // namespace shadowlab::ray_tracing
