// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/technique.h"

#include <set>

#include "techniques/foundation/scene/casters.h"
#include "techniques/foundation/scene/depth_fit.h"
#include "techniques/foundation/scene/visible_receivers.h"
#include "techniques/shadow_map/filter_uniforms.h"
#include "techniques/shadow_map/frusta.h"
#include "techniques/shadow_map/seen_depth.h"

namespace shadowlab::shadow_map {

namespace {

const PassInfo kPasses[] = {
    {"lights-off", "Render the scene with all light sources turned off",
     "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     "depth test LESS, depth write on", false},
    {"depth", "Render the scene from the light and keep the depth",
     "The map stores, for every direction from the light, how far the first surface is: all the light ever sees. It "
     "stays as it is until light, casters or parameters change; the eye may move.",
     "depth only, depth test LESS, depth clamp, slope-scaled polygon offset", true, "light-depth",
     "render z-buffer from light's point of view to depth map D\nstore D as texture map d(u,v)"},
    {"samples", "Ask the light for every point that the eye sees",
     "A map asks the light at the middles of its texels, and the eye at other places: all its faults come from that. "
     "Here the visible points themselves are put into the light's picture, and every triangle is tested against those "
     "it covers. Only with alias-free = true.",
     "none: on the processor, and the answers uploaded", true, "eye-samples"},
    {"decide", "Decide where the map is certain, and send rays elsewhere",
     "An edge that touches a texel makes it uncertain: a surface ends there, begins, or passes through another. All "
     "other texels know which surface is the first; the point is lit if it lies on that. Only with exact = true.",
     "depth EQUAL; triangle numbers and depths read with texelFetch; undecided pixels read back", true, "traced"},
    {"light",
     "Render the scene from the eye and compare",
     "Transform each point into the light's coordinates; if the map holds something nearer, the point is in shadow.",
     "depth EQUAL, blending ONE ONE, map sampled with comparison LEQUAL",
     true,
     {},
     "for each rasterized pixel with texture coords (u,v) and transformed distance z(u,v) do\n"
     "   if d(u,v) < z(u,v) then\n      pixel is shadowed"},
};

const StageInfo kStages[] = {
    {"without-shadows", "Image without shadows", StageKind::radiance, false},
    {"light-view", "Image from the light", StageKind::radiance, true},
    {"light-depth", "Depth from the light: the shadow map", StageKind::scalar, true},
    {"depth-on-view", "Light depth d(u,v) projected onto the eye's view", StageKind::scalar, true},
    {"distance-on-view", "Light distance z(u,v) projected onto the eye's view", StageKind::scalar, true},
    {"comparison", "Comparison: d(u,v) against z(u,v)", StageKind::swatches, true},
    {"texel-size", "Aliasing: how many pixels a texel covers", StageKind::scalar, true},
    {"texel-grid", "The texels as they lie on what the eye sees", StageKind::swatches, true},
    {"map-layers", "Which map answers: cascades, or those around the light", StageKind::swatches, true},
    {"eye-samples", "Where in the light's picture the eye asks", StageKind::scalar, true},
    {"traced", "What the map decides for certain, and what rays do", StageKind::swatches, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

// Boxes around what is in view: more would make a fit slow, and hardly closer.
constexpr std::size_t kMostReceivers = 64;

} // namespace

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
        DrawnMap map;
        if (params_.aliasFree) {
            frame.pass(
                passInfo(kPasses, "samples"), [&] { map.decided = &aliasFree_.decide(frame, light); }, light);
        } else {
            frame.pass(
                passInfo(kPasses, "depth"), [&] { map = updateMap(frame, light); }, light);
            if (params_.exact && map.depth)
                frame.pass(
                    passInfo(kPasses, "decide"), [&] { map.decided = &decide(frame, light, map); }, light);
        }
        publishStages(frame, light, map);
        frame.pass(
            passInfo(kPasses, "light"),
            [&] {
                glClear(GL_STENCIL_BUFFER_BIT);
                gl::setAddLightState();
                drawAsked(frame, lightProgram(map, false), unshadowed_, light, map);
            },
            light);
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
    const std::vector<gl::Substitution> chosen = {
        {"shadow_visibility.glsl", "shadow_map/visibility.glsl"},
        {"shadow_map/layer.glsl", file(layers[static_cast<int>(choice.layout)])},
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
            gl::Program("surface.vert", "shadow_map/decide.frag", {},
                        {chosen[1], {"shadow_map/bias.glsl", "shadow_map/bias_none.glsl"}})};
}

const ShadowMap::Programs& ShadowMap::programsFor(const LightMaps& maps) {
    const Choice choice{maps.layout, params_.bias.mode, params_.filter.kind};
    const auto known = programs_.find(choice);
    return known != programs_.end() ? known->second : programs_.emplace(choice, makePrograms(choice)).first->second;
}

std::vector<scene::Bounds> ShadowMap::receiversInView(const scene::Scene& scene, const View& view) const {
    if (params_.projection.fit == ProjectionParams::Fit::scene) return bounds_;
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    return scene::visibleReceivers(scene, bounds_, eye.clipFromView * eye.viewFromWorld, scene::PicturePart{},
                                   kMostReceivers);
}

LightMaps ShadowMap::fit(const scene::Scene& scene, const View& view, int light,
                         std::span<const scene::Bounds> receivers, FitRequest::Cover cover) const {
    const auto index = static_cast<std::size_t>(light);
    // The fit always uses the casters that matter, also when all are drawn: another map would be another picture. Without
    // any there is no map, unless nothing is to be left out.
    const std::vector<std::size_t>& useful = usefulCasters_[index];
    std::vector<scene::Bounds> casters;
    for (const std::size_t caster : useful.empty() && !params_.cull ? scene::allCasters(scene) : useful)
        casters.push_back(bounds_[caster]);
    const double aspect = static_cast<double>(view.size.x) / view.size.y;
    FitEye eye{scene::withTightNear(view.camera, scene, bounds_, aspect), aspect, std::nullopt};
    if (seen_ && seen_->camera == view.camera && seen_->size == view.size) eye.visibleDepth = seen_->range;
    ProjectionParams projection = params_.projection;
    if (params_.exact)
        projection.depthRange = ProjectionParams::DepthRange::fitted; // teaching faults have no place there
    const FilterParams& filter = params_.filter;
    const bool filtered =
        !params_.exact && (filter.kind != FilterParams::Kind::pcss || hasPenumbra(scene.lights[index], filter));
    return fitLightMaps({scene.lights[index], bounds_, casters, receivers, eye, projection, params_.resolution,
                         filtered ? filter.kernelRadius(params_.resolution) : 0,
                         filter.usesDistances() && !params_.exact, cover});
}

/// Fits the maps of all lights to what the eye sees.
void ShadowMap::lookAt(const Frame& frame) {
    const View& view = frame.view();
    const bool cascades =
        params_.projection.cascades > 1 && params_.projection.depthBounds == ProjectionParams::DepthBounds::picture;
    seen_.reset();
    if (cascades)
        if (const std::optional<dvec2> range = visibleDepthRange(frame)) seen_ = {view.camera, view.size, *range};
    const std::vector<scene::Bounds> receivers = receiversInView(frame.scene(), view);
    fitted_.clear();
    for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
        fitted_.push_back(fit(frame.scene(), view, light, receivers, FitRequest::Cover::needed));
}

std::vector<std::size_t> ShadowMap::castersOf(const scene::Scene& scene, const LightMaps& maps, int light,
                                              int layer) const {
    if (!params_.cull) return scene::allCasters(scene);
    // Beside the edge of a shadow moments are of the caster and of what it shadows: that has to be in the map, even if
    // it shadows nothing itself.
    const bool receiversToo = params_.filter.usesMoments() && !params_.exact;
    std::vector<std::size_t> casters;
    for (const std::size_t caster :
         receiversToo ? scene::allCasters(scene) : usefulCasters_[static_cast<std::size_t>(light)])
        if (mayDrawInto(maps, layer, bounds_[caster])) casters.push_back(caster);
    return casters;
}

/// Draws those of the light's layers that are not what they should be.
DrawnMap ShadowMap::updateMap(Frame& frame, int light) {
    const scene::Scene& scene = frame.scene();
    const LightMaps& maps = fitted_[static_cast<std::size_t>(light)];
    frame.count("lights-with-map", maps.layers() > 0 ? 1 : 0, 1, "lights");
    const double allCasters = static_cast<double>(scene::allCasters(scene).size());
    if (maps.layers() == 0) {
        frame.count("casters", 0, allCasters, "objects");
        return {.maps = maps};
    }
    const double layerTexels = static_cast<double>(params_.resolution) * params_.resolution;
    double allTexels = 0;
    for (const LightMaps& fitted : fitted_)
        allTexels += layerTexels * fitted.layers();
    const GLenum format = params_.glDepthFormat();
    KeptMap& kept = kept_.of(light, fitted_.size(), allTexels, maps, params_.resolution, format, params_.exact);
    kept.depth.clampToEdge(params_.border == ShadowMapParams::Border::edge);

    std::set<std::size_t> drawn; // in any layer
    for (int layer = 0; layer < maps.layers(); ++layer) {
        const LayerOrigin origin{scene.revisions.geometry,
                                 scene.revisions.transforms,
                                 scene.revisions.materials,
                                 maps.originWorld,
                                 maps.lightClipFromLightRelative(layer),
                                 castersOf(scene, maps, light, layer),
                                 depthRules(params_),
                                 gl::shaderReloads()};
        std::optional<LayerOrigin>& drawnFrom = kept.drawnFrom[static_cast<std::size_t>(layer)];
        const bool redraw = drawnFrom != origin;
        if (redraw && params_.exact) {
            drawExact(frame, light, maps, layer, origin.casters, kept.depth, *kept.exact);
        } else if (redraw) {
            depthPass_.draw(frame, maps, layer, origin.casters, kept.depth, format, origin.rules);
        }
        if (redraw) kept.momentsFor.reset();
        drawnFrom = origin;
        drawn.insert(origin.casters.begin(), origin.casters.end());
        frame.count("maps-redrawn", redraw ? 1 : 0, 1, "maps");
        frame.count("caster-draws", static_cast<double>(origin.casters.size()), allCasters, "objects, each per map");
    }
    if (params_.filter.usesMoments() && !params_.exact) updateMoments(frame, kept, maps);
    frame.count("casters", static_cast<double>(drawn.size()), allCasters, "objects");
    frame.count("map-texels", layerTexels * maps.layers(), 0, "texels");
    return {.maps = maps,
            .depth = &kept.depth,
            .exact = params_.exact ? &*kept.exact : nullptr,
            .moments = params_.filter.usesMoments() && !params_.exact ? &*kept.moments : nullptr};
}

/// Makes the moments of a light's maps if these, or what is asked of them, changed.
void ShadowMap::updateMoments(Frame& frame, KeptMap& kept, const LightMaps& maps) {
    const bool make = kept.momentsFor != params_.filter;
    frame.count("moments-made", make ? maps.layers() : 0, maps.layers(), "maps");
    if (!make) return;
    kept.moments.reset(); // first, so that both are never there at once
    kept.moments = emptyMoments(params_.filter, params_.resolution, maps.layers());
    momentMaker_.make(kept.depth, maps, params_.filter, *kept.moments);
    kept.momentsFor = params_.filter;
}

std::vector<SceneShape> ShadowMap::shapes(const scene::Snapshot& snapshot, const View& view, int light) {
    return frustumShapes(fit(*snapshot, view, light, receiversInView(*snapshot, view), FitRequest::Cover::needed));
}

std::string ShadowMap::remark(const scene::MeshReport& report) const {
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
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ShadowMap>(); },
    }};
    return info;
}

} // namespace shadowlab::shadow_map
