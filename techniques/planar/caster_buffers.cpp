// SPDX-License-Identifier: MIT
#include "techniques/planar/caster_buffers.h"

#include "techniques/foundation/gl/scene_buffers.h"

namespace shadowlab::planar {

namespace {

const void* byteOffset(std::uint32_t triangle) {
    return reinterpret_cast<const void*>(std::uintptr_t{triangle} * sizeof(uvec3)); // GL takes offsets as pointers
}

} // namespace

void DrawList::add(const Caster& caster) {
    const auto count = static_cast<GLsizei>(3 * caster.triangleCount);
    if (!counts.empty()) {
        const auto end = reinterpret_cast<std::uintptr_t>(offsets.back()) +
                         static_cast<std::uintptr_t>(counts.back()) * sizeof(std::uint32_t);
        if (end == reinterpret_cast<std::uintptr_t>(byteOffset(caster.firstTriangle))) {
            counts.back() += count;
            return;
        }
    }
    counts.push_back(count);
    offsets.push_back(byteOffset(caster.firstTriangle));
}

void CasterBuffers::update(const Casters& casters) {
    if (listRevision_ == casters.listRevision()) return;
    listRevision_ = casters.listRevision();
    vertexArray_ = gl::VertexArrayHandle::create();
    glBindVertexArray(vertexArray_.id());
    positions_ = gl::uploadBuffer(GL_ARRAY_BUFFER, casters.positionsCaster());
    glVertexAttribPointer(gl::kPositionMesh, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(gl::kPositionMesh);
    indices_ = gl::uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, casters.triangles());
    glBindVertexArray(0);
}

void CasterBuffers::draw(const DrawList& list) const {
    glBindVertexArray(vertexArray_.id());
    glMultiDrawElements(GL_TRIANGLES, list.counts.data(), GL_UNSIGNED_INT, list.offsets.data(),
                        static_cast<GLsizei>(list.counts.size()));
    glBindVertexArray(0);
}

} // namespace shadowlab::planar
