// The pictures of the lecture's walk through shadow mapping, in its order.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/look.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

namespace {

constexpr int kMapUnit = gl::kFirstFreeUnit;

// Modes of shaders/shadow_map/project.frag.
constexpr int kMapDepth = 0, kPointDistance = 1, kComparison = 2;

/// The six maps around a light are shown as a 3 x 2 sheet: +x +y +z above -x -y -z.
struct Sheet {
    ivec2 cells;
    int cellSize;
    Sheet(int layers, ivec2 within)
        : cells(layers == 6 ? ivec2(3, 2) : ivec2(1)),
          cellSize(std::max(1, std::min(within.x / cells.x, within.y / cells.y))) {}
    [[nodiscard]] ivec2 size() const { return cells * cellSize; }
    void setViewport(int layer) const {
        const int column = cells.x == 1 ? 0 : layer / 2, rowFromTop = cells.x == 1 ? 0 : layer % 2;
        const int x = column * cellSize, y = (cells.y - 1 - rowFromTop) * cellSize;
        glViewport(x, y, cellSize, cellSize);
        glScissor(x, y, cellSize, cellSize);
        glEnable(GL_SCISSOR_TEST);
    }
};

} // namespace

void ShadowMap::publishStages(Frame& frame, int light, const PreparedLight& prepared) {
    if (frame.wants("light-depth", light) || frame.wants("depth-on-view", light) ||
        frame.wants("distance-on-view", light))
        shownDistance_ = distanceRange(frame, light, prepared);
    if (frame.wants("light-view", light)) publishLightView(frame, light, prepared);
    if (frame.wants("light-depth", light)) publishLightDepth(frame, light, prepared);
    publishProjected(frame, light, prepared);
    if (frame.wants("visibility", light))
        frame.drawStage("visibility", light, GL_RG32F, [&] {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setVisibilityState();
            drawReceivers(frame, visibility_, light, prepared);
        });
}

void ShadowMap::publishWithoutShadows(Frame& frame) const {
    frame.drawOverTarget("without-shadows", kNoLight, false, [&] {
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setAddLightState();
            unshadowed_.use();
            gl::setLight(unshadowed_, frame.scene(), frame.buffers(), frame.eye(), light);
            gl::drawSurfaces(unshadowed_, frame.scene(), frame.buffers(), frame.eye());
        }
    });
}

void ShadowMap::publishLightView(Frame& frame, int light, const PreparedLight& prepared) const {
    const LightMaps& maps = prepared.maps;
    const Sheet sheet(maps.layers(), frame.view().size);
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
        gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), lightEye);
        gl::setAddLightState();
        unshadowed_.use();
        gl::setLight(unshadowed_, frame.scene(), frame.buffers(), lightEye, light);
        gl::drawSurfaces(unshadowed_, frame.scene(), frame.buffers(), lightEye);
    }
    frame.publish("light-view", light, std::move(target.color));
}

void ShadowMap::publishLightDepth(Frame& frame, int light, const PreparedLight& prepared) const {
    const LightMaps& maps = prepared.maps;
    const Sheet sheet(maps.layers(), frame.view().size);
    gl::Texture2D picture(GL_RG32F, sheet.size(), "light-depth");
    const gl::Framebuffer framebuffer(&picture, nullptr, "light-depth");
    gl::setBaselineState();
    glDisable(GL_DEPTH_TEST);
    framebuffer.bind();
    map_.compare(false);
    showDepth_.use();
    map_.bind(kMapUnit);
    showDepth_.set("shadowMap", kMapUnit);
    showDepth_.set("parallel", maps.parallel ? 1 : 0);
    showDepth_.set("nearest", static_cast<float>(maps.nearest));
    showDepth_.set("farthest", static_cast<float>(maps.farthest));
    showDepth_.set("cellSize", sheet.cellSize);
    for (int layer = 0; layer < maps.layers(); ++layer) {
        sheet.setViewport(layer);
        showDepth_.set("layer", layer);
        gl::drawFullscreenTriangle();
    }
    map_.compare(true);
    frame.publish("light-depth", light, std::move(picture), shownDistance_);
}

void ShadowMap::drawProjected(const Frame& frame, int light, const PreparedLight& prepared, int mode) const {
    const LightMaps& maps = prepared.maps;
    glDepthFunc(GL_EQUAL);
    project_.use();
    project_.set("mode", mode);
    project_.set("parallel", maps.parallel ? 1 : 0);
    project_.set("nearest", static_cast<float>(maps.nearest));
    project_.set("farthest", static_cast<float>(maps.farthest));
    project_.set("equalColor", look::kEqualDepth);
    project_.set("occludedColor", look::kOccluded);
    project_.set("noAnswerColor", look::kNoAnswer);
    drawReceivers(frame, project_, light, prepared);
}

// One scale for all pictures of depth, so that they can be compared: the distances of what the eye sees.
Display ShadowMap::distanceRange(const Frame& frame, int light, const PreparedLight& prepared) const {
    gl::Texture2D distances(GL_RG32F, frame.target().size(), "distance range");
    const gl::Framebuffer framebuffer(&distances, &frame.target().depthStencil, "distance range");
    gl::setBaselineState();
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    drawProjected(frame, light, prepared, kPointDistance);
    std::vector<float> seen;
    for (const vec4& texel : gl::readTexels(distances))
        if (texel.g > 0.5f) seen.push_back(texel.r);
    const std::string unit =
        prepared.maps.parallel ? "m along the light, from the map's near side" : "m from the light";
    Display range{.minimum = 0, .maximum = prepared.maps.farthest, .unit = unit, .key = {}};
    if (seen.empty()) return range;
    // A horizon would stretch the scale until everything near is one colour: one pixel in fifty may lie beyond each
    // end.
    std::ranges::sort(seen);
    range.minimum = seen[seen.size() / 50];
    range.maximum =
        std::max<double>(seen[seen.size() - 1 - seen.size() / 50], range.minimum + 1e-3 * prepared.maps.farthest);
    return range;
}

void ShadowMap::publishProjected(Frame& frame, int light, const PreparedLight& prepared) const {
    const Display comparison = {.unit = "",
                                .key = {{look::kEqualDepth, "d = z: equal, nothing nearer: lit"},
                                        {look::kOccluded, "d < z: something is nearer, in shadow"},
                                        {look::kNoAnswer, "faces away or outside the light: not asked"}}};
    map_.compare(false);
    const auto publish = [&](std::string_view stage, int mode, GLenum format, const Display& display) {
        if (frame.wants(stage, light))
            frame.drawStage(
                stage, light, format, [&] { drawProjected(frame, light, prepared, mode); }, display);
    };
    publish("depth-on-view", kMapDepth, GL_RG32F, shownDistance_);
    publish("distance-on-view", kPointDistance, GL_RG32F, shownDistance_);
    publish("comparison", kComparison, GL_RGBA16F, comparison);
    map_.compare(true);
}

} // namespace shadowlab::shadow_map
