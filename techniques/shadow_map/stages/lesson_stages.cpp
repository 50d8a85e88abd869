// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/stages/stages.h"

#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/shadow_map/maps/sheet.h"
#include "techniques/shadow_map/shared_info.h"
#include "techniques/shadow_map/stages/projected.h"

namespace shadowlab::shadow_map {

void LessonStages::publish(Frame& frame, int light, const LightShadowMap& map) {
    const std::string_view lessons[] = {"light-view", "light-depth", "depth-on-view", "distance-on-view", "comparison"};
    if (std::ranges::none_of(lessons, [&](std::string_view stage) { return frame.wants(stage, light); })) return;
    gl::DepthTextureArray depth;
    const LightShadowMap lesson = lessonMap(frame, light, map, depth);
    shown_.keep(light, lesson.maps, frame.view());
    const Display range = distanceRange(frame, light, lesson);
    if (frame.wants("light-view", light)) publishLightView(frame, light, lesson);
    if (frame.wants("light-depth", light)) publishLightDepth(frame, light, lesson, range);
    publishProjected(frame, light, lesson, range);
}

void LessonStages::addPlaces(Probe& probe, int light, const View& view) const {
    for (const std::string_view stage : {kLightViewStage.id, kLightDepthStage.id})
        shown_.addPlace(probe, stage, light, view);
}

// The map that the picture uses covers only what casters and receivers share, and a floor that shadows nothing is not in it. The map
// that these stages show covers all casters and what the eye sees, so that the floor has a depth, too.
LightShadowMap LessonStages::lessonMap(const Frame& frame, int light, const LightShadowMap& map,
                                       gl::DepthTextureArray& depth) {
    std::vector<double> seen[3];
    for (const vec4& texel : projectedTexels(tools_, frame, light, map, Projected::position))
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
    const std::vector<scene::Bounds> receivers =
        region.isEmpty() ? std::vector(tools_.fitter.bounds().begin(), tools_.fitter.bounds().end())
                         : std::vector{region};
    LightShadowMap lesson{
        .maps = tools_.fitter.fit(frame.scene(), frame.view(), map.query, receivers, FitRequest::Cover::shown),
        .query = map.query,
        .depth = &depth};
    const GLenum format = tools_.params.glDepthFormat();
    depth = gl::DepthTextureArray(format, tools_.params.resolution, lesson.maps.layers(), "shadow map shown");
    const std::vector<std::size_t> casters = scene::allCasters(frame.scene());
    const DepthRules rules = depthRules(tools_.params, map.query.filter);
    for (int layer = 0; layer < lesson.maps.layers(); ++layer) {
        gl::setBaselineState();
        tools_.drawer.depthPass().draw(frame, lesson.maps, layer, casters, depth, format, rules);
    }
    return lesson;
}

void LessonStages::publishWithoutShadows(Frame& frame) const {
    const gl::Program& unshadowed = tools_.receivers.unshadowed(false);
    frame.drawOverTarget("without-shadows", kNoLight, false, [&] {
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setAddLightState();
            gl::useForLight(unshadowed, frame.scene(), frame.buffers(), frame.eye(), light);
            gl::drawSurfaces(unshadowed, frame.scene(), frame.buffers(), frame.eye());
        }
    });
}

void LessonStages::publishLightView(Frame& frame, int light, const LightShadowMap& map) const {
    const LightMaps& maps = map.maps;
    const Sheet sheet(maps, frame.view().size);
    const gl::Program& unshadowed = tools_.receivers.unshadowed(false);
    // A flame around its light casts no shadow, but would hide everything in a picture taken from the light.
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
        gl::useForLight(unshadowed, frame.scene(), frame.buffers(), lightEye, light);
        gl::drawSurfaces(unshadowed, frame.scene(), frame.buffers(), lightEye, isSeen);
    }
    frame.publish("light-view", light, std::move(target.color));
}

void LessonStages::publishLightDepth(Frame& frame, int light, const LightShadowMap& map, const Display& range) const {
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
    setReceiverUniforms(showDepth_, maps, tools_.params, map.query.filter);
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

// One scale for all pictures of depth, so that they can be compared: the distances of what the eye sees.
Display LessonStages::distanceRange(const Frame& frame, int light, const LightShadowMap& map) {
    std::vector<float> seen;
    for (const vec4& texel : projectedTexels(tools_, frame, light, map, Projected::pointDistance))
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

void LessonStages::publishProjected(Frame& frame, int light, const LightShadowMap& map, const Display& range) {
    const Display comparison = {.unit = "",
                                .key = {{look::kEqualDepth, "d = z: equal, lit"},
                                        {look::kOccluded, "d < z: something is nearer, in shadow"},
                                        {look::kNothingStored, "no d here: nothing in the way, lit"},
                                        {look::kNotAsked, "faces away or outside the light: not asked"}}};
    const auto publish = [&](std::string_view stage, Projected what, GLenum format, const Display& display) {
        if (frame.wants(stage, light))
            frame.drawStage(
                stage, light, format, [&] { drawProjected(tools_, frame, light, map, what); }, display);
    };
    publish("depth-on-view", Projected::mapDepth, GL_RG32F, range);
    publish("distance-on-view", Projected::pointDistance, GL_RG32F, range);
    publish("comparison", Projected::comparison, GL_RGBA16F, comparison);
}

} // namespace shadowlab::shadow_map
