// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/stage_pictures.h"

#include <algorithm>

#include "techniques/foundation/look.h"
#include "techniques/foundation/scene/facing.h"

namespace shadowlab::shadow_volume {

namespace {

/// A display colour as the radiance that exposure turns into it.
vec4 unexposed(const Frame& frame, const vec3& color, float alpha) { return {color / frame.scene().exposure, alpha}; }

// Counts beyond this are shown like it: real scenes rarely stack more casters, and few colours stay readable.
constexpr int kCountShown = 6;

} // namespace

void setFrontFace(const scene::Object& object, bool clockwise) {
    glFrontFace(gl::isMirrored(object) != clockwise ? GL_CW : GL_CCW);
}

void setExtrusion(const gl::Program& program, const Frame& frame, const CasterVolume& caster, int light) {
    const scene::Object& object = frame.scene().objects[caster.object];
    program.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
    program.set("lightMesh", vec4(scene::lightMesh(object, frame.scene().lights[static_cast<std::size_t>(light)])));
}

void StagePictures::publishFacing(Frame& frame, int light) const {
    frame.drawStage("facing", light, GL_RGBA16F, [&] {
        glDepthFunc(GL_EQUAL);
        facing_.use();
        facing_.set("towardColor", look::kTowardLight);
        facing_.set("awayColor", look::kAwayFromLight);
        gl::setLight(facing_, frame.scene(), frame.buffers(), frame.eye(), light);
        gl::drawSurfaces(facing_, frame.scene(), frame.buffers(), frame.eye());
    }, {.unit = "", .key = {{look::kTowardLight, "N·L > 0: faces the light"}, {look::kAwayFromLight, "N·L ≤ 0: faces away"}}});
}

void StagePictures::publishSilhouettes(Frame& frame, int light, std::span<const CasterVolume* const> casters) const {
    const ivec2 size = frame.target().size();
    // GL promises lines of one pixel only. Thicker ones: the same line drawn again at every offset within a disc.
    const int radius = std::max(1, size.y / 480);
    const auto drawThick = [&](const vec3& color, const auto& drawLines) {
        edges_.set("color", unexposed(frame, color, 1));
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx) {
                if (dx * dx + dy * dy > radius * radius) continue;
                glViewport(dx, dy, size.x, size.y);
                drawLines();
            }
        glViewport(0, 0, size.x, size.y);
    };
    frame.drawOverTarget("silhouettes", light, [&] {
        glDepthFunc(GL_LEQUAL);
        glDepthMask(GL_FALSE);
        edges_.use();
        edges_.set("pullClip", static_cast<float>(2.0 * frame.view().camera.near * 0.003)); // 0.3 % nearer
        for (const CasterVolume* caster : casters) {
            edges_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(frame.scene().objects[caster->object])));
            drawThick(look::kSilhouette, [&] { caster->buffers->drawSilhouette(); });
            drawThick(look::kBoundaryEdge, [&] { caster->buffers->drawBoundary(); });
            drawThick(look::kMultipleEdge, [&] { caster->buffers->drawMultiple(); });
        }
    }, {.unit = "", .key = {{look::kSilhouette, "silhouette edge"}, {look::kBoundaryEdge, "boundary of an open mesh"},
                {look::kMultipleEdge, "edge of more than two faces"}}});
}

void StagePictures::publishFaces(Frame& frame, int light, std::span<const CasterVolume* const> casters,
                                 bool byPart) const {
    constexpr float kAlpha = 0.22f; // two or three layers stay distinguishable
    const vec3 plus = look::diverging()[6], minus = look::diverging()[2];
    const vec3 top = look::kTowardLight, side = look::kSilhouette, bottom = look::kMultipleEdge;
    const auto choose = [&](const vec3& partColor) {
        faces_.set("frontColor", unexposed(frame, byPart ? partColor : plus, kAlpha));
        faces_.set("backColor", unexposed(frame, byPart ? partColor : minus, kAlpha));
    };
    const std::vector<KeyEntry> parts = {{top, "top cap"}, {side, "side"}, {bottom, "bottom cap, at infinity"}};
    const std::vector<KeyEntry> signs = {{plus, "faces the viewer (front)"}, {minus, "faces away from the viewer (back)"}};
    frame.drawOverTarget(byPart ? "volume-parts" : "volume-signs", light, [&] {
        glDepthFunc(GL_LEQUAL); // the top cap lies exactly on the caster's surface
        glDepthMask(GL_FALSE);
        glEnable(GL_DEPTH_CLAMP);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        faces_.use();
        for (const CasterVolume* caster : casters) {
            const scene::Object& object = frame.scene().objects[caster->object];
            setExtrusion(faces_, frame, *caster, light);
            setFrontFace(object, false);
            choose(bottom);
            caster->buffers->drawBottomCap();
            choose(side);
            caster->buffers->drawSides();
            choose(top);
            caster->buffers->drawTopCap();
            setFrontFace(object, true);
            caster->buffers->drawTopCapReversed();
        }
    }, {.unit = "", .key = byPart ? parts : signs});
}

void StagePictures::publishCount(Frame& frame, std::string_view stage, int light) const {
    frame.drawStage(stage, light, GL_RG32F, [&] {
        glDepthFunc(GL_GREATER); // only where something has been drawn
        glDepthMask(GL_FALSE);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        stencilValue_.use();
        const auto paint = [&](int value, GLenum function, int reference) {
            glStencilFunc(function, reference, 0xff);
            stencilValue_.set("color", vec4(static_cast<float>(value), 1, 0, 1));
            gl::drawFullscreenTriangle();
        };
        // The stencil wraps: 255 is -1. Large counts first, then each small one exactly.
        paint(kCountShown, GL_ALWAYS, 0);
        paint(-kCountShown, GL_LESS, 127); // reference 127 < stencil
        for (int value = 1 - kCountShown; value < kCountShown; ++value) paint(value, GL_EQUAL, value & 0xff);
    }, {.minimum = -kCountShown, .maximum = kCountShown, .unit = "faces counted", .key = {}});
}

} // namespace shadowlab::shadow_volume
