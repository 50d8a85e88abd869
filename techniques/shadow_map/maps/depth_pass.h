// Drawing what the light sees: the depths of one map.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/frame.h"
#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// Of the parameters, what the depths themselves depend on.
struct DepthRules {
    double slopeFactor = 0; ///< glPolygonOffset: depths are pushed back by so many times their slope, and
    double units = 0;       ///< by so many of the format's smallest steps
    bool depthClamp = true; ///< keep what is nearer than the near plane
    bool dual = false;      ///< the middle between two surfaces
    friend bool operator==(const DepthRules&, const DepthRules&) = default;
};
DepthRules depthRules(const ShadowMapParams& params, const FilterParams& filter);

class DepthPass {
public:
    /// Draws one layer, of the scene's objects with these numbers. Baseline state is set; leaves another.
    void draw(const Frame& frame, const LightMaps& maps, int layer, std::span<const std::size_t> casters,
              const gl::DepthTextureArray& depth, GLenum format, const DepthRules& rules) const;
    /// The same with the number of the triangle that is seen in each texel; kNothing where none is.
    void drawWithIds(const Frame& frame, const LightMaps& maps, int layer, std::span<const std::size_t> casters,
                     const gl::DepthTextureArray& depth, const gl::IdTextureArray& ids, const DepthRules& rules) const;
    static constexpr std::uint32_t kNothing = ~std::uint32_t{0};

private:
    void drawCasters(const gl::Program& program, const Frame& frame, const LightMaps& maps, int layer,
                     std::span<const std::size_t> casters) const;
    void drawDual(const Frame& frame, const LightMaps& maps, int layer, std::span<const std::size_t> casters,
                  const gl::DepthTextureArray& depth, GLenum format, const DepthRules& rules) const;

    gl::Program ids_{"position.vert", "triangle_id.frag"};
    gl::Program depth_{"position.vert", "nothing.frag"};
    gl::Program secondDepth_{"position.vert", "shadow_map/second_depth.frag"};
    gl::Program dualDepth_{"fullscreen.vert", "shadow_map/dual_depth.frag"};
};

} // namespace shadowlab::shadow_map
