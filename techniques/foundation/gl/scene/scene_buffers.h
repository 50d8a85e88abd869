// The scene on the graphics card: object-space floats, uploaded once per geometry revision and shared by all slots.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/emitter_contacts.h"

namespace shadowlab::gl {

/// Attribute locations of every vertex shader (shaders/attributes.glsl has the same numbers).
enum Attribute : GLuint { kPositionMesh = 0, kNormalMesh = 1, kExtrudable = 2, kTexcoordMesh = 3, kTriangleOfMesh = 4, kColorMesh = 5 };

/// A program that shades with all lights of a scene at once holds a bit for each in a word.
constexpr std::size_t kMostLightsAtOnce = 32;

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
    void bindAttributes(const scene::Mesh& mesh) const;
    BufferHandle positions_, normals_, texcoords_, colors_, numbers_, indices_, numberedIndices_;
    VertexArrayHandle vertexArray_, numberedArray_;
};

class SceneBuffers {
public:
    /// Uploads what the snapshot's revisions say is new.
    void update(const scene::Snapshot& snapshot);
    [[nodiscard]] const MeshBuffers& mesh(std::size_t object) const { return *objectMeshes_[object]; }
    /// The alpha mask of a part of an object (scene/model/holes.h): 255 where there is surface, rows from the bottom.
    /// nullptr: no holes.
    [[nodiscard]] const Texture2D* mask(std::size_t object, std::size_t part) const;
    [[nodiscard]] bool hasHoles(std::size_t object) const { return hasHoles_[object]; }
    [[nodiscard]] bool anyHoles() const { return !masks_.empty(); }
    /// The image that colours a part of an object (scene/model/surface_color.h), sRGB, rows from the bottom. Without one: white.
    [[nodiscard]] const Texture2D& colorImage(std::size_t object, std::size_t part) const;
    /// Has a surface not the same colour all over?
    [[nodiscard]] bool anyOwnColors() const { return anyOwnColors_; }
    /// Emitters that lie in another face, and so are drawn a little nearer or farther.
    [[nodiscard]] const scene::EmitterContacts& contacts() const { return contacts_; }
    /// Number of triangles in the objects before this one: triangle t of it has the scene-wide index base + t.
    [[nodiscard]] int triangleBase(std::size_t object) const { return triangleBases_[object]; }
    /// Boxes around the objects (scene::objectBounds), made when the scene changes.
    [[nodiscard]] const std::vector<scene::Bounds>& bounds() const { return bounds_; }
    /// The stored facing signs (scene/query/facing.h) of all triangles for one light; made when first asked for.
    [[nodiscard]] const TriangleTexture& facing(int light) const;
    /// The same of all lights, kMostLightsAtOnce at most: for each triangle a word of those on the side of its front, and one of those
    /// on that of its back, a bit for each light.
    [[nodiscard]] const TriangleTexture& facingOfAllLights() const;
    /// Copies a picture without its colours ("source": the picture's unit). Compiled once, at its first use: it is kept here because
    /// these buffers live as long as the context does.
    [[nodiscard]] const Program& greyed() const { return greyed_; }

private:
    void updateMasks();
    void updateColorImages();

    scene::Snapshot snapshot_;
    std::unordered_map<const scene::Mesh*, std::unique_ptr<MeshBuffers>> meshes_;
    std::vector<const MeshBuffers*> objectMeshes_;
    std::unordered_map<const scene::AlphaMask*, Texture2D> masks_;
    std::unordered_map<const scene::ColorImage*, Texture2D> colorImages_; ///< null: one white texel
    bool anyOwnColors_ = false;
    std::vector<bool> hasHoles_; ///< per object
    std::vector<int> triangleBases_;
    std::vector<scene::Bounds> bounds_;
    scene::EmitterContacts contacts_;
    mutable std::map<int, TriangleTexture> facing_;
    mutable std::optional<TriangleTexture> facingOfAllLights_;
    Program greyed_{"fullscreen.vert", "greyed.frag"};
};

/// A static buffer holding `data`.
template <typename T>
BufferHandle uploadBuffer(GLenum target, const std::vector<T>& data) {
    BufferHandle buffer = BufferHandle::create();
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
    buffer.holds(static_cast<std::int64_t>(data.size() * sizeof(T)));
    return buffer;
}

} // namespace shadowlab::gl
