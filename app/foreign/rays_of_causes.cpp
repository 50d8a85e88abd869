// SPDX-License-Identifier: MIT
#include "app/foreign/rays_of_causes.h"

#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"

namespace shadowlab::foreign {

trace::Ray rayToLight(const trace::SceneTracer& tracer, const dvec3& fromCentred, const scene::Light& light) {
    trace::Ray ray;
    ray.originCentred = fromCentred;
    if (light.type == scene::LightType::directional) {
        ray.directionCentred = -light.directionWorld;
        ray.nearest = trace::kContactPerMetre * (1.0 + glm::length(fromCentred));
    } else {
        ray.directionCentred = light.positionWorld - tracer.world().originWorld - fromCentred;
        ray.nearest = trace::kContact;
        ray.farthest = 1.0;
    }
    return ray;
}

trace::Ray rayToLight(const trace::SceneTracer& tracer, const trace::SurfacePoint& from, const scene::Light& light) {
    return rayToLight(tracer, tracer.positionCentred(from), light);
}

double metresPerT(const trace::Ray& ray, const scene::Light& light) {
    return light.type == scene::LightType::directional ? 1.0 : glm::length(ray.directionCentred);
}

std::vector<std::uint8_t> castingTriangles(const Evidence& evidence) {
    const std::span<const std::uint8_t> casts = evidence.tracer.blockers(evidence.light);
    return {casts.begin(), casts.end()};
}

trace::RayHit closestOf(const trace::SceneTracer& tracer, const trace::Ray& ray, const trace::MayHit& mayHit) {
    return tracer.bvh().closest(ray, mayHit, [&](std::uint32_t p, const dvec3& at) { return mayHit.inHole(p, at); });
}

bool isBlockedBy(const trace::SceneTracer& tracer, const trace::Ray& ray, std::uint32_t leftOut, std::span<const std::uint8_t> flags) {
    trace::MayHit mayHit = tracer.mayStandIn(leftOut);
    mayHit.flags = flags.data();
    return tracer.bvh().any(ray, mayHit, [&](std::uint32_t p, const dvec3& at) { return mayHit.inHole(p, at); }) != trace::kNoPrimitive;
}

Predictions withLight(const Evidence& evidence, const scene::Light& light, std::span<const std::uint8_t> casts) {
    const trace::SceneTracer& tracer = evidence.tracer;
    const bool everywhere = scene::shinesEverywhere(light);
    return predictAll(evidence, [&](const Sample& sample) {
        const trace::Ray ray = rayToLight(tracer, sample.point, light);
        if (glm::dot(flatNormalWorld(tracer, sample.point), ray.directionCentred) <= 0) return Prediction::dark;
        if (!everywhere && !scene::lightShinesTo(light, tracer.positionWorld(sample.point))) return Prediction::dark;
        if (!tracer.objectOf(sample.point).receivesShadow) return Prediction::lit;
        return predicted(!isBlockedBy(tracer, ray, sample.point.primitive, casts));
    });
}

std::vector<std::int8_t> sidesOfLight(const trace::SceneTracer& tracer, const scene::Light& light) {
    std::vector<std::int8_t> sides = scene::facingSigns(tracer.scene(), light);
    for (std::size_t i = 0; i < sides.size(); ++i) // stored as in mesh space, where a mirrored object is wound the other way
        if (scene::isMirrored(tracer.scene().objects[tracer.world().objects[i]])) sides[i] = static_cast<std::int8_t>(-sides[i]);
    return sides;
}

std::vector<Crossing> crossings(const trace::SceneTracer& tracer, const trace::Ray& ray, std::uint32_t leftOut,
                                std::span<const std::uint8_t> flags) {
    constexpr int kMost = 256;            // of a ray through the densest of meshes
    constexpr double kRounding = 1e-12;   // of t: the next one is beyond the last
    std::vector<Crossing> found;
    trace::Ray rest = ray;
    trace::MayHit mayHit = tracer.mayStandIn(leftOut);
    mayHit.flags = flags.data();
    for (int i = 0; i < kMost; ++i) {
        const trace::RayHit hit = closestOf(tracer, rest, mayHit);
        if (!hit) break;
        const trace::SurfacePoint point = tracer.surfacePoint(ray.directionCentred, hit);
        found.push_back({hit.primitive, hit.t, point.eyeOnFront});
        rest.nearest = hit.t + kRounding * (1 + std::abs(hit.t));
        if (!(rest.nearest < rest.farthest)) break;
    }
    return found;
}

std::vector<std::uint8_t> closedObjects(const scene::Scene& scene) {
    std::vector<std::uint8_t> closed;
    for (const scene::Object& object : scene.objects)
        closed.push_back(scene::reportMesh(*object.mesh, scene::buildTopology(*object.mesh)).isClosed() ? 1 : 0);
    return closed;
}

} // namespace shadowlab::foreign
