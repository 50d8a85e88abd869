// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/scene_tracer.h"

#include "techniques/foundation/scene/facing.h"
#include "techniques/foundation/scene/shading.h"
#include "techniques/foundation/trace/bvh_traverse.h"

namespace shadowlab::trace {

namespace {

// Nearer than this share of the way to the light is contact, not a crossing: the point itself is only known to about
// 2^-50 of its coordinates, and its neighbours in the same plane would otherwise shadow it by rounding.
constexpr double kContact = 1e-10;

// Toward the sun there is no way to take a share of; the size of the coordinates stands in for it.
constexpr double kContactPerMetre = 1e-12;

} // namespace

bool SceneTracer::advance(const scene::Snapshot& snapshot, std::chrono::steady_clock::time_point deadline) {
    const scene::Revisions& revisions = snapshot->revisions;
    const bool sameScene = snapshot == snapshot_;
    snapshot_ = snapshot;
    if (revisions.geometry != geometry_ || revisions.transforms != transforms_) {
        geometry_ = revisions.geometry;
        transforms_ = revisions.transforms;
        world_ = worldTriangles(*snapshot);
        builder_.emplace(world_.triangles);
        if (std::chrono::steady_clock::now() >= deadline) return false;
    }
    if (builder_) {
        if (!builder_->advance(deadline)) return false;
        bvh_ = builder_->take();
        builder_.reset();
        lookAtLights();
    } else if (!sameScene) {
        lookAtLights();
    }
    return true;
}

void SceneTracer::lookAtLights() {
    mirrored_.clear();
    for (const scene::Object& object : snapshot_->objects)
        mirrored_.push_back(scene::isMirrored(object));
    lights_.clear();
    for (const scene::Light& light : snapshot_->lights) {
        LightView view{scene::facingSigns(*snapshot_, light), {}};
        view.blocks.reserve(view.facing.size());
        // A triangle whose plane holds the light is only ever touched, at the light itself, never crossed.
        for (std::size_t i = 0; i < view.facing.size(); ++i)
            view.blocks.push_back(view.facing[i] != 0 && snapshot_->objects[world_.objects[i]].castsShadow ? 1 : 0);
        lights_.push_back(std::move(view));
    }
}

SurfacePoint SceneTracer::eyePoint(const EyeRays& rays, dvec2 pixel) const {
    const Ray ray = rays.through(pixel);
    const RayHit hit = bvh_.closest(ray);
    if (!hit) return {};
    const Triangle& t = bvh_.triangles[hit.primitive];
    const double eyeSide = glm::dot(glm::cross(t.b - t.a, t.c - t.a), rays.eyeCentred() - t.a);
    return {hit.primitive, eyeSide > 0, hit.t * glm::length(ray.directionCentred), dvec2(hit.barycentric)};
}

dvec3 SceneTracer::positionCentred(const SurfacePoint& point) const {
    // From the corners, not along the ray: so the point lies in the triangle's plane, however far away the eye is.
    const Triangle& t = bvh_.triangles[point.primitive];
    return t.c + point.weights.x * (t.a - t.c) + point.weights.y * (t.b - t.c);
}

bool SceneTracer::facesLight(const SurfacePoint& point, int light) const {
    const std::size_t l = static_cast<std::size_t>(light);
    // The stored sign counts in mesh space, where a mirrored object's winding is the other way round.
    const bool eyeOnFront = point.eyeOnFront != mirrored_[world_.objects[point.primitive]];
    const int lightSide = lights_[l].facing[point.primitive];
    if (eyeOnFront ? lightSide <= 0 : lightSide >= 0) return false;
    return scene::lightShinesTo(snapshot_->lights[l], positionWorld(point));
}

std::uint32_t SceneTracer::blocker(const SurfacePoint& point, int light, ShadowStart start) const {
    const scene::Light& source = snapshot_->lights[static_cast<std::size_t>(light)];
    const std::vector<std::uint8_t>& blocks = lights_[static_cast<std::size_t>(light)].blocks;
    Ray ray;
    ray.originCentred = positionCentred(point);
    const bool naive = start == ShadowStart::naive;
    if (naive) ray.originCentred = dvec3(vec3(ray.originCentred));
    if (source.type == scene::LightType::directional) {
        ray.directionCentred = -source.directionWorld;
        ray.nearest = kContactPerMetre * (1.0 + glm::length(ray.originCentred));
    } else {
        ray.directionCentred = (source.positionWorld - world_.originWorld) - ray.originCentred;
        ray.nearest = kContact;
        ray.farthest = 1.0; // the light
    }
    if (naive) ray.nearest = 0;
    const std::uint32_t itself = naive ? kNoPrimitive : point.primitive;
    return bvh_.any(ray, [&](std::uint32_t primitive) { return primitive != itself && blocks[primitive]; });
}

Visibility SceneTracer::visibility(const SurfacePoint& point, int light, ShadowStart start) const {
    if (!point) return Visibility::noSurface;
    if (!facesLight(point, light)) return Visibility::turnedAway;
    if (!objectOf(point).receivesShadow) return Visibility::lit;
    return blocker(point, light, start) == kNoPrimitive ? Visibility::lit : Visibility::shadowed;
}

void SceneTracer::eyePoints(const EyeRays& rays, ivec2 corner, ivec2 blockSize, dvec2 within,
                            std::span<SurfacePoint> points) const {
    for (int y = 0, i = 0; y < blockSize.y; ++y)
        for (int x = 0; x < blockSize.x; ++x, ++i)
            points[static_cast<std::size_t>(i)] = eyePoint(rays, dvec2(corner + ivec2(x, y)) + within);
}

void SceneTracer::visibilities(std::span<const SurfacePoint> points, int light, std::span<Visibility> answers) const {
    for (std::size_t i = 0; i < points.size(); ++i)
        answers[i] = visibility(points[i], light);
}

} // namespace shadowlab::trace
