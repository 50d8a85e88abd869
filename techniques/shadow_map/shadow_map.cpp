// Shadow mapping: a picture of depths taken from the light tells whether something stands between the light and a point.
//
// Williams, "Casting Curved Shadows on Curved Surfaces", SIGGRAPH 1978. The cameras are fitted in fit/, the depths are drawn in
// maps/, and the comparison is put together of a bias (bias/) and a filter (filters/).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/maps/averaged_light.h"
#include "techniques/shadow_map/probe/probe.h"
#include "techniques/shadow_map/shared_info.h"
#include "techniques/shadow_map/stages/frusta.h"
#include "techniques/shadow_map/stages/stages.h"

namespace shadowlab::shadow_map {

namespace {

/// The lines that the step `light` shows: finding the place in the map, then what the chosen filter does there.
std::string anchorsOfLight() {
    std::string anchors = "map-place map-visibility";
    for (const FilterInfo& filter : filters())
        for (const std::string_view anchor : filter.anchors)
            if (!anchor.empty()) anchors += " " + std::string(anchor) + "[filter=" + std::string(filter.name) + "]";
    return anchors;
}

std::span<const PassInfo> mapPasses() {
    static const std::string lightAnchors = anchorsOfLight();
    static const PassInfo all[] = {
        kLightsOffPass,
        {.id = "depth",
         .title = "Render the scene from the light and keep the depth",
         .why = "The map stores, for every direction from the light, how far the first surface is: all the light ever "
                "sees. It stays as it is until light, casters or parameters change; the eye may move.",
         .glState = "depth only, depth test LESS, depth clamp, slope-scaled polygon offset",
         .perLight = true,
         .shownBy = "light-depth",
         .pseudocodeLines = {2, 3},
         .formula = kMapFormula,
         .anchors = "draw-map draw-casters"},
        {.id = "moments",
         .title = "Turn the depths into what can be averaged, and average it",
         .why =
             "An average of depths is no depth of anything. Of their powers, or exponentials, it says how the depths "
             "around a texel are spread, and so at most which share of them is behind the point. Only with filter = "
             "vsm, esm, evsm or msm.",
         .glState = "no depth test; two passes over the map, along rows and columns; float colours",
         .perLight = true,
         .shownBy = "moments",
         .formula = "M1 = mean of d, M2 = mean of d^2 over the neighbouring texels\n"
                    "lit share <= (M2 - M1^2) / (M2 - M1^2 + (z - M1)^2)",
         .anchors = "moments-of-a-row"},
        {.id = "average",
         .title = "Draw and ask a map from each of many points of the light",
         .why =
             "A light with an area puts a point into shadow by degrees: as many as cannot be seen of its own points. "
             "Every map answers for one of them, and the mean of the answers is the visible share. Only with "
             "light-samples above 1.",
         .glState = "each map as in depth; visibility added up with blending CONSTANT_COLOR ONE",
         .perLight = true,
         .shownBy = "visibility",
         .formula = "visibility = sum over the points of the light of (answer of its map) / points",
         .anchors = "average-maps"},
        {.id = "light",
         .title = "Render the scene from the eye and compare",
         .why = "Transform each point into the light's coordinates; if the map holds something nearer, the point is in "
                "shadow.",
         .glState = "depth EQUAL, blending ONE ONE, map sampled with comparison LEQUAL",
         .perLight = true,
         .pseudocodeLines = {5, 10},
         .formula = "(s, t, r) = clip / w / 2 + 1/2\n"
                    "z(u,v) = r, shadowed if d(u,v) < z(u,v)",
         .anchors = lightAnchors},
    };
    return all;
}

constexpr StageInfo kMapStages[] = {
    kWithoutShadowsStage,
    kLightViewStage,
    kLightDepthStage,
    kDepthOnViewStage,
    kDistanceOnViewStage,
    kComparisonStage,
    kTexelSizeStageInfo,
    kTexelGridStage,
    kMapLayersStage,
    {"moments", "Moments: how much the depths around each texel vary", StageKind::scalar, true, false, true},
    {"blocker-search", "Blocker search: how far before the point its shadow comes from", StageKind::scalar, true},
    {"penumbra-width", "Penumbra: how wide the shadow's edge is to be", StageKind::scalar, true},
    {"kernel", "Which texels are asked for one pixel, and their answers", StageKind::swatches, true},
    kVisibilityStageInfo,
};

} // namespace

class ShadowMap final : public Technique {
public:
    params::ParamList params() override { return describe(params_); }
    Progress prepare(const scene::Snapshot& snapshot, Deadline) override {
        tools_.fitter.prepare(snapshot);
        return {};
    }
    Progress render(Frame& frame) override;
    [[nodiscard]] bool samplesArea(const scene::Scene& scene, int light) const override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot& snapshot, const View& view, int light) override {
        // With a pixel picked, its rays are seen beside the maps, in colours that cascades have as well.
        return frustumShapes(tools_.fitter.fitToView(*snapshot, view, tools_.fitter.query(*snapshot, light)),
                             view.picked.has_value());
    }
    std::string remark(const scene::MeshReport& report, const scene::Mesh&) const override { return remarkOn(report); }

private:
    [[nodiscard]] ShadingPasses::Depths depthsFor(const scene::Scene& scene) const;

