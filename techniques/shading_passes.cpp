// SPDX-License-Identifier: MIT
#include "techniques/shading_passes.h"

namespace shadowlab {

namespace {

/// Clears the finished picture, or both, to the background as it is shown.
void clearFinished(const scene::Scene& scene) {
    const vec3 background = gl::finished(scene.background, scene.exposure);
    glClearColor(background.r, background.g, background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

} // namespace

void ShadingPasses::lightsOff(const Frame& frame, Depths depths) {
    if (!frame.drawsFinished()) {
        gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), frame.eye());
        drawn_ = Depths::first;
        return;
    }
    clearFinished(frame.scene());
    drawn_ = depths;
    if (depths == Depths::withLight) return;
    frame.target().withoutColor.bind();
    gl::drawSurfaceDepth(depths_, frame.scene(), frame.buffers(), frame.eye());
}

gl::ShadedAs ShadingPasses::beginLight(const Frame& frame) const {
    if (!frame.drawsFinished()) {
        gl::setAddLightState();
        return gl::ShadedAs::radiance;
    }
    if (drawn_ == Depths::first) gl::setVisibilityState(); // else the baseline: what is nearer is drawn over
    return gl::ShadedAs::finished;
}

void StencilledPasses::lightsOff(Frame& frame, int light) {
    if (!frame.drawsFinished()) {
        gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), frame.eye());
        return;
    }
    frame.bindInShadowToo();
    clearFinished(frame.scene());
    gl::useForLight(light_, frame.scene(), frame.buffers(), frame.eye(), light, gl::ShadedAs::finishedAndInShadow);
    gl::drawSurfaces(light_, frame.scene(), frame.buffers(), frame.eye());
}

void StencilledPasses::takeInShadow(const Frame& frame, GLuint stencilMask) const {
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, 0, stencilMask);
    inShadow_.use();
    inShadow_.set("inShadow", 0);
    frame.inShadow().bind(0);
    gl::drawFullscreenTriangle();
}

} // namespace shadowlab
