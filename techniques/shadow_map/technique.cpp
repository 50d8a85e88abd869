// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/technique.h"

#include "techniques/foundation/scene/casters.h"
#include "techniques/foundation/trace/exact_visibility.h"
#include "techniques/shadow_map/frusta.h"

namespace shadowlab::shadow_map {

namespace {

const PassInfo kPasses[] = {
    {"lights-off", "Render the scene with all light sources turned off",
     "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     "depth test LESS, depth write on", false},
    {"depth", "Render the scene from the light and keep the depth",
     "The map stores, for every direction from the light, how far the first surface is: all the light ever sees. It "
     "stays as it is until light, casters or parameters change; the eye may move.",
     "depth only, depth test LESS, depth clamp, slope-scaled polygon offset", true, "light-depth"},
    {"light", "Render the scene from the eye and compare",
     "Transform each point into the light's coordinates; if the map holds something nearer, the point is in shadow.",
     "depth EQUAL, blending ONE ONE, map sampled with comparison LEQUAL", true},
};

const StageInfo kStages[] = {
    {"without-shadows", "Image without shadows", StageKind::radiance, false},
    {"light-view", "Image from the light", StageKind::radiance, true},
    {"light-depth", "Depth from the light: the shadow map", StageKind::scalar, true},
    {"depth-on-view", "Light depth d(u,v) projected onto the eye's view", StageKind::scalar, true},
    {"distance-on-view", "Light distance z(u,v) projected onto the eye's view", StageKind::scalar, true},
    {"comparison", "Comparison: d(u,v) against z(u,v)", StageKind::swatches, true},
    {"texel-size", "Aliasing: how many pixels a texel covers", StageKind::scalar, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

constexpr int kMapUnit = gl::kFirstFreeUnit;

// Points are moved toward the light by this share of their distance (for a directional light: of the map's depth)
// before the comparison. It covers the rounding of interpolated float positions, about 2^-21 here, twenty times over,
// and is a thousandth of a texel at most.
constexpr double kRoundingPull = 1e-5;

// Every light keeps its map from frame to frame while all together stay below a quarter of a gigabyte (four bytes a texel).
// Beyond that all lights share one, and it is drawn anew for each.
constexpr double kMostKeptTexels = 64.0 * 1024 * 1024;

} // namespace

params::ParamList ShadowMap::params() {
    return {
        params::integer("resolution", params_.resolution, 64, 8192, "texels",
                        "Side of the square depth map; of each of six when casters surround the light."),
        params::choice("depth-format", params_.depthFormat, {"16", "24", "32f"},
                       "Bits of a depth in the map; 32f: as a floating-point number. The fewer, the larger the offset "
                       "against rounding has to be."),
        params::choice("filter", params_.filter, {"hard", "pcf"},
                       "hard: one comparison a pixel; pcf: the share of a square of comparisons that are lit."),
        params::integer("pcf-radius", params_.pcfRadius, 0, 15, "texels",
                        "PCF averages (2 r + 1) x (2 r + 1) comparisons."),
        params::real(
            "slope-bias", params_.slopeBias, 0, 16, "",
            "Depth offset in proportion to the slope; 1 is what the kernel needs on a plane, 0 shows acne (teaching)."),
        params::real("constant-bias", params_.constantBias, 0, 1000, "",
                     "Depth offset against rounding; 1 is what float positions and the depth's own bits need."),
        params::boolean("cull", params_.cull,
                        "Leave out casters that cannot shadow anything in a map, and what is out of view; the picture "
                        "is the same."),
    };
}

Progress ShadowMap::prepare(const scene::Snapshot& snapshot, Deadline) {
    const std::pair<int, int> size(params_.resolution, params_.kernelRadius());
    if (preparedFor_ == snapshot && preparedSize_ == size) return {};
    prepared_.clear();
    for (const scene::Light& light : snapshot->lights) {
        // The fit always uses the casters that matter, also when all are drawn: another map would be another picture.
        std::vector<std::size_t> useful = scene::usefulCasters(*snapshot, light);
        prepared_.push_back(
            {fitLightMaps(*snapshot, light, useful, params_.resolution, params_.kernelRadius()), useful});
    }
    preparedFor_ = snapshot;
    preparedSize_ = size;
    return {};
}

Progress ShadowMap::render(Frame& frame) {
    choosePrograms();
    const scene::Scene& scene = frame.scene();
    if (!params_.cull) frame.drawWhatIsOutOfView();
    frame.pass(passInfo(kPasses, "lights-off"),
               [&] { gl::drawLightsOff(lightsOff_, scene, frame.buffers(), frame.eye()); });
    if (frame.wants("without-shadows")) publishWithoutShadows(frame);

    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const DrawnMap map = chooseMap(frame, light);
        frame.pass(
            passInfo(kPasses, "depth"), [&] { redrawUnlessKept(frame, light, map); }, light);
        publishStages(frame, light, map);
        frame.pass(
            passInfo(kPasses, "light"),
            [&] {
                glClear(GL_STENCIL_BUFFER_BIT);
                gl::setAddLightState();
                drawReceivers(frame, shade_, light, map);
            },
            light);
    }
    return {};
}

void ShadowMap::choosePrograms() {
    if (chosenFilter_ == params_.filter) return;
    const std::string file = params_.filter == ShadowMapParams::Filter::pcf ? "filter_pcf.glsl" : "filter_hard.glsl";
    const std::vector<gl::Substitution> chosen = {{"shadow_visibility.glsl", "shadow_map/visibility.glsl"},
                                                  {"shadow_map/filter.glsl", "shadow_map/" + file}};
    shade_ = gl::Program("surface.vert", "shade_light.frag", {}, chosen);
    visibility_ = gl::Program("surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}, chosen);
    chosenFilter_ = params_.filter;
}

DrawnMap ShadowMap::chooseMap(Frame& frame, int light) {
    const PreparedLight& prepared = prepared_[static_cast<std::size_t>(light)];
    const std::vector<std::size_t> all = scene::allCasters(frame.scene());
    KeptMap& kept = keptMap(light);
    const GLenum format = params_.glDepthFormat();
    if (kept.depth.side() != params_.resolution || kept.depth.layers() != prepared.maps.layers() ||
        kept.format != format)
        kept = {gl::DepthTextureArray(format, params_.resolution, prepared.maps.layers(), "shadow map"), format,
                std::nullopt};
    const DrawnMap map{prepared.maps, params_.cull ? prepared.usefulCasters : all, &kept.depth};
    frame.count("casters", static_cast<double>(map.casters.size()), static_cast<double>(all.size()), "objects");
    frame.count("map-texels", static_cast<double>(map.maps.layers()) * params_.resolution * params_.resolution, 0,
                "texels");
    return map;
}

KeptMap& ShadowMap::keptMap(int light) {
    double texels = 0;
    for (const PreparedLight& prepared : prepared_)
        texels += static_cast<double>(prepared.maps.layers()) * params_.resolution * params_.resolution;
    const bool oneEach = texels <= kMostKeptTexels;
    maps_.resize(oneEach ? prepared_.size() : 1);
    return maps_[oneEach ? static_cast<std::size_t>(light) : 0];
}

void ShadowMap::redrawUnlessKept(Frame& frame, int light, const DrawnMap& map) {
    KeptMap& kept = keptMap(light);
    const MapOrigin origin{frame.scene().revisions, light, params_, gl::shaderReloads()};
    const bool redraw = kept.drawnFrom != origin;
    if (redraw) drawDepth(frame, map);
    kept.drawnFrom = origin;
    frame.count("maps-redrawn", redraw ? 1 : 0, 1, "maps");
}

void ShadowMap::drawDepth(const Frame& frame, const DrawnMap& map) const {
    glDisable(GL_SCISSOR_TEST); // the map is whole, whatever part of the picture is drawn
    glEnable(GL_DEPTH_CLAMP);   // what stands nearer than the near plane still casts
    glEnable(GL_POLYGON_OFFSET_FILL);
    // The receiver's slope (lookup.glsl) covers its own plane and convex corners. In a concave corner the kernel also meets
    // a steeper neighbour: its depths are pushed back by its slope, one texel for a single comparison and one more for
    // each texel of the kernel's radius.
    glPolygonOffset(static_cast<float>(params_.slopeBias * (1 + params_.kernelRadius())),
                    static_cast<float>(2.0 * params_.constantBias));
    depth_.use();
    for (int layer = 0; layer < map.maps.layers(); ++layer) {
        const gl::Framebuffer framebuffer(*map.depth, layer, "shadow map layer");
        framebuffer.bind();
        glClear(GL_DEPTH_BUFFER_BIT);
        for (const std::size_t caster : map.casters) {
            const scene::Object& object = frame.scene().objects[caster];
            depth_.set("clipFromMesh",
                       mat4(map.maps.lightClipFromLightRelative(layer) * lightRelativeFromMesh(map.maps, object)));
            frame.buffers().mesh(caster).draw(0, static_cast<std::uint32_t>(object.mesh->triangles.size()));
        }
    }
}

void ShadowMap::drawReceivers(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map) const {
    const LightMaps& maps = map.maps;
    program.use();
    gl::setLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    std::vector<mat4> lightClipFromLightRelative;
    for (int layer = 0; layer < maps.layers(); ++layer)
        lightClipFromLightRelative.emplace_back(maps.lightClipFromLightRelative(layer));
    program.set("lightClipFromLightRelative", std::span<const mat4>(lightClipFromLightRelative));
    program.set("mapLayers", maps.layers());
    program.set("pcfRadius", params_.pcfRadius);
    const scene::Light& source = frame.scene().lights[static_cast<std::size_t>(light)];
    const double pull = params_.constantBias * kRoundingPull;
    program.set("pullShare", static_cast<float>(maps.parallel ? 0.0 : pull));
    program.set("pullLightRelative",
                maps.parallel ? vec3(-source.directionWorld * (pull * (maps.farthest - maps.nearest))) : vec3(0));
    program.set("halfTexel", static_cast<float>(params_.slopeBias * 0.5 / params_.resolution));
    program.set("slopeStep", static_cast<float>(0.01 * (maps.farthest - maps.nearest)));
    map.depth->bind(kMapUnit);
    program.set("shadowMap", kMapUnit);
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [&](const scene::Object& object) {
        program.set("lightRelativeFromMesh", mat4(lightRelativeFromMesh(maps, object)));
        return true;
    });
}

Probe ShadowMap::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const auto hit = trace::ExactVisibility(snapshot).eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit || light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    const scene::Light& source = snapshot->lights[static_cast<std::size_t>(light)];
    const LightMaps maps = fitLightMaps(*snapshot, source, scene::usefulCasters(*snapshot, source), params_.resolution,
                                        params_.kernelRadius());
    for (int layer = 0; layer < maps.layers(); ++layer) {
        const dvec4 clip = maps.lightClipFromLightRelative(layer) * dvec4(hit->positionWorld - maps.originWorld, 1.0);
        const dvec3 ndc = dvec3(clip) / clip.w;
        if (clip.w <= 0 || std::abs(ndc.x) > 1 || std::abs(ndc.y) > 1) continue;
        const dvec2 texel = (dvec2(ndc) * 0.5 + 0.5) * static_cast<double>(params_.resolution);
        probe.facts.push_back({"map texel (layer, column, row)",
                               std::to_string(layer) + ", " + std::to_string(static_cast<int>(texel.x)) + ", " +
                                   std::to_string(static_cast<int>(texel.y)),
                               ""});
        probe.facts.push_back({"depth of the point in the map z(u,v)", std::to_string(0.5 * ndc.z + 0.5), ""});
        break;
    }
    return probe;
}

std::vector<SceneShape> ShadowMap::shapes(const scene::Snapshot&, const View&, int light) {
    return frustumShapes(prepared_[static_cast<std::size_t>(light)].maps);
}

std::string ShadowMap::remark(const scene::MeshReport&) const { return "any mesh that can be drawn can be mapped"; }

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
