// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/technique.h"

#include "techniques/foundation/scene/query/casters.h"
#include "techniques/lights_in_view.h"
#include "techniques/shadow_map/described.h"
#include "techniques/shadow_map/filters/filter_uniforms.h"
#include "techniques/shadow_map/fit/frusta.h"

namespace shadowlab::shadow_map {

Progress ShadowMap::prepare(const scene::Snapshot& snapshot, Deadline deadline) {
    const bool ready = (!params_.exact || exact_.prepare(snapshot, deadline)) &&
                       (!params_.aliasFree || aliasFree_.prepare(snapshot, deadline));
    if (!ready) return {.done = 0.5, .converged = false};
    if (preparedFor_ == snapshot) return {};
    bounds_ = scene::objectBounds(*snapshot);
    usefulCasters_.clear();
    for (const scene::Light& light : snapshot->lights)
        usefulCasters_.push_back(scene::usefulCasters(*snapshot, light, bounds_));
    preparedFor_ = snapshot;
    seen_.reset();
    return {};
}

Progress ShadowMap::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    if (!params_.cull) frame.drawWhatIsOutOfView();
    frame.pass(passInfo(kPasses, "lights-off"),
               [&] { gl::drawLightsOff(lightsOff_, scene, frame.buffers(), frame.eye()); });
    if (frame.wants("without-shadows")) publishWithoutShadows(frame);
    lookAt(frame);
    exact_.beginFrame();
    aliasFree_.beginFrame();

    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        DrawnMap map{.maps = fitted_[static_cast<std::size_t>(light)], .asked = asked(scene, light)};
        if (params_.aliasFree) {
            frame.pass(
                passInfo(kPasses, "samples"), [&] { map.decided = &aliasFree_.decide(frame, light); }, light);
        } else if (averagesOver(scene.light(light))) {
            frame.pass(
                passInfo(kPasses, "average"), [&] { map.decided = &averageOverLight(frame, light); }, light);
        } else {
            frame.pass(
                passInfo(kPasses, "depth"), [&] { map = updateMap(frame, light); }, light);
            if (map.kept && map.asked.filter.usesMoments())
                frame.pass(
                    passInfo(kPasses, "moments"), [&] { map.moments = &updateMoments(frame, *map.kept, map.maps); },
                    light);
            if (params_.exact && map.depth)
                frame.pass(
                    passInfo(kPasses, "decide"), [&] { map.decided = &decide(frame, light, map); }, light);
        }
        publishStages(frame, light, map);
        frame.pass(
            passInfo(kPasses, "light"),
            [&] {
                if (params_.cull && !mayLight(frame, light)) return;
                glClear(GL_STENCIL_BUFFER_BIT);
                gl::setAddLightState();
                drawAsked(frame, lightProgram(map, false), unshadowed_, light, map);
            },
            light);
        if (frame.wants("kernel", light)) publishKernel(frame, light, map);
    }
    return {};
}

ShadowMap::Programs ShadowMap::makePrograms(const Choice& choice) {
    static constexpr const char* layers[] = {"layer_one", "layer_cube", "layer_cascades"};
    static constexpr const char* biases[] = {"bias_none",          "bias_constant",       "bias_slope_scaled",
                                             "bias_normal_offset", "bias_receiver_plane", "bias_dual_depth",
                                             "bias_adaptive"};
    static constexpr const char* filters[] = {"filter_hard", "filter_hw2x2", "filter_pcf",
                                              "filter_disc", "filter_pcss",  "filter_vsm",
                                              "filter_esm",  "filter_evsm",  "filter_msm"};
    const auto file = [](const char* name) { return std::string("shadow_map/") + name + ".glsl"; };
    const bool isOneInWorld = choice.inWorld && choice.layout == Layout::one;
    const std::vector<gl::Substitution> chosen = {
        {"shadow_visibility.glsl", "shadow_map/visibility.glsl"},
        {"shadow_map/point.glsl", file(choice.inWorld ? "point_world" : "point_light")},
        {"shadow_map/layer.glsl", file(isOneInWorld ? "layer_one_world" : layers[static_cast<int>(choice.layout)])},
        {"shadow_map/bias.glsl", file(biases[static_cast<int>(choice.bias)])},
        {"shadow_map/filter.glsl", file(filters[static_cast<int>(choice.filter)])}};
    std::vector<std::string> defines;
    if (comparesWithOneDepth(choice.bias)) defines.emplace_back("ONE_DEPTH");
    std::vector<std::string> visibilityDefines = defines;
    visibilityDefines.emplace_back("VISIBILITY_ONLY");
    return {gl::Program("surface.vert", "shade_light.frag", defines, chosen),
            gl::Program("surface.vert", "shade_light.frag", visibilityDefines, chosen),
            gl::Program("surface.vert", "shadow_map/project.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/texel_size.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/layers.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/penumbra.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/kernel.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/decide.frag", {},
                        {chosen[1], chosen[2], {"shadow_map/bias.glsl", "shadow_map/bias_none.glsl"}})};
}

const ShadowMap::Programs& ShadowMap::programsFor(const DrawnMap& map) {
    const Choice choice{map.maps.layout, params_.bias.mode, map.asked.filter.kind, params_.looksUpInWorld()};
    const auto known = programs_.find(choice);
    return known != programs_.end() ? known->second : programs_.emplace(choice, makePrograms(choice)).first->second;
}

std::vector<SceneShape> ShadowMap::shapes(const scene::Snapshot& snapshot, const View& view, int light) {
    return frustumShapes(
        fit(*snapshot, view, asked(*snapshot, light), receiversInView(*snapshot, view), FitRequest::Cover::needed));
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
        .passes = {std::begin(kPasses), std::end(kPasses)},
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
