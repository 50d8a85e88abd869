// The pictures of the lecture's walk through shadow mapping, in its order.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/shadow_map/maps/sheet.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

namespace {

// Modes of shaders/shadow_map/project.frag.
constexpr int kMapDepth = 0, kPointDistance = 1, kComparison = 2;

} // namespace

void ShadowMap::publishStages(Frame& frame, int light, const DrawnMap& map) {
    if (frame.wants("visibility", light))
        frame.drawStage("visibility", light, GL_RG32F, [&] {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setVisibilityState();
            drawAsked(frame, lightProgram(map, true), unshadowedVisibility_, light, map);
        });
    if (frame.wants("eye-samples", light)) aliasFree_.publishSamples(frame, light);
    if (frame.wants("traced", light)) publishTraced(frame, light, map);
    publishTexelStages(frame, light, map);
    publishFilterStages(frame, light, map);
    const std::string_view lessons[] = {"light-view", "light-depth", "depth-on-view", "distance-on-view", "comparison"};
    if (std::ranges::none_of(lessons, [&](std::string_view stage) { return frame.wants(stage, light); })) return;
    gl::DepthTextureArray depth;
    const DrawnMap lesson = lessonMap(frame, light, map, depth);
    const Display range = distanceRange(frame, light, lesson);
    if (frame.wants("light-view", light)) publishLightView(frame, light, lesson);
    if (frame.wants("light-depth", light)) publishLightDepth(frame, light, lesson, range);
    publishProjected(frame, light, lesson, range);
}

// The map that is used is cut close around what casters and receivers share, and a floor that shadows nothing is not in it.
// The map that is shown covers what the eye sees, and every caster: the lesson is the same, and the floor has a depth.
DrawnMap ShadowMap::lessonMap(const Frame& frame, int light, const DrawnMap& map, gl::DepthTextureArray& depth) {
    std::vector<double> seen[3];
    for (const vec4& texel : projectedTexels(frame, light, map, kProjectedPosition))
        if (texel.a > 0.5f)
            for (int axis = 0; axis < 3; ++axis)
                seen[axis].push_back(texel[axis]);
    scene::Bounds region;
    if (!seen[0].empty()) {
        // Without the outermost fiftieth: a horizon would make everything near tiny.
        dvec3 lower(0.0), upper(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            std::ranges::sort(seen[axis]);
            const std::size_t cut = seen[axis].size() / 50;
            lower[axis] = seen[axis][cut];
            upper[axis] = seen[axis][seen[axis].size() - 1 - cut];
        }
        region.include(map.maps.originWorld + lower);
        region.include(map.maps.originWorld + upper);
    }
    const std::vector<scene::Bounds> receivers = region.isEmpty() ? bounds_ : std::vector{region};
    DrawnMap lesson{.maps = fit(frame.scene(), frame.view(), map.asked, receivers, FitRequest::Cover::shown),
                    .asked = map.asked,
                    .depth = &depth};
    const GLenum format = params_.glDepthFormat();
    depth = gl::DepthTextureArray(format, params_.resolution, lesson.maps.layers(), "shadow map shown");
    const std::vector<std::size_t> casters = scene::allCasters(frame.scene());
    ShadowMapParams compared = params_;
    compared.exact = false; // the lesson is the comparison
    const DepthRules rules = depthRules(compared, map.asked.filter);
    for (int layer = 0; layer < lesson.maps.layers(); ++layer) {
        gl::setBaselineState();
        depthPass_.draw(frame, lesson.maps, layer, casters, depth, format, rules);
    }
    return lesson;
}

void ShadowMap::publishWithoutShadows(Frame& frame) const {
    frame.drawOverTarget("without-shadows", kNoLight, false, [&] {
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setAddLightState();
            gl::useForLight(unshadowed_, frame.scene(), frame.buffers(), frame.eye(), light);
            gl::drawSurfaces(unshadowed_, frame.scene(), frame.buffers(), frame.eye());
        }
    });
}

void ShadowMap::publishLightView(Frame& frame, int light, const DrawnMap& map) const {
    const LightMaps& maps = map.maps;
    const Sheet sheet(maps, frame.view().size);
    // A flame around its light blocks nothing, and would hide everything from the light's eye.
    const auto isSeen = [&](const scene::Object& object) {
        const scene::Bounds bounds = scene::boundsWorld(object);
        const bool around = glm::all(glm::lessThan(bounds.lowerWorld, maps.originWorld)) &&
                            glm::all(glm::greaterThan(bounds.upperWorld, maps.originWorld));
        return object.castsShadow || maps.parallel || !around;
    };
    gl::Target target(sheet.size(), "light-view");
    gl::setBaselineState();
    target.framebuffer.bind();
    for (int layer = 0; layer < maps.layers(); ++layer) {
        // The light is the eye: its camera stands at the light-relative origin.
        gl::EyeMatrices lightEye;
        const auto l = static_cast<std::size_t>(layer);
        dmat4 lightRelativeFromWorld(1.0);
        lightRelativeFromWorld[3] = dvec4(-maps.originWorld, 1.0);
        lightEye.viewFromWorld = maps.lightViewFromLightRelative[l] * lightRelativeFromWorld;
        lightEye.clipFromView = maps.lightClipFromLightView[l];
        gl::setBaselineState();
        glEnable(GL_DEPTH_CLAMP);
        sheet.setViewport(layer);
        gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), lightEye, isSeen);
        gl::setAddLightState();
        gl::useForLight(unshadowed_, frame.scene(), frame.buffers(), lightEye, light);
        gl::drawSurfaces(unshadowed_, frame.scene(), frame.buffers(), lightEye, isSeen);
    }
    frame.publish("light-view", light, std::move(target.color));
}

