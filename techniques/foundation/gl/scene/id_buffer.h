// An item buffer: for each pixel the number of the triangle that the rasteriser shows there.
//
// Drawn with the same vertices in the same order through the same expression as the surfaces (surfaces.h), so it gives
// exactly the triangle that a technique shades there. It is not the truth: where an edge passes the centre of a pixel more
// closely than the rasteriser rounds, a ray may hit the neighbour. The caller has to check with a ray. Saito and Takahashi,
// "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990 (item buffers are older: Weghorst, Hooper and Greenberg,
// "Improved Computational Methods for Ray Tracing", ACM Transactions on Graphics 1984).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/scene/surfaces.h"

namespace shadowlab::gl {

class IdBuffer {
public:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0}; ///< no surface covers the centre of the pixel

    /// Draws all surfaces, those that cast no shadow too, from the state of baseline.h, which it sets. `buffers` must be
    /// up to date with the scene. The buffers of the last size are kept for the next call.
    /// Throws Error (overLimit) when the size exceeds what the driver can do.
    void draw(const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye, ivec2 size);

    /// What was drawn, size.x * size.y numbers, row 0 on top: triangles counted through all objects in the scene's order,
    /// as in trace::WorldTriangles, or kNone.
    [[nodiscard]] std::vector<std::uint32_t> read() const;

private:
    Program program_{"position.vert", "triangle_id.frag"};
    Texture2D ids_, depthStencil_;
    Framebuffer framebuffer_;
};

} // namespace shadowlab::gl
