// The list of casting triangles on the graphics card, and how parts of it are drawn in one call.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>

#include "techniques/foundation/gl/handle.h"
#include "techniques/planar/casters.h"

namespace shadowlab::planar {

/// Some of the casters, without holes: as the arguments of one glMultiDrawElements each.
struct DrawList {
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    /// Casters are to be added in their order: neighbours become one run.
    void add(const Caster& caster);
    [[nodiscard]] bool empty() const { return counts.empty(); }
};

class CasterBuffers {
public:
    /// Uploads what is new.
    void update(const Casters& casters);
    /// For one light's centre without the triangles that it sees edge-on; kNoLight: all triangles.
    void draw(const Casters& casters, int light, const DrawList& list);

private:
    GLuint indicesFor(const Casters& casters, int light);

    std::uint64_t listRevision_ = 0;
    gl::BufferHandle positions_, indices_;
    gl::VertexArrayHandle vertexArray_;
    struct OfLight {
        std::vector<std::uint32_t> edgeOn;
        gl::BufferHandle indices;
    };
    std::map<int, OfLight> perLight_; ///< of lights that see any triangle edge-on
};

} // namespace shadowlab::planar
