// How large the texels of the map lie on screen: where they cover many pixels, edges of shadows are stairs.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

void ShadowMap::publishTexelSize(Frame& frame, int light, const DrawnMap& map) {
    const auto draw = [&] {
        glClear(GL_STENCIL_BUFFER_BIT);
        gl::setVisibilityState();
        const gl::Program& program = programsFor(map.maps).texelSize;
        program.use();
        const dvec2 size(frame.view().size);
        program.set("longest", static_cast<float>(glm::length(size))); // the picture's diagonal
        drawReceivers(frame, program, light, map);
    };
    gl::Texture2D texture(GL_RG32F, frame.target().size(), "texel-size");
    {
        const gl::Framebuffer framebuffer(&texture, &frame.target().depthStencil, "texel-size");
        gl::setBaselineState();
        framebuffer.bind();
        glClear(GL_COLOR_BUFFER_BIT);
        draw();
    }
    // From nothing to what all but a fiftieth of the pixels stay below: surfaces that the light grazes have no bound.
    std::vector<float> sizes;
    for (const vec4& texel : gl::readTexels(texture))
        if (texel.g > 0.5f) sizes.push_back(texel.r);
    Display display{.minimum = 0, .maximum = 1, .unit = "px: longest extent of a texel on screen", .key = {}};
    if (!sizes.empty()) {
        const auto most = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() - 1 - sizes.size() / 50);
        std::ranges::nth_element(sizes, most);
        display.maximum = std::max(0.1, static_cast<double>(*most));
    }
    frame.publish("texel-size", light, std::move(texture), display);
}

} // namespace shadowlab::shadow_map
