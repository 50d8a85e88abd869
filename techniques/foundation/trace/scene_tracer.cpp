// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/scene_tracer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/lamp_plane.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"

namespace shadowlab::trace {

bool SceneTracer::advance(const scene::Snapshot& snapshot, std::chrono::steady_clock::time_point deadline) {
    const bool sameScene = snapshot == snapshot_;
    snapshot_ = snapshot;
    const auto isOfThisScene = [&](const TracedGeometry& geometry) {
        return geometry.revisions == revisionsOf(*snapshot);
    };
    if (!(geometry_ && isOfThisScene(*geometry_)) && !(unfinished_ && isOfThisScene(*unfinished_))) {
        builder_.reset();
        unfinished_.reset();
        geometry_ = sharedGeometry(*snapshot);
        if (!geometry_) {
            unfinished_ = std::make_shared<TracedGeometry>(revisionsOf(*snapshot), worldTriangles(*snapshot));
            builder_.emplace(unfinished_->world.triangles);
            if (std::chrono::steady_clock::now() >= deadline) return false;
        }
    } else if (sameScene && !unfinished_) {
        return true;
    }
    if (unfinished_) {
        if (!builder_->advance(deadline)) return false;
        unfinished_->bvh = builder_->take();
        builder_.reset();
        geometry_ = share(std::exchange(unfinished_, nullptr));
    }
    holes_ = Holes(*snapshot_, world());
    holesForLight_ = castsWhole_ ? Holes() : holes_;
    lookAtLights();
    coincident_ = scene::CoincidentFaces::of(*snapshot_);
    return true;
}

void SceneTracer::lookAtLights() {
    casts_.clear();
    for (const scene::Object& object : snapshot_->objects)
        casts_.insert(casts_.end(), object.mesh->triangles.size(), object.castsShadow ? 1 : 0);
    lights_.clear();
    for (const scene::Light& light : snapshot_->lights) {
        const std::vector<std::int8_t> facing = scene::facingSigns(*snapshot_, light);
        LightView view;
        view.gates.reserve(facing.size());
        view.blocks.reserve(facing.size());
        for (std::size_t i = 0; i < facing.size(); ++i) {
            const scene::Object& object = snapshot_->objects[world().objects[i]];
            // The stored sign counts in mesh space, where a mirrored object's winding is the other way round.
            const int frontSide = scene::isMirrored(object) ? -facing[i] : facing[i];
            view.gates.push_back(static_cast<std::uint8_t>((frontSide > 0 ? facesFront : 0) |
                                                           (frontSide < 0 ? facesBack : 0) |
                                                           (object.receivesShadow ? receives : 0)));
            // A triangle whose plane holds the light is only ever touched, at the light itself, never crossed.
            view.blocks.push_back(facing[i] != 0 && object.castsShadow ? 1 : 0);
        }
        const std::vector<std::uint8_t> inPlane = scene::inLampPlane(*snapshot_, light);
        if (!inPlane.empty()) view.hidesPart = casts_;
        for (std::size_t i = 0; i < inPlane.size(); ++i)
            if (inPlane[i]) {
                view.hidesPart[i] = 0;
                view.gates[i] |= inLampPlane;
            }
        lights_.push_back(std::move(view));
    }
}

RayHit SceneTracer::closest(const Ray& ray, const MayHit& mayHit) const {
    if (engine_) return engine_->closest(ray, mayHit);
    return bvh().closest(ray, mayHit, [&](std::uint32_t p, const dvec3& at) { return mayHit.inHole(p, at); });
}

std::uint32_t SceneTracer::any(const Ray& ray, const MayHit& mayHit) const {
    if (engine_) return engine_->any(ray, mayHit);
    return bvh().any(ray, mayHit, [&](std::uint32_t p, const dvec3& at) { return mayHit.inHole(p, at); });
}

RayTests SceneTracer::testsOf(const Engine& engine, const EyeRays& rays, dvec2 pixel) const {
    RayTests tests;
    const SurfacePoint point = surfacePoint(rays, engine.closest(rays.through(pixel), {.holes = &holes_}, tests));
    for (int light = 0; point && light < static_cast<int>(lights_.size()); ++light)
        if (facesLight(point, light) && objectOf(point).receivesShadow)
            (void)engine.any(shadowRay(point, light, ShadowStart::exact), mayBlock(light, point.primitive), tests);
    return tests;
}

SurfacePoint SceneTracer::eyePoint(const EyeRays& rays, dvec2 pixel) const {
    const Ray ray = rays.through(pixel);
    const MayHit all = mayMeet(kNoPrimitive);
    return surfacePoint(rays, seenInstead(ray, closest(ray, all), all));
}

RayHit SceneTracer::seenInstead(const Ray& ray, const RayHit& hit, const MayHit& mayHit, double time) const {
    if (!hit || !coincident_->touches(hit.primitive)) return hit;
    const bool isWithin = coincident_->isWithinBody(ray.originCentred + world().originWorld);
    if (!mayShowAnother(surfacePoint(ray.directionCentred, hit), isWithin)) return hit;
    // Of those in its place one that goes before it, then one that goes before that, until there is none.
    RayHit seen = hit;
    const dvec3 velocity = snapshot_->objects[world().objects[hit.primitive]].velocityWorld;
    const std::function<bool(std::uint32_t)> goesBefore = [&](std::uint32_t other) {
        return mayHit(other) && coincident_->areTogether(seen.primitive, other) &&
               rankOf(seen.primitive, ray.directionCentred) < rankOf(other, ray.directionCentred) &&
               (time == 0 || snapshot_->objects[world().objects[other]].velocityWorld == velocity); // else they have parted
    };
    while (const RayHit other = closest(ray, {.only = &goesBefore, .holes = mayHit.holes}))
        seen = other;
    return seen;
}

scene::SideRank SceneTracer::rankOf(std::uint32_t primitive, const dvec3& directionWorld) const {
    const SurfacePoint point = surfacePoint(directionWorld, {0, primitive, {}});
    return coincident_->rank(primitive, point.eyeOnFront != scene::isMirrored(objectOf(point)));
}

SurfacePoint SceneTracer::surfacePoint(const EyeRays& rays, const RayHit& hit) const {
    if (!hit) return {};
    const Triangle& t = bvh().triangles[hit.primitive];
    const double eyeSide = glm::dot(glm::cross(t.b - t.a, t.c - t.a), rays.eyeCentred() - t.a);
    return {hit.primitive, eyeSide > 0, dvec2(hit.barycentric)};
}

SurfacePoint SceneTracer::nextPoint(const SurfacePoint& from, const dvec3& directionWorld) const {
    return nextPoint(positionCentred(from), from.primitive, directionWorld);
}

SurfacePoint SceneTracer::nextPoint(const dvec3& fromCentred, std::uint32_t leftOut,
                                    const dvec3& directionWorld) const {
    Ray ray;
    ray.originCentred = fromCentred;
    ray.directionCentred = directionWorld;
    ray.nearest = kContactPerMetre * (1.0 + glm::length(fromCentred));
    return met(ray, leftOut);
}

SurfacePoint SceneTracer::met(const Ray& ray, std::uint32_t leftOut) const {
    return surfacePoint(ray.directionCentred, seenInstead(ray, closest(ray, mayMeet(leftOut)), mayMeet(leftOut)));
}

bool SceneTracer::isBlocked(const Ray& ray, std::uint32_t leftOut, int light) const {
    return any(ray, mayStandIn(leftOut, light)) != kNoPrimitive;
}

SurfacePoint SceneTracer::surfacePoint(const dvec3& directionWorld, const RayHit& hit) const {
    if (!hit) return {};
    const Triangle& t = bvh().triangles[hit.primitive];
    // By the direction, not by where the ray began: that may be too close to the plane to tell.
    return {hit.primitive, glm::dot(glm::cross(t.b - t.a, t.c - t.a), directionWorld) < 0, dvec2(hit.barycentric)};
}

dvec3 SceneTracer::positionCentred(const SurfacePoint& point) const {
    // From the corners, not along the ray: so the point lies in the triangle's plane, however far away the eye is.
    const Triangle& t = bvh().triangles[point.primitive];
    return t.c + point.weights.x * (t.a - t.c) + point.weights.y * (t.b - t.c);
}

bool SceneTracer::facesLight(const SurfacePoint& point, int light) const {
    const std::size_t l = static_cast<std::size_t>(light);
    if (!(lights_[l].gates[point.primitive] & (point.eyeOnFront ? facesFront : facesBack))) return false;
    return scene::shinesEverywhere(snapshot_->lights[l]) ||
           scene::lightShinesTo(snapshot_->lights[l], positionWorld(point));
}

bool SceneTracer::mayFacePartOfLight(const SurfacePoint& point, int light) const {
    const std::size_t l = static_cast<std::size_t>(light);
    if (lights_[l].gates[point.primitive] & inLampPlane) return false;
    return scene::shinesEverywhere(snapshot_->lights[l]) || scene::lightShinesTo(snapshot_->lights[l], positionWorld(point));
}

Ray SceneTracer::shadowRay(const SurfacePoint& point, int light, ShadowStart start) const {
    const scene::Light& source = snapshot_->light(light);
    Ray ray;
    ray.originCentred = positionCentred(point);
    if (start == ShadowStart::naive) ray.originCentred = dvec3(vec3(ray.originCentred));
    if (source.type == scene::LightType::directional) {
        ray.directionCentred = -source.directionWorld;
        ray.nearest = kContactPerMetre * (1.0 + glm::length(ray.originCentred));
    } else {
        ray.directionCentred = (source.positionWorld - world().originWorld) - ray.originCentred;
        ray.nearest = kContact;
        ray.farthest = 1.0; // the light
    }
    if (start == ShadowStart::naive) ray.nearest = 0;
    return ray;
}

std::uint32_t SceneTracer::blocker(const SurfacePoint& point, int light, ShadowStart start) const {
    const std::uint32_t itself = start == ShadowStart::naive ? kNoPrimitive : point.primitive;
    return any(shadowRay(point, light, start), mayBlock(light, itself));
}

bool SceneTracer::isBlockedBy(std::uint32_t primitive, const SurfacePoint& point, int light) const {
    if (!mayBlock(light, point.primitive)(primitive)) return false;
    const Ray ray = shadowRay(point, light, ShadowStart::exact);
    if (!isUsable(ray)) return false;
    const ShearedRay sheared(ray);
    const auto hit = intersect(sheared, bvh().triangles[primitive], sheared.farthest);
    return hit && hit->reach < sheared.farthest && !holesForLight_(primitive, hit->barycentric);
}

std::optional<dvec3> SceneTracer::blockedAtWorld(const SurfacePoint& point, int light) const {
    const Ray ray = shadowRay(point, light, ShadowStart::exact);
    const RayHit hit = closest(ray, mayBlock(light, point.primitive));
    if (!hit) return std::nullopt;
    return world().originWorld + (ray.originCentred + hit.t * ray.directionCentred);
}

// [anchor: point-sees-light]
Visibility SceneTracer::visibility(const SurfacePoint& point, int light, ShadowStart start) const {
    if (!point) return Visibility::noSurface;
    if (!facesLight(point, light)) return Visibility::turnedAway;
    if (!objectOf(point).receivesShadow) return Visibility::lit;
    return blocker(point, light, start) == kNoPrimitive ? Visibility::lit : Visibility::shadowed;
}

} // namespace shadowlab::trace
