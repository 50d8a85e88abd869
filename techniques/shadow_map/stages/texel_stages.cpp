// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/stages/stages.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::shadow_map {

namespace {

// A square of the grid is at least this wide where half of the picture is: from the last row, less is grey.
constexpr double kSquarePx = 12;

std::string layerLabel(const LightMaps& maps, int layer) {
    static constexpr const char* axes[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    if (maps.layout == Layout::cube) return std::string("map along ") + axes[layer];
    return maps.layout == Layout::cascades ? "cascade " + std::to_string(layer + 1) : "the map";
}

gl::Texture2D drawTexelSizes(MapTools& tools, const Frame& frame, int light, const LightShadowMap& map) {
    gl::Texture2D texture(GL_RG32F, frame.target().size(), "texel-size");
    const gl::Framebuffer framebuffer(&texture, &frame.target().depthStencil, "texel-size");
    gl::setBaselineState();
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    if (!map.depth) return texture;
    glClear(GL_STENCIL_BUFFER_BIT);
    gl::setVisibilityState();
    const gl::Program& program = tools.receivers.programsFor(map).texelSize;
    const auto setUniforms = [&](const gl::Program&) {
        const dvec2 size(frame.view().size);
        program.set("longest", static_cast<float>(glm::length(size))); // the picture's diagonal
    };
    tools.receivers.draw(frame, program, light, map, {.once = setUniforms});
    return texture;
}

void publishLayers(MapTools& tools, Frame& frame, int light, const LightShadowMap& map, std::string_view stage,
                   int squareTexels) {
    Display display;
    for (int layer = 0; layer < map.maps.layers(); ++layer)
        display.key.push_back({look::kLayers[static_cast<std::size_t>(layer)], layerLabel(map.maps, layer)});
    if (squareTexels > 0) {
        const std::string side = std::to_string(squareTexels);
        display.key.push_back({0.15f * look::kLayers[0], "each square: " + side + " x " + side + " texels"});
    }
    if (display.key.empty()) display.key.push_back({look::kNotAsked, "no map: nothing in view can be in its shadow"});
    frame.drawOverTarget(
        stage, light, true,
        [&] {
            if (!map.depth) return;
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setVisibilityState();
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            const gl::Program& program = tools.receivers.programsFor(map).layers;
            std::vector<vec4> colors;
            for (const vec3& color : look::kLayers)
                colors.emplace_back(color, 1.0f);
            const auto setUniforms = [&](const gl::Program&) {
                program.set("squareTexels", static_cast<float>(squareTexels));
                program.set("strength", 0.6f);
                program.set("layerColors", std::span<const vec4>(colors));
            };
            tools.receivers.draw(frame, program, light, map, {.once = setUniforms});
        },
        display);
}

} // namespace

void publishTexelStages(MapTools& tools, Frame& frame, int light, const LightShadowMap& map) {
    const bool grid = frame.wants("texel-grid", light);
    if (frame.wants("map-layers", light)) publishLayers(tools, frame, light, map, "map-layers", 0);
    if (!grid && !frame.wants("texel-size", light)) return;
    gl::Texture2D texture = drawTexelSizes(tools, frame, light, map);
    std::vector<float> sizes;
    for (const vec4& texel : gl::readTexels(texture))
        if (texel.g > 0.5f) sizes.push_back(texel.r);
    std::ranges::sort(sizes);
    if (grid) {
        const double median = sizes.empty() ? 1 : std::max<double>(sizes[sizes.size() / 2], 1e-6);
        publishLayers(tools, frame, light, map, "texel-grid",
                      std::max(1, 1 << std::clamp(std::ilogb(kSquarePx / median) + 1, 0, 20)));
    }
    if (!frame.wants("texel-size", light)) return;
    // From nothing to what all but a fiftieth of the pixels stay below: surfaces that the light grazes have no bound.
    Display display{.minimum = 0, .maximum = 1, .unit = "px: longest extent of a texel on screen", .key = {}};
    if (!sizes.empty())
        display.maximum = std::max(0.1, static_cast<double>(sizes[sizes.size() - 1 - sizes.size() / 50]));
    frame.publish("texel-size", light, std::move(texture), display);
}

} // namespace shadowlab::shadow_map
