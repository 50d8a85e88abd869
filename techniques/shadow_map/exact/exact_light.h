// The exact shadow map of one light: the map decides the pixels for which it is certain, and rays decide the others.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_map/exact/exact_pass.h"
#include "techniques/shadow_map/map_tools.h"

namespace shadowlab::shadow_map {

class ExactLight {
public:
    explicit ExactLight(MapTools& tools) : tools_(tools) {}

    /// False when the time came first.
    bool prepare(const scene::Snapshot& snapshot, Deadline deadline) { return pass_.prepare(snapshot, deadline); }
    void beginFrame() { pass_.beginFrame(); }
    /// The light's map with the triangle that each texel sees, and with the loose edges in each texel.
    LightShadowMap updateMap(Frame& frame, int light);
    /// Visibility of every pixel: 0 or 1.
    const gl::Texture2D& decide(Frame& frame, int light, const LightShadowMap& map);
    /// The stage `traced`: which pixels the map decided, and which a ray.
    void publishTraced(Frame& frame, int light, const LightShadowMap& map);
    [[nodiscard]] const trace::SceneTracer& tracer() const { return pass_.tracer(); }

private:
    void drawLayer(const Frame& frame, int light, const LightMaps& maps, int layer,
                   std::span<const std::size_t> casters, const gl::DepthTextureArray& depth,
                   const ExactTextures& textures);
    [[nodiscard]] std::vector<std::size_t> drawnCasters(const scene::Scene& scene, int light) const;
    void setUniforms(const gl::Program& program, int light, const LightShadowMap& map) const;

    MapTools& tools_;
    ExactPass pass_;
};

} // namespace shadowlab::shadow_map
