// The texels of moment maps, read back: of depths that a test chooses, or of a scene's own.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/shadow_map/filters/moment_maps.h"
#include "techniques/shadow_map/maps/depth_pass.h"
#include "tests/shadow_map/fit/scene_maps.h"

namespace shadowlab::testing {

using shadow_map::FilterParams;

/// Depths in a map, and the cameras that they belong to.
struct FilledMap {
    shadow_map::LightMaps maps;
    gl::DepthTextureArray depth;
};

/// One parallel map, a metre deep: what it holds at (x, y) are also metres.
template <typename Depth>
FilledMap filledMap(int side, const Depth& depthAt) {
    FilledMap filled{{}, gl::DepthTextureArray(GL_DEPTH_COMPONENT32F, side, 1, "depths of a test")};
    filled.maps.parallel = true;
    filled.maps.lightViewFromLightRelative = {dmat4(1.0)};
    filled.maps.lightClipFromLightView = {shadow_map::parallelProjection({{-1, -1, -1}, {1, 1, 0}})};
    std::vector<float> depths;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            depths.push_back(static_cast<float>(depthAt(x, y)));
    filled.depth.bind(gl::kFirstFreeUnit);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, side, side, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return filled;
}

/// What one of the scene's lights sees, drawn as the technique does with its default bias.
inline FilledMap drawnMap(const scene::Snapshot& snapshot, int light, int resolution) {
    const auto& lightOfScene = snapshot->light(light);
    FilledMap drawn{
        sceneMaps(*snapshot, lightOfScene, resolution, 2, {.fit = shadow_map::ProjectionParams::Fit::scene}, true), {}};
    if (drawn.maps.layers() == 0) return drawn;
    drawn.depth = gl::DepthTextureArray(GL_DEPTH_COMPONENT24, resolution, drawn.maps.layers(), "depths of a scene");
    gl::SceneBuffers buffers;
    buffers.update(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = {16, 12};
    const gl::Target target(view.size, "not drawn to");
    const Frame frame(snapshot, view, buffers, target, {});
    const shadow_map::DepthPass pass;
    for (int layer = 0; layer < drawn.maps.layers(); ++layer) {
        gl::setBaselineState();
        pass.draw(frame, drawn.maps, layer, scene::allCasters(*snapshot), drawn.depth, GL_DEPTH_COMPONENT24,
                  shadow_map::depthRules({}, {}));
    }
    return drawn;
}

/// All layers' texels, one after the other.
inline std::vector<vec4> momentTexels(shadow_map::MomentMaker& maker, const FilledMap& filled,
                                      const FilterParams& params) {
    const gl::ColorTextureArray moments = shadow_map::emptyMoments(params, filled.depth.side(), filled.maps.layers());
    maker.make(filled.depth, filled.maps, params, moments);
    const auto side = static_cast<std::size_t>(moments.side());
    std::vector<vec4> texels(side * side * static_cast<std::size_t>(moments.layers()));
    moments.bind(gl::kFirstFreeUnit);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA, GL_FLOAT, texels.data());
    gl::check("moments read back");
    return texels;
}

} // namespace shadowlab::testing
