// The list of casting triangles on the graphics card, and how parts of it are drawn in one call.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/handle.h"
#include "techniques/planar/casters.h"

namespace shadowlab::planar {

/// Some of the casters in the list: the arguments of glMultiDrawElements.
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
    void draw(const DrawList& list) const;

private:
    std::uint64_t listRevision_ = 0;
    gl::BufferHandle positions_, indices_;
    gl::VertexArrayHandle vertexArray_;
};

} // namespace shadowlab::planar
