// SPDX-License-Identifier: MIT
#include "techniques/lecture/parts/lit_scene.h"

namespace shadowlab::lecture {

namespace {

// [anchor: lecture-light-on]
void drawWhereStencilIsZero(const Frame& frame, const gl::Program& program, int light) {
    gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [](const scene::Object& object) {
        glStencilFunc(object.receivesShadow ? GL_EQUAL : GL_ALWAYS, 0, 0xff);
        return true;
    });
}

} // namespace

void LitScene::lightsOff(const Frame& frame) const {
    gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), frame.eye());
}

void LitScene::lightOn(const Frame& frame, int light) const {
    gl::setAddLightState();
    drawWhereStencilIsZero(frame, lightOn_, light);
}

void LitScene::publishVisibility(Frame& frame, int light, const std::function<void()>& mark) const {
    if (!frame.wants("visibility", light)) return;
    frame.drawStage("visibility", light, GL_RG32F, [&] {
        glClear(GL_STENCIL_BUFFER_BIT);
        mark();
        drawWhere(frame, GL_ALWAYS, 0, {0, 1, 0, 1}); // every surface first, as if no light reached it
        gl::setVisibilityState();
        drawWhereStencilIsZero(frame, visibility_, light);
    });
}

void LitScene::publishStencil(Frame& frame, std::string_view stage, int light,
                              const std::function<void()>& mark) const {
    if (!frame.wants(stage, light)) return;
    constexpr int kMost = 8, kShown = 4; // in one picture no more than nine colours can be told apart
    frame.drawStage(stage, light, GL_RG32F,
                    [&] {
                        glClear(GL_STENCIL_BUFFER_BIT);
                        mark();
                        for (int value = -kMost; value <= kMost; ++value)
                            drawWhere(frame, GL_EQUAL, value, {value, 1, 0, 1});
                    },
                    {.minimum = -kShown, .maximum = kShown, .unit = "faces counted", .key = {}});
}

void LitScene::drawWhere(const Frame& frame, GLenum comparison, int value, const vec4& color) const {
    glDepthFunc(GL_EQUAL);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(comparison, value & 0xff, 0xff); // the stencil has no sign: 255 is -1
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    color_.use();
    color_.set("color", color);
    gl::drawSurfaces(color_, frame.scene(), frame.buffers(), frame.eye());
}

void drawPoints(GLenum kind, const std::vector<vec4>& homogeneousMesh) {
    if (homogeneousMesh.empty()) return;
    const gl::VertexArrayHandle array = gl::VertexArrayHandle::create();
    glBindVertexArray(array.id());
    const gl::BufferHandle buffer = gl::uploadBuffer(GL_ARRAY_BUFFER, homogeneousMesh);
    glEnableVertexAttribArray(gl::kPositionMesh);
    glVertexAttribPointer(gl::kPositionMesh, 4, GL_FLOAT, GL_FALSE, sizeof(vec4), nullptr);
    glDrawArrays(kind, 0, static_cast<GLsizei>(homogeneousMesh.size()));
    glBindVertexArray(0);
}

void setTransparentState() {
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

} // namespace shadowlab::lecture
