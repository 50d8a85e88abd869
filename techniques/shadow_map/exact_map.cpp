// The exact shadow map: the map decides the pixels for which it is certain, and rays decide the others.
//
// The map and its cameras are those of the shadow map. Beside its depths it keeps which triangle each texel sees, and which
// texels are touched by an edge: from these the shader decides whether the texel's answer is true of the pixel's point as well
// (exact/exact_pass.h says how). No bias and no filter is needed, because no depth is compared where the answer might be wrong.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/exact/exact_light.h"
#include "techniques/shadow_map/probe/probe.h"
#include "techniques/shadow_map/shared_info.h"
#include "techniques/shadow_map/stages/frusta.h"
#include "techniques/shadow_map/stages/stages.h"

namespace shadowlab::shadow_map {

namespace {

constexpr PassInfo kExactPasses[] = {
    kLightsOffPass,
    {.id = "depth",
     .title = "Render the scene from the light and keep depths, triangles and edges",
     .why =
         "The map stores, for every direction from the light, how far the first surface is and which triangle it is. "
         "A second map marks the texels that an edge touches: there the surface may end within the texel.",
     .glState = "depth test LESS, depth clamp, triangle numbers as colours; then the edges, as wide as a texel",
     .perLight = true,
     .shownBy = "light-depth",
     .pseudocodeLines = {2, 3},
     .formula = kMapFormula,
     .anchors = "draw-casters triangle-number"},
    {.id = "decide",
     .title = "Decide where the map is certain, and send rays elsewhere",
     .why = "An edge that touches a texel makes it uncertain: a surface ends there, begins, or passes through another. "
            "All other texels know which surface is the first; the point is lit if it lies on that.",
     .glState = "depth EQUAL; triangle numbers and depths read with texelFetch; undecided pixels read back",
     .perLight = true,
     .shownBy = "traced",
     .pseudocodeLines = {5, 7},
     .anchors = "decide-by-map"},
    kDecidedLightPass,
};

constexpr StageInfo kExactStages[] = {
    kWithoutShadowsStage, kLightViewStage,
    kLightDepthStage,     kDepthOnViewStage,
    kDistanceOnViewStage, kComparisonStage,
    kTexelSizeStageInfo,  kTexelGridStage,
    kMapLayersStage,      {"traced", "What the map decides for certain, and what rays do", StageKind::swatches, true},
    kVisibilityStageInfo,
};

} // namespace

class ExactMap final : public Technique {
public:
    params::ParamList params() override { return describeExact(params_); }
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        if (!exact_.prepare(snapshot, deadline)) return {.done = 0.5, .converged = false};
        tools_.fitter.prepare(snapshot);
        return {};
    }
    Progress render(Frame& frame) override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot& snapshot, const View& view, int light) override {
        // With a pixel picked, its rays are seen beside the maps, in colours that cascades have as well.
        return frustumShapes(tools_.fitter.fitToView(*snapshot, view, tools_.fitter.query(*snapshot, light)),
                             view.picked.has_value());
    }
    std::string remark(const scene::MeshReport& report, const scene::Mesh&) const override { return remarkOn(report); }

private:
    ShadowMapParams params_ = exactMapParams();
    MapTools tools_{params_};
    ExactLight exact_{tools_};
    LessonStages lessonStages_{tools_};
};

Progress ExactMap::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    if (!params_.cull) frame.drawWhatIsOutOfView();
    const auto pass = [&](std::string_view id, int light, const std::function<void()>& draw) {
        frame.pass(passInfo(kExactPasses, id), draw, light);
    };
    frame.drawFinished();
    pass("lights-off", kNoLight, [&] { tools_.passes.lightsOff(frame, ShadingPasses::Depths::first); });
    if (frame.wants("without-shadows")) lessonStages_.publishWithoutShadows(frame);
    tools_.fitter.fitMaps(frame);
    exact_.beginFrame();

    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        LightShadowMap map;
        pass("depth", light, [&] { map = exact_.updateMap(frame, light); });
        if (map.depth) pass("decide", light, [&] { map.decided = &exact_.decide(frame, light, map); });
        if (frame.wants(kVisibilityStage, light)) publishVisibility(tools_, frame, light, map);
        if (frame.wants("traced", light)) exact_.publishTraced(frame, light, map);
        publishTexelStages(tools_, frame, light, map);
        lessonStages_.publish(frame, light, map);
        pass("light", light, [&] { addLight(tools_, frame, light, map); });
    }
    return {};
}

Probe ExactMap::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    if (light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    prepare(snapshot, Deadline::max());
    probeShadowMap(probe, {.params = params_, .fitter = tools_.fitter, .rays = &exact_.tracer()}, snapshot, view, pixel,
                   light);
    lessonStages_.addPlaces(probe, light, view);
    return probe;
}

TechniqueInfo exactMapInfo() {
    using enum scene::LightType;
    return {
        .id = "shadow-map-exact",
        .title = "Exact shadow map",
        .paper = "Hertel, Hormann and Westermann 2009, A Hybrid GPU Rendering Pipeline for Alias-Free Hard Shadows",
        .getsWrong = "soft shadows (a light is a point)",
        .order = 80,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kExactPasses), std::end(kExactPasses)},
        .stages = {std::begin(kExactStages), std::end(kExactStages)},
        .pseudocode = kProcedure,
        .values = {std::begin(kMapValues), std::end(kMapValues)},
        .sweeps = {{.title = "Exact map"}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ExactMap>(); },
    };
}

} // namespace shadowlab::shadow_map
