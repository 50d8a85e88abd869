// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/probe/triangle_decision.h"

#include <array>

#include "techniques/foundation/base/look.h"
#include "techniques/probe_decision.h"
#include "techniques/shadow_map/irregular/alias_free.h"

namespace shadowlab::shadow_map {

namespace {

trace::SurfacePoint pointOf(const trace::SceneTracer& tracer, const View& view, ivec2 pixel) {
    return tracer.eyePoint(tracer.eyeRays(view.camera, view.size), dvec2(pixel) + 0.5);
}

Decision::Face faceOf(const trace::SceneTracer& tracer, std::uint32_t primitive) {
    const trace::WorldTriangles& world = tracer.world();
    Decision::Face face{tracer.scene().objects[world.objects[primitive]].name, world.triangleInMesh(primitive), {}};
    const trace::Triangle& triangle = world.triangles[primitive];
    face.cornersWorld = {triangle.a + world.originWorld, triangle.b + world.originWorld,
                         triangle.c + world.originWorld};
    return face;
}

} // namespace

void addTriangleDecision(Probe& probe, const TriangleDecision& decision, trace::Visibility truth) {
    addDecider(probe, decision.who);
    addDecision(probe, decision.visibility == trace::Visibility::lit ? 1 : 0, truth,
                "the technique's own rays disagree with the judge's");
    if (decision.blocker) {
        probe.facts.push_back(
            {"blocked by", "triangle " + std::to_string(decision.blocker->triangle) + " of " + decision.blocker->object,
             ""});
        const auto& c = decision.blocker->cornersWorld;
        probe.visited.push_back(
            {"the face that blocks the light", look::kOccluded, SceneShape::Kind::faces, {c[0], c[1], c[2]}});
    }
    probe.decision->blocker = decision.blocker;
}

TriangleDecision decideExactly(const trace::SceneTracer& tracer, const View& view, ivec2 pixel, int light,
                               const std::optional<TexelDepth>& first) {
    const trace::SurfacePoint point = pointOf(tracer, view, pixel);
    if (!point) return {};
    TriangleDecision decision{tracer.visibility(point, light), "a ray: the map is not certain", std::nullopt};
    if (decision.visibility != trace::Visibility::lit && decision.visibility != trace::Visibility::shadowed)
        return {decision.visibility, "the facing gate", std::nullopt};
    if (!tracer.objectOf(point).receivesShadow)
        return {decision.visibility, "nobody: the surface receives no shadows", std::nullopt};
    if (first && !first->isEmpty()) {
        const std::uint32_t primitive = tracer.world().firstOfObject[first->object] + first->triangle;
        if (primitive == point.primitive) decision.who = "a ray; the map's texel holds the point's own triangle";
        if (primitive != point.primitive && tracer.isBlockedBy(primitive, point, light))
            return {trace::Visibility::shadowed, "the map: what its texel holds is before the point, too",
                    faceOf(tracer, primitive)};
    }
    if (decision.visibility == trace::Visibility::shadowed) {
        const std::uint32_t blocker = tracer.blocker(point, light);
        if (blocker != trace::kNoPrimitive) decision.blocker = faceOf(tracer, blocker);
    }
    return decision;
}

TriangleDecision decideAliasFree(const trace::SceneTracer& tracer, const View& view, ivec2 pixel, int light) {
    const std::array point{pointOf(tracer, view, pixel)};
    if (!point[0]) return {};
    std::array<trace::Visibility, 1> answer{};
    aliasFreeVisibilities(tracer, point, light, answer, nullptr, 1);
    TriangleDecision decision{answer[0], "the triangles themselves, tested where the point is in the light's picture",
                              std::nullopt};
    if (answer[0] != trace::Visibility::shadowed) return decision;
    const std::span<const std::uint8_t> blocks = tracer.blockers(light);
    for (std::uint32_t i = 0; i < blocks.size() && !decision.blocker; ++i)
        if (blocks[i] && i != point[0].primitive && tracer.isBlockedBy(i, point[0], light))
            decision.blocker = faceOf(tracer, i);
    return decision;
}

} // namespace shadowlab::shadow_map
