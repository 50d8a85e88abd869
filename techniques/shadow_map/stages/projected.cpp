// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/stages/projected.h"

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::shadow_map {

void drawProjected(MapTools& tools, const Frame& frame, int light, const LightShadowMap& map, Projected what) {
    glDepthFunc(GL_EQUAL);
    // Positions can be drawn without a map, but the shader's sampler needs a texture all the same.
    const gl::DepthTextureArray none =
        map.depth ? gl::DepthTextureArray() : gl::DepthTextureArray(GL_DEPTH_COMPONENT24, 1, 1, "no shadow map");
    const gl::DepthTextureArray& depth = map.depth ? *map.depth : none;
    depth.sample(gl::DepthSampling::depths);
    depth.bind(kMapUnit);
    const gl::Program& project = tools.receivers.programsFor(map).project;
    const auto setUniforms = [&](const gl::Program&) {
        project.set("mode", static_cast<int>(what));
        project.set("equalColor", look::kEqualDepth);
        project.set("occludedColor", look::kOccluded);
        project.set("nothingStoredColor", look::kNothingStored);
        project.set("notAskedColor", look::kNotAsked);
    };
    tools.receivers.draw(frame, project, light, map, {.once = setUniforms});
}

std::vector<vec4> projectedTexels(MapTools& tools, const Frame& frame, int light, const LightShadowMap& map,
                                  Projected what) {
    gl::Texture2D texture(GL_RGBA32F, frame.target().size(), "projected texels");
    const gl::Framebuffer framebuffer(&texture, &frame.target().depthStencil, "projected texels");
    gl::setBaselineState();
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    drawProjected(tools, frame, light, map, what);
    return gl::readTexels(texture);
}

} // namespace shadowlab::shadow_map
