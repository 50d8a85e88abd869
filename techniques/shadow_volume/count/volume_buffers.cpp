// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/volume_buffers.h"

namespace shadowlab::shadow_volume {

ExtrusionVertices::ExtrusionVertices(const scene::Mesh& mesh) {
    std::vector<vec4> vertices;
    vertices.reserve(2 * mesh.positionsMesh.size());
    for (const float extrudable : {0.0f, 1.0f})
        for (const vec3& positionMesh : mesh.positionsMesh)
            vertices.emplace_back(positionMesh, extrudable);
    vertices_ = gl::uploadBuffer(GL_ARRAY_BUFFER, vertices);
}

void ExtrusionVertices::bindAttributes() const {
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glEnableVertexAttribArray(gl::kPositionMesh);
    glVertexAttribPointer(gl::kPositionMesh, 3, GL_FLOAT, GL_FALSE, sizeof(vec4), nullptr);
    glEnableVertexAttribArray(gl::kExtrudable);
    glVertexAttribPointer(gl::kExtrudable, 1, GL_FLOAT, GL_FALSE, sizeof(vec4),
                          reinterpret_cast<const void*>(sizeof(vec3)));
}

void VolumeBuffers::Run::fill(const std::function<void()>& bindAttributes, const std::vector<std::uint32_t>& data) {
    count = static_cast<GLsizei>(data.size());
    if (count == 0) return;
    vertexArray = gl::VertexArrayHandle::create();
    glBindVertexArray(vertexArray.id());
    bindAttributes();
    indices = gl::uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, data);
    glBindVertexArray(0);
}

void VolumeBuffers::Run::draw(GLenum mode, GLsizei firstShare) const {
    if (count == 0) return;
    glBindVertexArray(vertexArray.id());
    glDrawElements(mode, count / firstShare, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

VolumeBuffers::VolumeBuffers(const Volume& volume, std::span<const SilhouetteEdge> silhouette,
                             const std::function<void()>& bindAttributes) {
    topCap_.fill(bindAttributes, volume.topCap);
    topCapReversed_.fill(bindAttributes, volume.topCapReversed);
    sides_.fill(bindAttributes, volume.sides);
    bottomCap_.fill(bindAttributes, volume.bottomCap);
    std::vector<std::uint32_t> ordinary, boundary, multiple;
    for (const SilhouetteEdge& edge : silhouette) {
        std::vector<std::uint32_t>& lines = edge.triangles == 1 ? boundary : edge.triangles == 2 ? ordinary : multiple;
        lines.insert(lines.end(), {edge.a, edge.b});
    }
    silhouette_.fill(bindAttributes, ordinary);
    boundary_.fill(bindAttributes, boundary);
    multiple_.fill(bindAttributes, multiple);
}

void setFrontFace(const scene::Object& object, bool clockwise) {
    glFrontFace(scene::isMirrored(object) != clockwise ? GL_CW : GL_CCW);
}

} // namespace shadowlab::shadow_volume