    ShadowMapParams params_;
    MapTools tools_{params_};
    AveragedLight averaged_{tools_};
    LessonStages lessonStages_{tools_};
    FilterStages filterStages_{tools_};
};

Progress ShadowMap::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    if (!params_.cull) frame.drawWhatIsOutOfView();
    const auto pass = [&](std::string_view id, int light, const std::function<void()>& draw) {
        frame.pass(passInfo(mapPasses(), id), draw, light);
    };
    frame.drawFinished();
    pass("lights-off", kNoLight, [&] { tools_.passes.lightsOff(frame, depthsFor(scene)); });
    if (frame.wants("without-shadows")) lessonStages_.publishWithoutShadows(frame);
    tools_.fitter.fitMaps(frame);

    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        LightShadowMap map{.maps = tools_.fitter.fitted(light), .query = tools_.fitter.query(scene, light)};
        if (averaged_.averagesOver(scene.light(light))) {
            pass("average", light, [&] { map.decided = &averaged_.average(frame, light); });
        } else {
            pass("depth", light, [&] { map = tools_.drawer.updateMap(frame, light); });
            if (map.cached && map.query.filter.usesMoments())
                pass("moments", light, [&] { tools_.drawer.updateMoments(frame, map); });
        }
        if (frame.wants(kVisibilityStage, light)) publishVisibility(tools_, frame, light, map);
        publishTexelStages(tools_, frame, light, map);
        filterStages_.publish(frame, light, map);
        lessonStages_.publish(frame, light, map);
        pass("light", light, [&] { addLight(tools_, frame, light, map); });
        if (frame.wants("kernel", light)) filterStages_.publishKernel(frame, light, map);
    }
    return {};
}

/// Only one lookup costs less than drawing depths first, so that no hidden surface looks anything up; an average over the light is made
/// where there are depths.
ShadingPasses::Depths ShadowMap::depthsFor(const scene::Scene& scene) const {
    const FilterInfo& filter = filterInfo(params_.filter.kind);
    const bool isOneLookup = filter.kernel == KernelForm::fourTexels || filter.radiusTexels(params_.filter) == 0;
    const bool averages = std::ranges::any_of(scene.lights, [&](const scene::Light& light) { return averaged_.averagesOver(light); });
    return isOneLookup && !averages ? ShadingPasses::Depths::withLight : ShadingPasses::Depths::first;
}

bool ShadowMap::samplesArea(const scene::Scene& scene, int light) const {
    const scene::Light& source = scene.light(light);
    const bool hasPenumbra = filterInfo(params_.filter.kind).searchesBlockers && scene::hasArea(source);
    return hasPenumbra || averaged_.averagesOver(source);
}

Probe ShadowMap::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    if (light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    prepare(snapshot, Deadline::max());
    probeShadowMap(probe,
                   {.params = params_,
                    .fitter = tools_.fitter,
                    .averaged = &averaged_,
                    .samplesArea = samplesArea(*snapshot, light)},
                   snapshot, view, pixel, light);
    lessonStages_.addPlaces(probe, light, view);
    filterStages_.addPlaces(probe, light, view);
    return probe;
}

TechniqueInfo shadowMapInfo() {
    using enum scene::LightType;
    return {
        .id = "shadow-map",
        .title = "Shadow map",
        .paper = "Williams 1978, Casting Curved Shadows on Curved Surfaces; Reeves, Salesin and Cook 1987 (PCF)",
        .getsWrong = "shadow edges are as coarse as its texels; contact shadows shrink with the bias",
        .order = 20,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {mapPasses().begin(), mapPasses().end()},
        .stages = {std::begin(kMapStages), std::end(kMapStages)},
        .pseudocode = kProcedure,
        .values = {std::begin(kMapValues), std::end(kMapValues)},
        .sweeps = {{.title = "Hard map",
                    .settings = "filter=hard",
                    .varies = "resolution",
                    .values = "256 512 1024 2048 4096",
                    .quick = "512 2048"},
                   {.title = "Percentage-closer filter",
                    .settings = "filter=pcf",
                    .varies = "resolution",
                    .values = "512 1024 2048 4096",
                    .quick = "2048"},
                   {.title = "Variance map",
                    .settings = "filter=vsm",
                    .varies = "resolution",
                    .values = "512 1024 2048",
                    .onlyFull = true},
                   {.title = "Moment map",
                    .settings = "filter=msm",
                    .varies = "resolution",
                    .values = "512 1024 2048",
                    .onlyFull = true},
                   {.title = "Cascades",
                    .settings = "filter=hard",
                    .varies = "cascades",
                    .values = "2 3 4",
                    .quick = "4",
                    .lights = Sweep::Lights::directional},
                   {.title = "Penumbra by blockers",
                    .settings = "filter=pcss",
                    .varies = "samples",
                    .values = "8 16 64",
                    .quick = "16",
                    .lights = Sweep::Lights::withArea},
                   {.title = "Points of the light",
                    .settings = "filter=hard",
                    .varies = "light-samples",
                    .values = "4 16 64",
                    .quick = "16",
                    .lights = Sweep::Lights::withArea}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ShadowMap>(); },
    };
}

} // namespace shadowlab::shadow_map
