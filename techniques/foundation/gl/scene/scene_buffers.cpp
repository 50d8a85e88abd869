// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/scene_buffers.h"

#include <array>
#include <cstdint>
#include <span>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/facing.h"

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

void drawTriangles(const VertexArrayHandle& array, std::uint32_t first, std::uint32_t count) {
    glBindVertexArray(array.id());
    const auto offset = static_cast<std::uintptr_t>(first) * sizeof(uvec3);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
    glBindVertexArray(0);
}

} // namespace

MeshBuffers::MeshBuffers(const scene::Mesh& mesh)
    : vertexArray_(VertexArrayHandle::create()), numberedArray_(VertexArrayHandle::create()) {
    const NumberedTriangles withNumbers = numbered(mesh);
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
    glBindBuffer(GL_ARRAY_BUFFER, numbers_.id());
    glEnableVertexAttribArray(kTriangleOfMesh);
    glVertexAttribIPointer(kTriangleOfMesh, 1, GL_INT, 0, nullptr);
    numberedIndices_ = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, withNumbers.triangles);
    glBindVertexArray(0);
}

void MeshBuffers::bindAttributes(const scene::Mesh& mesh) const {
    const auto bind = [](const BufferHandle& buffer, GLuint attribute, GLint floats) {
        glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, floats, GL_FLOAT, GL_FALSE, 0, nullptr);
    };
    bind(positions_, kPositionMesh, 3);
    bind(normals_, kNormalMesh, 3);
    if (!mesh.texcoords.empty()) bind(texcoords_, kTexcoordMesh, 2);
    if (!mesh.colors.empty()) bind(colors_, kColorMesh, 3);
}

void MeshBuffers::draw(std::uint32_t firstTriangle, std::uint32_t triangleCount) const {
    drawTriangles(vertexArray_, firstTriangle, triangleCount);
}

void MeshBuffers::drawNumbered(std::uint32_t firstTriangle, std::uint32_t triangleCount) const {
    drawTriangles(numberedArray_, firstTriangle, triangleCount);
}

namespace {

Texture2D uploadMask(const scene::AlphaMask& mask) {
    Texture2D texture(GL_R8, mask.size(), "alpha mask");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, mask.size().x, mask.size().y, GL_RED, GL_UNSIGNED_BYTE,
                    mask.texels().data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return texture;
}

Texture2D uploadColors(const scene::ColorImage* image) {
    constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};
    const ivec2 size = image ? image->size() : ivec2(1);
    Texture2D texture(GL_SRGB8_ALPHA8, size, "colour image");
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, image ? image->texels().data() : kWhite.data());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    return texture;
}

} // namespace

void SceneBuffers::update(const scene::Snapshot& snapshot) {
    if (snapshot == snapshot_) return;
    const bool sameGeometry = snapshot_ && snapshot_->revisions.geometry == snapshot->revisions.geometry;
    const bool samePlaces = sameGeometry && snapshot_->revisions.transforms == snapshot->revisions.transforms;
    if (!samePlaces || snapshot_->revisions.lights != snapshot->revisions.lights) {
        facing_.clear();
        facingOfAllLights_.reset();
    }
    if (!snapshot_ || !scene::EmitterContacts::areThoseOf(*snapshot_, *snapshot))
        contacts_ = scene::EmitterContacts(*snapshot);
    if (!samePlaces) bounds_ = scene::objectBounds(*snapshot);
    // The previous snapshot is kept until the end of the function, so that no new mesh has the address of an old one.
    const scene::Snapshot previous = std::exchange(snapshot_, snapshot);
    std::unordered_map<const scene::Mesh*, std::unique_ptr<MeshBuffers>> known = std::exchange(meshes_, {});
    objectMeshes_.clear();
    triangleBases_.clear();
    int triangles = 0;
    for (const scene::Object& object : snapshot->objects) {
        std::unique_ptr<MeshBuffers>& buffers = meshes_[object.mesh.get()];
        if (!buffers) {
            const auto old = known.find(object.mesh.get());
            buffers = old != known.end() ? std::move(old->second) : std::make_unique<MeshBuffers>(*object.mesh);
        }
        objectMeshes_.push_back(buffers.get());
        triangleBases_.push_back(triangles);
        triangles += static_cast<int>(object.mesh->triangles.size());
    }
    updateMasks();
    updateColorImages();
}

/// Uploads the masks of the snapshot that are new. The cache key of a mask is its address; `previous` in update() keeps the
/// old ones alive meanwhile.
void SceneBuffers::updateMasks() {
    std::unordered_map<const scene::AlphaMask*, Texture2D> known = std::exchange(masks_, {});
    hasHoles_.clear();
    for (const scene::Object& object : snapshot_->objects) {
        hasHoles_.push_back(scene::hasHoles(*snapshot_, object));
        for (std::size_t part = 0; part < object.mesh->parts.size(); ++part) {
            const scene::AlphaMask* mask = scene::maskOfPart(*snapshot_, object, part);
            if (!mask || masks_.contains(mask)) continue;
            const auto old = known.find(mask);
            masks_.emplace(mask, old != known.end() ? std::move(old->second) : uploadMask(*mask));
        }
    }
}

/// As updateMasks.
void SceneBuffers::updateColorImages() {
    std::unordered_map<const scene::ColorImage*, Texture2D> known = std::exchange(colorImages_, {});
    anyOwnColors_ = scene::hasOwnColors(*snapshot_);
    if (!anyOwnColors_) return;
    const auto keep = [&](const scene::ColorImage* image) {
        if (colorImages_.contains(image)) return;
        const auto old = known.find(image);
        colorImages_.emplace(image, old != known.end() ? std::move(old->second) : uploadColors(image));
    };
    keep(nullptr);
    for (const scene::Object& object : snapshot_->objects)
        for (std::size_t part = 0; part < object.mesh->parts.size(); ++part)
            keep(scene::colorImageOfPart(*snapshot_, object, part));
}

const Texture2D& SceneBuffers::colorImage(std::size_t object, std::size_t part) const {
    return colorImages_.at(scene::colorImageOfPart(*snapshot_, snapshot_->objects[object], part));
}

const Texture2D* SceneBuffers::mask(std::size_t object, std::size_t part) const {
    const scene::AlphaMask* mask = scene::maskOfPart(*snapshot_, snapshot_->objects[object], part);
    return mask ? &masks_.at(mask) : nullptr;
}

const TriangleTexture& SceneBuffers::facing(int light) const {
    const auto found = facing_.find(light);
    if (found != facing_.end()) return found->second;
    return facing_.emplace(light, TriangleTexture(facingSigns(*snapshot_, snapshot_->light(light)), "facing signs"))
        .first->second;
}

const TriangleTexture& SceneBuffers::facingOfAllLights() const {
    if (facingOfAllLights_) return *facingOfAllLights_;
    std::vector<uvec2> sides;
    for (std::size_t light = 0; light < snapshot_->lights.size(); ++light) {
        const std::vector<std::int8_t> signs = facingSigns(*snapshot_, snapshot_->lights[light]);
        sides.resize(signs.size(), uvec2(0));
        for (std::size_t triangle = 0; triangle < signs.size(); ++triangle) {
            sides[triangle].x |= (signs[triangle] > 0 ? 1u : 0u) << light;
            sides[triangle].y |= (signs[triangle] < 0 ? 1u : 0u) << light;
        }
    }
    return facingOfAllLights_.emplace(sides, "facing signs of all lights");
}

} // namespace shadowlab::gl
