// The exact shadow map: where the map cannot be certain of its answer, a ray is traced.
//
// Beside each depth the map keeps which triangle was seen. A second map marks the texels touched by *loose edges*: those at which, as
// the light sees the scene, a surface may end, begin, or pass through another. In a texel that no such edge touches the surfaces lie
// over each other like sheets of paper: each covers the whole texel, and their order is the same everywhere in it. So what one light
// ray through the texel's centre finds is true of all rays through it. shaders/shadow_map/decide.frag asks whether the visible point
// lies on the first sheet; for all other pixels a ray is traced.
// After Hertel, Hormann and Westermann, "A Hybrid GPU Rendering Pipeline for Alias-Free Hard Shadows", Eurographics 2009, who call a
// texel uncertain where a triangle covers a part of it; here edges inside a surface do not count.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>

#include "techniques/foundation/trace/packets/pixel_rays.h"
#include "techniques/frame.h"
#include "techniques/shadow_map/exact/surface_crossings.h"
#include "techniques/shadow_map/exact/walk_buffers.h"
#include "techniques/shadow_map/fit/light_maps.h"

namespace shadowlab::shadow_map {

/// Edges of one light's casters, relative to the light: two points each.
struct LooseEdges {
    gl::VertexArrayHandle vertexArray;
    gl::BufferHandle points;
    int count = 0;
};

/// Which pixels the map decided, and what the rays said of the others; rows from below, as GL counts them.
struct Decisions {
    std::vector<std::uint8_t> byMap; ///< 0 in shadow, 255 lit, else undecided
    std::size_t traced = 0;
    gl::Texture2D visibility; ///< of every pixel
};

class ExactPass {
public:
    /// Makes ready for a scene: the tracer, and where surfaces pass through each other. False when the time came first.
    bool prepare(const scene::Snapshot& snapshot, Deadline deadline);
    void beginFrame() { decisions_.clear(); }

    /// Finds the edges of these casters (numbers of objects), if they are not those of the last time.
    void findEdges(const scene::Scene& scene, int light, const LightMaps& maps, std::span<const std::size_t> casters);
    /// Draws into each texel that they touch how near to the light they come there; 1 elsewhere.
    void drawEdges(const Frame& frame, const LightMaps& maps, int light, int layer,
                   std::span<const std::size_t> casters, const gl::DepthTextureArray& edgeDepths) const;

    /// Decides every pixel, once in a frame. `draw(program)` draws the receivers with it, the map's textures bound.
    const Decisions& decide(Frame& frame, int light, const std::function<void()>& draw);
    /// Of the scene that it was prepared for.
    [[nodiscard]] const trace::SceneTracer& tracer() const { return tracer_; }
    [[nodiscard]] bool isDecided(int light) const { return decisions_.contains(light); }
    [[nodiscard]] const Decisions& decisions(int light) const { return decisions_.at(light); }
    void publishTraced(Frame& frame, int light) const;

    /// For the shader that walks over a light's casters; findEdges has been called for it.
    void bindWalk(const gl::Program& program, int light, int positionUnit, int triangleUnit) const;

private:
    /// What a light's edges depend on.
    struct EdgesCacheKey {
        std::uint64_t geometry = 0, transforms = 0, materials = 0;
        scene::Light light;
        dvec3 originWorld{0.0};
        std::vector<std::size_t> casters;
        friend bool operator==(const EdgesCacheKey&, const EdgesCacheKey&) = default;
    };
    struct CachedEdges {
        std::optional<EdgesCacheKey> foundFor;
        LooseEdges edges;
        gl::TableTexture positions;
    };

    trace::SceneTracer tracer_;
    trace::PixelRays rays_;
    Topologies topologies_;
    std::pair<std::uint64_t, std::uint64_t> walkedRevisions_{0, 0};
    gl::TableTexture triangles_;
    std::pair<std::uint64_t, std::uint64_t> crossedRevisions_{0, 0};
    std::vector<Crossing> crossings_;
    std::map<int, CachedEdges> edges_; ///< per light
    std::map<int, Decisions> decisions_;
    gl::Program whole_{"position.vert", "nothing.frag"};
    gl::Program looseEdge_{"shadow_map/loose_edge.vert", "nothing.frag"};
};

} // namespace shadowlab::shadow_map
