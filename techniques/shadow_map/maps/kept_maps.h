// Maps that stay from frame to frame: none is drawn again as long as what it was drawn from is the same.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/shadow_map/maps/depth_pass.h"

namespace shadowlab::shadow_map {

/// All that the depths of one layer depend on.
struct LayerOrigin {
    std::uint64_t geometry = 0, transforms = 0, materials = 0; ///< materials: their holes
    dvec3 originWorld{0.0};
    dmat4 lightClipFromLightRelative{1.0};
    std::vector<std::size_t> casters;
    DepthRules rules;
    int shaderReloads = 0;
    friend bool operator==(const LayerOrigin&, const LayerOrigin&) = default;
};

/// What a map needs to be certain of its answers.
struct ExactMap {
    gl::IdTextureArray triangles; ///< which one is the first at each texel's centre, counted through all objects
    gl::DepthTextureArray edges;  ///< the nearest loose edge in each texel
    ExactMap(int resolution, int layers, GLenum format)
        : triangles(resolution, layers, "triangles in the shadow map"),
          edges(format, resolution, layers, "edges in the shadow map") {
        edges.sample(gl::DepthSampling::depths);
    }
};

struct KeptMap {
    gl::DepthTextureArray depth;
    std::optional<ExactMap> exact;                     ///< only where that is asked for
    std::optional<gl::ColorTextureArray> moments;      ///< only where the filter asks for them
    FilterParams momentsFor;                           ///< what they were made for
    bool momentsAreCurrent = false;                    ///< made from these depths
    GLenum format = GL_NONE;                           ///< of the depths
    std::vector<std::optional<LayerOrigin>> drawnFrom; ///< per layer; none: not drawn, or not to be relied on
};

class KeptMaps {
public:
    /// The map of one light of several, of that size and format. Every light keeps its own while `allTexels`, of all of them
    /// together, are few enough for the memory; else they share one, and it is drawn anew for each.
    KeptMap& of(int light, std::size_t lights, double allTexels, const LightMaps& maps, int resolution, GLenum format,
                bool exact);

private:
    std::vector<KeptMap> maps_;
};

} // namespace shadowlab::shadow_map
