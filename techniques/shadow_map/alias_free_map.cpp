// The alias-free shadow map: the visible points themselves are tested in the light's picture, and no map is drawn.
//
// Aila and Laine, "Alias-Free Shadow Maps", EGSR 2004. A shadow map knows depths at the centres of its texels and is asked for
// them elsewhere. Here depth is wanted exactly where the eye looks, so there is no texel, no bias and no filter
// (irregular/alias_free.h says how the triangles are tested). It runs on the processor.
// SPDX-License-Identifier: MIT
#include "techniques/exact_judge.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/lights_in_view.h"
#include "techniques/shading_passes.h"
#include "techniques/shadow_map/irregular/alias_free_pass.h"
#include "techniques/shadow_map/probe/triangle_decision.h"
#include "techniques/shadow_map/shared_info.h"

namespace shadowlab::shadow_map {

namespace {

constexpr std::string_view kAliasFreeProcedure = "procedure ALIASFREESHADOWMAPPING\n"
                                                 "  render scene S from the eye's point of view into image A\n"
                                                 "  for each pixel of A do\n"
                                                 "    find its point's place (s,t) and depth r in the light's picture\n"
                                                 "  end for\n"
                                                 "  for each triangle of S do\n"
                                                 "    for each point whose place it covers in the light's picture do\n"
                                                 "      if the triangle's depth at (s,t) < r then\n"
                                                 "        pixel is shadowed\n"
                                                 "      end if\n"
                                                 "    end for\n"
                                                 "  end for";

constexpr PassInfo kAliasFreePasses[] = {
    atLines(kLightsOffPass, {2, 2}),
    {.id = "samples",
     .title = "Test every point that the eye sees in the light's picture",
     .why = "A map is sampled at the centres of its texels, and looked up at other places: all its faults come from "
            "that. Here the visible points themselves are put into the light's picture, and every triangle is tested "
            "against those it covers.",
     .glState = "none: on the processor, and the answers uploaded",
     .perLight = true,
     .shownBy = "eye-samples",
     .pseudocodeLines = {3, 12},
     .formula = "shadowed if a triangle covers (s, t) and is nearer to the light than r",
     .anchors = "samples-in-the-light"},
    atLines(kDecidedLightPass, {9, 9}),
};

constexpr StageInfo kAliasFreeStages[] = {
    {"eye-samples", "Where in the light's picture the eye asks", StageKind::scalar, true},
    kVisibilityStageInfo,
};

constexpr int kVisibilityUnit = gl::kFirstFreeUnit;
const std::vector<gl::Substitution> kReadsDecided{{"shadow_visibility.glsl", "shadow_map/decided.glsl"}};

} // namespace

class AliasFreeMap final : public Technique {
public:
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        if (!samples_.prepare(snapshot, deadline)) return {.done = 0.5, .converged = false};
        return {};
    }
    Progress render(Frame& frame) override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::string remark(const scene::MeshReport& report, const scene::Mesh&) const override { return remarkOn(report); }

private:
    static void drawDecided(const Frame& frame, const gl::Program& program, int light, const gl::Texture2D& visibility,
                            gl::ShadedAs shadedAs);

    AliasFreePass samples_;
    ShadingPasses passes_;
    gl::Program shade_{"surface.vert", "shade_light.frag", {}, kReadsDecided};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}, kReadsDecided};
};

Progress AliasFreeMap::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    const auto pass = [&](std::string_view id, int light, const std::function<void()>& draw) {
        frame.pass(passInfo(kAliasFreePasses, id), draw, light);
    };
    frame.drawFinished();
    pass("lights-off", kNoLight, [&] { passes_.lightsOff(frame, ShadingPasses::Depths::first); });
    samples_.beginFrame();

    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const gl::Texture2D* visibility = nullptr;
        pass("samples", light, [&] { visibility = &samples_.decide(frame, light); });
        if (frame.wants(kVisibilityStage, light))
            frame.drawStage(kVisibilityStage, light, GL_RG32F, [&] {
                glClear(GL_STENCIL_BUFFER_BIT);
                gl::setVisibilityState();
                drawDecided(frame, visibility_, light, *visibility, gl::ShadedAs::radiance);
            });
        if (frame.wants("eye-samples", light)) samples_.publishSamples(frame, light);
        pass("light", light, [&] {
            if (!mayLight(frame, light) && !frame.drawsFinished()) return;
            glClear(GL_STENCIL_BUFFER_BIT);
            drawDecided(frame, shade_, light, *visibility, passes_.beginLight(frame));
        });
    }
    return {};
}

void AliasFreeMap::drawDecided(const Frame& frame, const gl::Program& program, int light,
                               const gl::Texture2D& visibility, gl::ShadedAs shadedAs) {
    gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light, shadedAs);
    visibility.bind(kVisibilityUnit);
    program.set("decided", kVisibilityUnit);
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye());
}

Probe AliasFreeMap::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    if (light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    const auto judge = exactJudge(snapshot);
    const auto hit = judge->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit) return probe;
    prepare(snapshot, Deadline::max());
    addTriangleDecision(probe, decideAliasFree(samples_.tracer(), view, pixel, light),
                        judge->visibility(*hit, view.camera, light));
    return probe;
}

TechniqueInfo aliasFreeMapInfo() {
    using enum scene::LightType;
    return {
        .id = "shadow-map-alias-free",
        .title = "Alias-free shadow map",
        .paper = "Aila and Laine 2004, Alias-Free Shadow Maps",
        .getsWrong = "soft shadows (a light is a point)",
        .order = 90,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kAliasFreePasses), std::end(kAliasFreePasses)},
        .stages = {std::begin(kAliasFreeStages), std::end(kAliasFreeStages)},
        .pseudocode = kAliasFreeProcedure,
        .sweeps = {{.title = "Alias-free map"}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<AliasFreeMap>(); },
    };
}

} // namespace shadowlab::shadow_map
