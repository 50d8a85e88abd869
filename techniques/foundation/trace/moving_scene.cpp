// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/moving_scene.h"

#include <algorithm>
#include <limits>

namespace shadowlab::trace {

MovingScene::MovingScene(const SceneTracer& tracer, Structure structure) : tracer_(tracer) {
    const std::vector<scene::Object>& objects = tracer.scene().objects;
    const auto isAtRest = [](const scene::Object& object) { return object.velocityWorld == dvec3(0.0); };
    if (std::ranges::all_of(objects, isAtRest)) return;
    const WorldTriangles& world = tracer.world();
    const Triangle nowhere{dvec3(std::numeric_limits<double>::quiet_NaN()), {}, {}};
    for (const scene::Object& object : objects)
        if (std::ranges::find(parts_, object.velocityWorld, &Part::velocityWorld) == parts_.end())
            parts_.push_back({object.velocityWorld, std::vector<Triangle>(world.triangles.size(), nowhere), nullptr});
    for (std::size_t i = 0; i < world.triangles.size(); ++i)
        std::ranges::find(parts_, objects[world.objects[i]].velocityWorld, &Part::velocityWorld)->triangles[i] =
            world.triangles[i];
    for (Part& part : parts_) {
        part.engine = makeEngine(structure, {part.triangles, world.firstOfObject});
        if (!part.engine) part.engine = makeEngine(Structure::bvh, {part.triangles, world.firstOfObject}); // no Embree
    }
}

bool MovingScene::advance(Engine::Deadline deadline) {
    return std::ranges::all_of(parts_, [&](Part& part) { return part.engine->advance(deadline); });
}

double MovingScene::done() const {
    double sum = 0;
    for (const Part& part : parts_)
        sum += part.engine->done();
    return parts_.empty() ? 1.0 : sum / static_cast<double>(parts_.size());
}

SurfacePoint MovingScene::met(const Ray& ray, std::uint32_t leftOut, double time) const {
    if (!moves()) return tracer_.met(ray, leftOut);
    RayHit nearest;
    for (const Part& part : parts_) {
        const RayHit hit = part.engine->closest(movedBack(ray, time * part.velocityWorld), tracer_.mayMeet(leftOut));
        // Equally near: the lowest number, as everywhere.
        if (hit && (!nearest || hit.t < nearest.t || (hit.t == nearest.t && hit.primitive < nearest.primitive)))
            nearest = hit;
    }
    if (!nearest) return {};
    const dvec3 movedWorld = time * tracer_.scene().objects[tracer_.world().objects[nearest.primitive]].velocityWorld;
    return tracer_.surfacePoint(
        ray.directionCentred, tracer_.seenInstead(movedBack(ray, movedWorld), nearest, tracer_.mayMeet(leftOut), time));
}

bool MovingScene::isBlocked(const Ray& ray, std::uint32_t leftOut, double time, int light) const {
    if (!moves()) return tracer_.isBlocked(ray, leftOut, light);
    return std::ranges::any_of(parts_, [&](const Part& part) {
        const dvec3 movedWorld = time * part.velocityWorld;
        const int lamp =
            movedWorld == dvec3(0.0) ? light : SceneTracer::kAnyLight; // what moves leaves the lamp's plane
        return part.engine->any(movedBack(ray, movedWorld), tracer_.mayStandIn(leftOut, lamp)) != kNoPrimitive;
    });
}

} // namespace shadowlab::trace
