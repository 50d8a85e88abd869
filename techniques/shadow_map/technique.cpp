// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/technique.h"

#include "techniques/lights_in_view.h"
#include "techniques/shadow_map/described.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/probe/probe.h"
#include "techniques/shadow_map/stages/frusta.h"

namespace shadowlab::shadow_map {

Progress ShadowMap::prepare(const scene::Snapshot& snapshot, Deadline deadline) {
    const bool ready = (!params_.exact || exact_.prepare(snapshot, deadline)) &&
                       (!params_.aliasFree || aliasFree_.prepare(snapshot, deadline));
    if (!ready) return {.done = 0.5, .converged = false};
    tools_.fitter.prepare(snapshot);
    return {};
}

Progress ShadowMap::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    if (!params_.cull) frame.drawWhatIsOutOfView();
    const auto pass = [&](std::string_view id, int light, const std::function<void()>& draw) {
        frame.pass(passInfo(passes(), id), draw, light);
    };
    pass("lights-off", kNoLight, [&] { gl::drawLightsOff(lightsOff_, scene, frame.buffers(), frame.eye()); });
    if (frame.wants("without-shadows")) lessonStages_.publishWithoutShadows(frame);
    tools_.fitter.fitMaps(frame);
    exact_.beginFrame();
    aliasFree_.beginFrame();

    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        LightShadowMap map{.maps = tools_.fitter.fitted(light), .query = tools_.fitter.query(scene, light)};
        if (params_.aliasFree) {
            pass("samples", light, [&] { map.decided = &aliasFree_.decide(frame, light); });
        } else if (averaged_.averagesOver(scene.light(light))) {
            pass("average", light, [&] { map.decided = &averaged_.average(frame, light); });
        } else if (params_.exact) {
            pass("depth", light, [&] { map = exact_.updateMap(frame, light); });
            if (map.depth) pass("decide", light, [&] { map.decided = &exact_.decide(frame, light, map); });
        } else {
            pass("depth", light, [&] { map = tools_.drawer.updateMap(frame, light); });
            if (map.cached && map.query.filter.usesMoments())
                pass("moments", light, [&] { tools_.drawer.updateMoments(frame, map); });
        }
        publishStages(frame, light, map);
        pass("light", light, [&] {
            if (params_.cull && !mayLight(frame, light)) return;
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setAddLightState();
            tools_.receivers.drawLight(frame, light, map, false);
        });
        if (frame.wants("kernel", light)) filterStages_.publishKernel(frame, light, map);
    }
    return {};
}

void ShadowMap::publishStages(Frame& frame, int light, const LightShadowMap& map) {
    if (frame.wants("visibility", light))
        frame.drawStage("visibility", light, GL_RG32F, [&] {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setVisibilityState();
            tools_.receivers.drawLight(frame, light, map, true);
        });
    if (frame.wants("eye-samples", light)) aliasFree_.publishSamples(frame, light);
    if (frame.wants("traced", light)) exact_.publishTraced(frame, light, map);
    publishTexelStages(tools_, frame, light, map);
    filterStages_.publish(frame, light, map);
    lessonStages_.publish(frame, light, map);
}

bool ShadowMap::samplesArea(const scene::Scene& scene, int light) const {
    const scene::Light& source = scene.light(light);
    // Rays and triangles decide about the light's centre, whatever the filter.
    const bool isFiltered = !params_.exact && !params_.aliasFree;
    const bool hasPenumbra = isFiltered && filterInfo(params_.filter.kind).searchesBlockers && scene::hasArea(source);
    return hasPenumbra || averaged_.averagesOver(source);
}

Probe ShadowMap::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    if (light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    prepare(snapshot, Deadline::max());
    probeShadowMap(probe, {params_, tools_.fitter, averaged_, exact_, aliasFree_, samplesArea(*snapshot, light)},
                   snapshot, view, pixel, light);
    return probe;
}

std::vector<SceneShape> ShadowMap::shapes(const scene::Snapshot& snapshot, const View& view, int light) {
    return frustumShapes(tools_.fitter.fitToView(*snapshot, view, tools_.fitter.query(*snapshot, light)));
}

std::string ShadowMap::remark(const scene::MeshReport& report, const scene::Mesh&) const {
    return std::string("any mesh that can be drawn can be mapped") +
           (report.hasHoles ? ", and so can the holes that an alpha map cuts" : "");
}

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "shadow-map",
        .title = "Shadow map",
        .paper = "Williams 1978, Casting Curved Shadows on Curved Surfaces; Reeves, Salesin and Cook 1987 (PCF)",
        .getsWrong = "shadow edges are as coarse as its texels; contact shadows shrink with the bias",
        .order = 20,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {passes().begin(), passes().end()},
        .stages = {std::begin(kStages), std::end(kStages)},
        .pseudocode = kProcedure,
        .values = {{"d(u,v)", "d(u,v) as it is compared"},
                   {"z(u,v)", "z(u,v) as it is compared, the bias taken off"},
                   {"pixel is shadowed", "if d(u,v) < z(u,v) then pixel is shadowed"},
                   {"(s, t, r)", "(s, t, r) = clip / w / 2 + 1/2"},
                   {"shadowUv", "(s, t, r) = clip / w / 2 + 1/2"},
                   {"lightClip", "point in the light's clip space"},
                   {"referenceDepth", "z(u,v) as it is compared, the bias taken off"}},
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
                   {.title = "Exact map", .settings = "exact=true"},
                   {.title = "Alias-free map", .settings = "alias-free=true"},
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
    }};
    return info;
}

} // namespace shadowlab::shadow_map
