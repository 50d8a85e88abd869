// A mesh on the graphics card: mesh-space floats, and its triangles in the mesh's own order or in another one.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::gl {

/// Attribute locations of every vertex shader (shaders/attributes.glsl has the same numbers).
enum Attribute : GLuint { kPositionMesh = 0, kNormalMesh = 1, kExtrudable = 2, kTexcoordMesh = 3, kTriangleOfMesh = 4, kColorMesh = 5 };

/// A static buffer holding `data`.
template <typename T>
BufferHandle uploadBuffer(GLenum target, const std::vector<T>& data) {
    BufferHandle buffer = BufferHandle::create();
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
    buffer.holds(static_cast<std::int64_t>(data.size() * sizeof(T)));
    return buffer;
}

/// Vertex and index buffers of one mesh.
class MeshBuffers {
public:
    explicit MeshBuffers(const scene::Mesh& mesh);
    /// Draws a run of triangles in the mesh's own order.
    void draw(std::uint32_t firstTriangle, std::uint32_t triangleCount) const;
    /// The same for programs that ask which triangle they draw (shaders/triangle.glsl). Positions, order and so depths are the
    /// same, but there are more vertices: each triangle's last one is its own.
    void drawNumbered(std::uint32_t firstTriangle, std::uint32_t triangleCount) const;
    /// Three floats per vertex, tightly packed, the mesh's own vertices first: for drawing the very same positions with other
    /// indices.
    [[nodiscard]] GLuint positionBuffer() const { return positions_.id(); }

private:
    friend class OrderedTriangles;
    void bindAttributes(const scene::Mesh& mesh) const;
    void bindNumbers() const;
    std::vector<uvec3> numberedTriangles_; ///< the mesh's, each with a last vertex of its own
    BufferHandle positions_, normals_, texcoords_, colors_, numbers_, indices_, numberedIndices_;
    VertexArrayHandle vertexArray_, numberedArray_;
};

/// The triangles of a mesh in another order.
class OrderedTriangles {
public:
    /// The buffers of the mesh must outlive it.
    OrderedTriangles(const scene::Mesh& mesh, const MeshBuffers& buffers, const std::vector<std::uint32_t>& order);
    /// Counted in that order.
    void draw(std::uint32_t first, std::uint32_t count) const;
    /// As MeshBuffers::drawNumbered: each triangle has the number that it has in the mesh.
    void drawNumbered(std::uint32_t first, std::uint32_t count) const;

private:
    BufferHandle indices_, numberedIndices_;
    VertexArrayHandle vertexArray_, numberedArray_;
};

} // namespace shadowlab::gl
