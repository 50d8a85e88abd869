// What a texel of a shadow map holds, found on the processor in double: the same triangles, the same offset, the same rules as
// the depth pass.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "techniques/shadow_map/maps/depth_pass.h"

namespace shadowlab::shadow_map {

struct TexelDepth {
    double first = 1,
           stored = 1;  ///< of the first surface at the texel's centre; what is stored, offset included. 1: nothing
    double clamped = 0; ///< what the first surface's depth would be if nothing were clamped: negative before the map
    std::size_t object = 0; ///< that the first surface is of, and its triangle
    std::uint32_t triangle = 0;
    [[nodiscard]] bool isEmpty() const { return stored >= 1; }
};

/// A depth as the format keeps it: rounded to its nearest step.
double asKept(ShadowMapParams::DepthFormat format, double depth);

/// One layer of a light's maps.
class TexelDepths {
public:
    struct Asked {
        const scene::Scene& scene;
        const LightMaps& maps;
        int layer = 0;
        std::span<const std::size_t> casters;
        std::span<const scene::Bounds> bounds; ///< of all objects
        const ShadowMapParams& params;
        DepthRules rules;
    };
    explicit TexelDepths(const Asked& asked);

    /// Outside of the map: nothing, or its border, as the parameters say.
    [[nodiscard]] TexelDepth at(const ivec2& texel) const;

private:
    struct Triangle {
        std::array<dvec4, 3> clip; ///< the light's
        /// Around its places in the map, in normalised device coordinates; without end where it reaches behind the light.
        dvec2 lowerNdc{0.0}, upperNdc{0.0};
        std::size_t object = 0;
        std::uint32_t triangle = 0;
        bool isLeftOut = false; ///< a back face that is not drawn: it counts as a second surface alone
        bool hasHoles = false;
    };
    struct Depth {
        double own = 1, pushed = 1; ///< without and with the offset of glPolygonOffset
    };
    [[nodiscard]] std::optional<Depth> depthOf(const Triangle& triangle, const dvec2& ndc) const;

    const scene::Scene& scene_;
    ShadowMapParams params_;
    DepthRules rules_;
    std::vector<Triangle> triangles_;
};

} // namespace shadowlab::shadow_map