void ShadowMap::publishLightDepth(Frame& frame, int light, const DrawnMap& map, const Display& range) const {
    const LightMaps& maps = map.maps;
    const Sheet sheet(maps, frame.view().size);
    gl::Texture2D picture(GL_RG32F, sheet.size(), "light-depth");
    const gl::Framebuffer framebuffer(&picture, nullptr, "light-depth");
    gl::setBaselineState();
    glDisable(GL_DEPTH_TEST);
    framebuffer.bind();
    map.depth->sample(gl::DepthSampling::depths);
    showDepth_.use();
    map.depth->bind(kMapUnit);
    showDepth_.set("shadowMap", kMapUnit);
    setReceiverUniforms(showDepth_, maps, params_, map.asked.filter);
    showDepth_.set("cellSize", sheet.cellSize);
    for (int layer = 0; layer < maps.layers(); ++layer) {
        sheet.setViewport(layer);
        showDepth_.set("layer", layer);
        gl::drawFullscreenTriangle();
    }
    Display display = range;
    if (maps.layout == Layout::cube) display.unit += "; above +x +y +z, below -x -y -z";
    if (maps.layout == Layout::cascades) display.unit += "; cascades, the nearest first";
    frame.publish("light-depth", light, std::move(picture), display);
}

void ShadowMap::drawProjected(const Frame& frame, int light, const DrawnMap& map, int mode) {
    glDepthFunc(GL_EQUAL);
    // Positions can be asked for before there is a map; the sampler wants a texture all the same.
    const gl::DepthTextureArray none =
        map.depth ? gl::DepthTextureArray() : gl::DepthTextureArray(GL_DEPTH_COMPONENT24, 1, 1, "no shadow map");
    const gl::DepthTextureArray& depth = map.depth ? *map.depth : none;
    depth.sample(gl::DepthSampling::depths);
    depth.bind(kMapUnit);
    const gl::Program& project = programsFor(map).project;
    drawReceivers(frame, project, light, map, [&] {
        project.set("mode", mode);
        project.set("equalColor", look::kEqualDepth);
        project.set("occludedColor", look::kOccluded);
        project.set("nothingStoredColor", look::kNothingStored);
        project.set("notAskedColor", look::kNotAsked);
    });
}

std::vector<vec4> ShadowMap::projectedTexels(const Frame& frame, int light, const DrawnMap& map, int mode) {
    gl::Texture2D texture(GL_RGBA32F, frame.target().size(), "projected texels");
    const gl::Framebuffer framebuffer(&texture, &frame.target().depthStencil, "projected texels");
    gl::setBaselineState();
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    drawProjected(frame, light, map, mode);
    return gl::readTexels(texture);
}

// One scale for all pictures of depth, so that they can be compared: the distances of what the eye sees.
Display ShadowMap::distanceRange(const Frame& frame, int light, const DrawnMap& map) {
    std::vector<float> seen;
    for (const vec4& texel : projectedTexels(frame, light, map, kPointDistance))
        if (texel.g > 0.5f) seen.push_back(texel.r);
    Display range{.minimum = 0,
                  .maximum = map.maps.farthest,
                  .unit = map.maps.parallel ? "m along the light, from the map's near side" : "m from the light",
                  .key = {}};
    if (seen.empty()) return range;
    std::ranges::sort(seen);
    const std::size_t cut = seen.size() / 50; // as in lessonMap
    range.minimum = seen[cut];
    range.maximum = std::max<double>(seen[seen.size() - 1 - cut], range.minimum + 1e-3 * map.maps.farthest);
    return range;
}

void ShadowMap::publishProjected(Frame& frame, int light, const DrawnMap& map, const Display& range) {
    const Display comparison = {.unit = "",
                                .key = {{look::kEqualDepth, "d = z: equal, lit"},
                                        {look::kOccluded, "d < z: something is nearer, in shadow"},
                                        {look::kNothingStored, "no d here: nothing in the way, lit"},
                                        {look::kNotAsked, "faces away or outside the light: not asked"}}};
    const auto publish = [&](std::string_view stage, int mode, GLenum format, const Display& display) {
        if (frame.wants(stage, light))
            frame.drawStage(
                stage, light, format, [&] { drawProjected(frame, light, map, mode); }, display);
    };
    publish("depth-on-view", kMapDepth, GL_RG32F, range);
    publish("distance-on-view", kPointDistance, GL_RG32F, range);
    publish("comparison", kComparison, GL_RGBA16F, comparison);
}

} // namespace shadowlab::shadow_map
