// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/exact/exact_light.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"

namespace shadowlab::shadow_map {

namespace {

constexpr int kIdUnit = kMapUnit + 1, kPositionUnit = kMapUnit + 2, kTriangleUnit = kMapUnit + 3,
              kEdgeUnit = kMapUnit + 4;

// Depths that differ by less may be of surfaces that touch: this share of the map's range covers the rounding of float
// positions, and four steps of the format that of the depths themselves.
constexpr float kRounding = 1e-5f;

} // namespace

std::vector<std::size_t> ExactLight::drawnCasters(const scene::Scene& scene, int light) const {
    return tools_.params.cull ? tools_.fitter.usefulCasters(light) : scene::allCasters(scene);
}

LightShadowMap ExactLight::updateMap(Frame& frame, int light) {
    const LightMaps& maps = tools_.fitter.fitted(light);
    // Also where no layer is drawn: lights share one map where maps of their own would be too large, and of two lights in one place the
    // second finds it as it needs it.
    if (maps.layers() > 0) pass_.findEdges(frame.scene(), light, maps, drawnCasters(frame.scene(), light));
    return tools_.drawer.updateMap(frame, light,
                                   [&](int layer, std::span<const std::size_t> casters, CachedMap& cached) {
                                       drawLayer(frame, light, maps, layer, casters, cached.depth, *cached.exact);
                                   });
}

const gl::Texture2D& ExactLight::decide(Frame& frame, int light, const LightShadowMap& map) {
    gl::setBaselineState();
    map.depth->sample(gl::DepthSampling::depths);
    const std::vector<std::size_t> drawn = drawnCasters(frame.scene(), light);
    const OwnUniforms own{.once = [&](const gl::Program& program) { setUniforms(program, light, map); },
                          .perObject =
                              [&](const gl::Program& program, std::size_t object) {
                                  program.set("castsShadow", frame.scene().objects[object].castsShadow ? 1 : 0);
                                  program.set("isDrawn", std::ranges::binary_search(drawn, object) ? 1 : 0);
                              }};
    Receivers& receivers = tools_.receivers;
    const gl::Program& program = receivers.programsFor(map).decide;
    return pass_
        .decide(frame, light,
                [&] { receivers.drawWhereNeeded(frame, program, receivers.unshadowed(true), light, map, own); })
        .visibility;
}

void ExactLight::drawLayer(const Frame& frame, int light, const LightMaps& maps, int layer,
                           std::span<const std::size_t> casters, const gl::DepthTextureArray& depth,
                           const ExactTextures& textures) {
    tools_.drawer.depthPass().drawWithIds(frame, maps, layer, casters, depth, textures.triangles, {});
    pass_.drawEdges(frame, maps, light, layer, casters, textures.edges);
}

void ExactLight::publishTraced(Frame& frame, int light, const LightShadowMap& map) {
    if (!pass_.isDecided(light)) { // no map: nothing in view can be in this light's shadow
        Receivers& receivers = tools_.receivers;
        pass_.decide(frame, light, [&] { receivers.draw(frame, receivers.unshadowed(true), light, map); });
    }
    pass_.publishTraced(frame, light);
}

void ExactLight::setUniforms(const gl::Program& program, int light, const LightShadowMap& map) const {
    map.exact->triangles.bind(kIdUnit);
    program.set("firstTriangles", kIdUnit);
    map.exact->edges.bind(kEdgeUnit);
    program.set("edgeDepths", kEdgeUnit);
    pass_.bindWalk(program, light, kPositionUnit, kTriangleUnit);
    const bool fixed16 = tools_.params.depthFormat == ShadowMapParams::DepthFormat::fixed16;
    // The rasteriser moves corners to its grid, of 256 steps a texel with 8 bits (GL promises 4): an edge by up to 0.71 of a step.
    // Where the grid is coarser, more texels are left to rays, and with fewer than 6 bits all of them.
    GLint subPixelBits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subPixelBits);
    program.set("certainTexels", 0.02f * std::ldexp(1.0f, std::max(8 - subPixelBits, 0)));
    program.set("depthEpsilon", std::max(kRounding, 4.0f / static_cast<float>(1 << (fixed16 ? 16 : 24))));
}

} // namespace shadowlab::shadow_map
