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

/// The radiance of every surface with its lights off, if it is the same for all, and all receive shadows.
std::optional<vec3> onlyLightsOff(const scene::Scene& scene, const gl::SceneBuffers& buffers) {
    if (buffers.anyOwnColors()) return std::nullopt;
    std::optional<vec3> only;
    for (const scene::Object& object : scene.objects) {
        if (!object.receivesShadow) return std::nullopt;
        for (const std::size_t index : object.partMaterials) {
            const scene::Material& material = scene.materials[index];
            const vec3 reflected = scene.ambient * material.diffuse;
            if (material.emission != vec3(0) || (only && *only != reflected)) return std::nullopt;
            only = reflected;
        }
    }
    return only;
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

void StencilledPasses::lightsOff(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    if (!frame.drawsFinished()) {
        gl::drawLightsOff(lightsOff_, scene, frame.buffers(), frame.eye());
        return;
    }
    if (scene.lights.size() == 1) {
        onlyLightsOff_ = onlyLightsOff(scene, frame.buffers());
        if (!onlyLightsOff_) frame.bindInShadowToo();
        clearFinished(scene);
        gl::useForLight(light_, scene, frame.buffers(), frame.eye(), 0,
                        onlyLightsOff_ ? gl::ShadedAs::finished : gl::ShadedAs::finishedAndInShadow);
        gl::drawSurfaces(light_, scene, frame.buffers(), frame.eye());
        return;
    }
    clearFinished(scene);
    frame.bindHiddenLights();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    frame.target().withoutColor.bind();
    gl::drawSurfaceDepth(depths_, scene, frame.buffers(), frame.eye());
}

void StencilledPasses::hide(Frame& frame, int light, const std::optional<scene::PicturePart>& part, GLuint stencilMask) const {
    // On surfaces alone: a volume that ends nowhere is counted on the background, too.
    glDepthRange(1, 1);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, 0, stencilMask);
    if (frame.scene().lights.size() > 1) {
        frame.bindHiddenLights();
        glEnable(GL_BLEND); // bits of eight lights add up to a byte
        glBlendFunc(GL_ONE, GL_ONE);
        vec4 bit(0);
        bit[light / 8] = static_cast<float>(1 << light % 8) / 255.0f;
        hide_.use();
        hide_.set("bit", bit);
    } else if (onlyLightsOff_) {
        color_.use();
        color_.set("color", vec4(gl::finished(*onlyLightsOff_, frame.scene().exposure), 1));
    } else {
        inShadow_.use();
        inShadow_.set("inShadow", 0);
        frame.inShadow().bind(0);
    }
    frame.scissorTo(part);
    gl::drawFullscreenTriangle();
}

void StencilledPasses::shadeFinished(Frame& frame, const PassInfo& light) const {
    const int lights = static_cast<int>(frame.scene().lights.size());
    if (!frame.drawsFinished() || lights == 1) return;
    frame.pass(
        light,
        [&] {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setVisibilityState();
            gl::useForAllLights(allLights_, frame.scene(), frame.buffers(), frame.eye(), &frame.inShadow());
            gl::drawSurfaces(allLights_, frame.scene(), frame.buffers(), frame.eye());
        },
        lights - 1);
}

} // namespace shadowlab
