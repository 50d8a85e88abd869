// SPDX-License-Identifier: MIT
#include "techniques/planar/caster_buffers.h"

#include "techniques/foundation/gl/scene_buffers.h"
#include "techniques/technique.h"

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
    perLight_.clear();
    vertexArray_ = gl::VertexArrayHandle::create();
    glBindVertexArray(vertexArray_.id());
    positions_ = gl::uploadBuffer(GL_ARRAY_BUFFER, casters.positionsCaster());
    glVertexAttribPointer(gl::kPositionMesh, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(gl::kPositionMesh);
    indices_ = gl::uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, casters.triangles());
    glBindVertexArray(0);
}

GLuint CasterBuffers::indicesFor(const Casters& casters, int light) {
    if (light == kNoLight || casters.edgeOn(light).empty()) return indices_.id();
    OfLight& own = perLight_[light];
    if (own.edgeOn != casters.edgeOn(light)) {
        std::vector<uvec3> triangles = casters.triangles();
        for (const std::uint32_t t : casters.edgeOn(light))
            triangles[t] = uvec3(triangles[t].x); // a point: nothing is drawn, and all others keep their places
        own.edgeOn = casters.edgeOn(light);
        own.indices = gl::uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles);
    }
    return own.indices.id();
}

void CasterBuffers::draw(const Casters& casters, int light, const DrawList& list) {
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indicesFor(casters, light));
    glMultiDrawElements(GL_TRIANGLES, list.counts.data(), GL_UNSIGNED_INT, list.offsets.data(),
                        static_cast<GLsizei>(list.counts.size()));
    glBindVertexArray(0);
}

} // namespace shadowlab::planar
