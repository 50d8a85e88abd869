// The part of the technique that is exact: one light's pixels decided by the map where it is certain, and by rays elsewhere.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

namespace {

constexpr int kIdUnit = kMapUnit + 1, kPositionUnit = kMapUnit + 2, kTriangleUnit = kMapUnit + 3,
              kEdgeUnit = kMapUnit + 4;

// Depths that differ by less may be of surfaces that touch: this share of the map's range covers the rounding of float
// positions, and four steps of the format that of the depths themselves.
constexpr float kRounding = 1e-5f;

} // namespace

std::vector<std::size_t> ShadowMap::drawnCasters(const scene::Scene& scene, int light) const {
    return params_.cull ? usefulCasters_[static_cast<std::size_t>(light)] : scene::allCasters(scene);
}

const gl::Texture2D& ShadowMap::decide(Frame& frame, int light, const DrawnMap& map) {
    gl::setBaselineState();
    map.depth->sample(gl::DepthSampling::depths);
    const gl::Program& program = programsFor(map).decide;
    const Decisions& decisions =
        exact_.decide(frame, light, [&] { drawAsked(frame, program, unshadowedVisibility_, light, map); });
    return decisions.visibility;
}

void ShadowMap::drawExact(const Frame& frame, int light, const LightMaps& maps, int layer,
                          std::span<const std::size_t> casters, const gl::DepthTextureArray& depth,
                          const ExactMap& exact) {
    depthPass_.drawWithIds(frame, maps, layer, casters, depth, exact.triangles, {});
    exact_.findEdges(frame.scene(), light, maps, drawnCasters(frame.scene(), light));
    exact_.drawEdges(frame, maps, light, layer, casters, exact.edges);
}

void ShadowMap::publishTraced(Frame& frame, int light, const DrawnMap& map) {
    if (exact_.isDecided(light)) {
        exact_.publishTraced(frame, light);
        return;
    }
    // As it would be with exact = true.
    if (!map.depth) {
        exact_.prepare(frame.snapshot(), Deadline::max());
        exact_.decide(frame, light, [&] { drawReceivers(frame, unshadowedVisibility_, light, map); });
    } else {
        exact_.prepare(frame.snapshot(), Deadline::max());
        const int layers = map.maps.layers();
        const gl::DepthTextureArray depth(params_.glDepthFormat(), params_.resolution, layers, "exact shadow map");
        const ExactMap exact(params_.resolution, layers, params_.glDepthFormat());
        for (int layer = 0; layer < layers; ++layer) {
            gl::setBaselineState();
            drawExact(frame, light, map.maps, layer, castersOf(frame.scene(), map.maps, map.asked, layer), depth,
                      exact);
        }
        decide(frame, light, {.maps = map.maps, .asked = map.asked, .depth = &depth, .exact = &exact});
    }
    exact_.publishTraced(frame, light);
    exact_.beginFrame();
}

void ShadowMap::setExactUniforms(const gl::Program& program, int light, const DrawnMap& map) const {
    map.exact->triangles.bind(kIdUnit);
    program.set("firstTriangles", kIdUnit);
    map.exact->edges.bind(kEdgeUnit);
    program.set("edgeDepths", kEdgeUnit);
    exact_.bindWalk(program, light, kPositionUnit, kTriangleUnit);
    const bool fixed16 = params_.depthFormat == ShadowMapParams::DepthFormat::fixed16;
    // The rasteriser moves corners to its grid, of 256 steps a texel with 8 bits (GL promises 4): an edge by up to 0.71 of a step.
    // Where the grid is coarser, more texels are left to rays, and with fewer than 6 bits all of them.
    GLint subPixelBits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subPixelBits);
    program.set("certainTexels", 0.02f * std::ldexp(1.0f, std::max(8 - subPixelBits, 0)));
    program.set("apart", std::max(kRounding, 4.0f / static_cast<float>(1 << (fixed16 ? 16 : 24))));
}

void ShadowMap::setObjectUniforms(const Frame& frame, const gl::Program& program, int light, std::size_t index) const {
    const scene::Object& object = frame.scene().objects[index];
    program.set("castsShadow", object.castsShadow ? 1 : 0);
    const bool isDrawn = params_.cull
                             ? std::ranges::binary_search(usefulCasters_[static_cast<std::size_t>(light)], index)
                             : object.castsShadow;
    program.set("isDrawn", isDrawn ? 1 : 0);
}

} // namespace shadowlab::shadow_map
