// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/mesh_buffers.h"

#include <span>
#include <utility>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::gl {

namespace {

/// The triangles of a mesh, each with a last vertex that no other triangle has for its last.
struct NumberedTriangles {
    std::vector<std::uint32_t> copied; ///< of which vertex of the mesh each one beyond them is a copy
    std::vector<std::int32_t>
        numbers; ///< for each vertex, the triangle that it is the last one of; 0 where there is none
    std::vector<uvec3> triangles;
};

NumberedTriangles numbered(const scene::Mesh& mesh) {
    const std::size_t vertices = mesh.positionsMesh.size();
    NumberedTriangles result{{}, std::vector<std::int32_t>(vertices, 0), mesh.triangles};
    std::vector<bool> isTaken(vertices, false);
    for (std::size_t t = 0; t < result.triangles.size(); ++t) {
        std::uint32_t& last = result.triangles[t].z;
        if (!isTaken[last]) {
            isTaken[last] = true;
            result.numbers[last] = static_cast<std::int32_t>(t);
            continue;
        }
        result.copied.push_back(last);
        result.numbers.push_back(static_cast<std::int32_t>(t));
        last = static_cast<std::uint32_t>(vertices + result.copied.size() - 1);
    }
    return result;
}

/// The values of the mesh's vertices, then those of the copies.
template <typename T>
BufferHandle uploadWithCopies(std::vector<T> values, std::span<const std::uint32_t> copied) {
    values.reserve(values.size() + copied.size());
    for (const std::uint32_t vertex : copied)
        values.push_back(values[vertex]);
    return uploadBuffer(GL_ARRAY_BUFFER, values);
}

void bind(const BufferHandle& buffer, GLuint attribute, GLint floats) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, floats, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void drawTriangles(const VertexArrayHandle& array, std::uint32_t first, std::uint32_t count) {
    glBindVertexArray(array.id());
    const auto offset = static_cast<std::uintptr_t>(first) * sizeof(uvec3);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
    glBindVertexArray(0);
}

} // namespace

MeshBuffers::MeshBuffers(const scene::Mesh& mesh)
    : weldedTriangles_(scene::weldedTriangles(mesh)), vertexArray_(VertexArrayHandle::create()),
      numberedArray_(VertexArrayHandle::create()), positionArray_(VertexArrayHandle::create()) {
    NumberedTriangles withNumbers = numbered(mesh);
    positions_ = uploadWithCopies(mesh.positionsMesh, withNumbers.copied);
    normals_ = uploadWithCopies(mesh.normalsMesh, withNumbers.copied);
    if (!mesh.texcoords.empty()) texcoords_ = uploadWithCopies(mesh.texcoords, withNumbers.copied);
    if (!mesh.colors.empty()) colors_ = uploadWithCopies(mesh.colors, withNumbers.copied);
    numbers_ = uploadBuffer(GL_ARRAY_BUFFER, withNumbers.numbers);
    glBindVertexArray(vertexArray_.id());
    bindAttributes(mesh);
    indices_ = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    glBindVertexArray(numberedArray_.id());
    bindAttributes(mesh);
    bindNumbers();
    numberedIndices_ = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, withNumbers.triangles);
    glBindVertexArray(positionArray_.id());
    bindPositions();
    weldedIndices_ = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, weldedTriangles_);
    glBindVertexArray(0);
    numberedTriangles_ = std::move(withNumbers.triangles);
}

void MeshBuffers::bindPositions() const { bind(positions_, kPositionMesh, 3); }

void MeshBuffers::bindAttributes(const scene::Mesh& mesh) const {
    bindPositions();
    bind(normals_, kNormalMesh, 3);
    if (!mesh.texcoords.empty()) bind(texcoords_, kTexcoordMesh, 2);
    if (!mesh.colors.empty()) bind(colors_, kColorMesh, 3);
}

void MeshBuffers::bindNumbers() const {
    glBindBuffer(GL_ARRAY_BUFFER, numbers_.id());
    glEnableVertexAttribArray(kTriangleOfMesh);
    glVertexAttribIPointer(kTriangleOfMesh, 1, GL_INT, 0, nullptr);
}

void MeshBuffers::draw(std::uint32_t firstTriangle, std::uint32_t triangleCount) const {
    drawTriangles(vertexArray_, firstTriangle, triangleCount);
}

void MeshBuffers::drawNumbered(std::uint32_t firstTriangle, std::uint32_t triangleCount) const {
    drawTriangles(numberedArray_, firstTriangle, triangleCount);
}

void MeshBuffers::drawPositions(std::uint32_t firstTriangle, std::uint32_t triangleCount) const {
    drawTriangles(positionArray_, firstTriangle, triangleCount);
}

template <typename Bind>
OrderedTriangles::Uploaded OrderedTriangles::upload(const std::vector<uvec3>& triangles, const Bind& bindVertices) const {
    std::vector<uvec3> ordered;
    ordered.reserve(order_.size());
    for (const std::uint32_t triangle : order_)
        ordered.push_back(triangles[triangle]);
    Uploaded uploaded{VertexArrayHandle::create(), {}};
    glBindVertexArray(uploaded.array.id());
    bindVertices();
    uploaded.indices = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, ordered);
    glBindVertexArray(0);
    return uploaded;
}

void OrderedTriangles::draw(std::uint32_t first, std::uint32_t count) const {
    if (!plain_) plain_ = upload(mesh_->triangles, [&] { buffers_->bindAttributes(*mesh_); });
    drawTriangles(plain_->array, first, count);
}

void OrderedTriangles::drawNumbered(std::uint32_t first, std::uint32_t count) const {
    const auto bindAll = [&] {
        buffers_->bindAttributes(*mesh_);
        buffers_->bindNumbers();
    };
    if (!numbered_) numbered_ = upload(buffers_->numberedTriangles_, bindAll);
    drawTriangles(numbered_->array, first, count);
}

void OrderedTriangles::drawPositions(std::uint32_t first, std::uint32_t count) const {
    if (!positions_) positions_ = upload(buffers_->weldedTriangles_, [&] { buffers_->bindPositions(); });
    drawTriangles(positions_->array, first, count);
}

} // namespace shadowlab::gl
