// A mesh on the graphics card: mesh-space floats, and its triangles in the mesh's own order or in another one.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
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
    /// The same for programs that read positions alone: vertices at one place are one.
    void drawPositions(std::uint32_t firstTriangle, std::uint32_t triangleCount) const;
    /// Three floats per vertex, tightly packed, the mesh's own vertices first: for drawing the very same positions with other
    /// indices.
    [[nodiscard]] GLuint positionBuffer() const { return positions_.id(); }

private:
    friend class OrderedTriangles;
    void bindAttributes(const scene::Mesh& mesh) const;
    void bindNumbers() const;
    void bindPositions() const;
    std::vector<uvec3> numberedTriangles_; ///< the mesh's, each with a last vertex of its own
    std::vector<uvec3> weldedTriangles_;   ///< the mesh's, of vertices that stand for others at their place
    BufferHandle positions_, normals_, texcoords_, colors_, numbers_, indices_, numberedIndices_, weldedIndices_;
    VertexArrayHandle vertexArray_, numberedArray_, positionArray_;
};

/// Some triangles of a mesh, in another order. Each of the three ways to draw them is uploaded when it is first asked for: a shadow map asks
/// for one alone.
class OrderedTriangles {
public:
    /// The mesh and its buffers must outlive it.
    OrderedTriangles(const scene::Mesh& mesh, const MeshBuffers& buffers, std::vector<std::uint32_t> order)
        : mesh_(&mesh), buffers_(&buffers), order_(std::move(order)) {}
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
    /// Counted in that order.
    void draw(std::uint32_t first, std::uint32_t count) const;
    /// As MeshBuffers::drawNumbered: each triangle has the number that it has in the mesh.
    void drawNumbered(std::uint32_t first, std::uint32_t count) const;
    /// As MeshBuffers::drawPositions.
    void drawPositions(std::uint32_t first, std::uint32_t count) const;

private:
    struct Uploaded {
        VertexArrayHandle array;
        BufferHandle indices;
    };
    /// `bindVertices` binds what the vertices of these triangles have.
    template <typename Bind>
    [[nodiscard]] Uploaded upload(const std::vector<uvec3>& triangles, const Bind& bindVertices) const;

    const scene::Mesh* mesh_;
    const MeshBuffers* buffers_;
    std::vector<std::uint32_t> order_;
    mutable std::optional<Uploaded> plain_, numbered_, positions_;
};

} // namespace shadowlab::gl
