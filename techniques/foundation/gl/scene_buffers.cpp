// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene_buffers.h"

#include "techniques/foundation/scene/facing.h"
#include "techniques/foundation/scene/holes.h"

namespace shadowlab::gl {

MeshBuffers::MeshBuffers(const scene::Mesh& mesh) : vertexArray_(VertexArrayHandle::create()) {
    glBindVertexArray(vertexArray_.id());
    positions_ = uploadBuffer(GL_ARRAY_BUFFER, mesh.positionsMesh);
    glEnableVertexAttribArray(kPositionMesh);
    glVertexAttribPointer(kPositionMesh, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    normals_ = uploadBuffer(GL_ARRAY_BUFFER, mesh.normalsMesh);
    glEnableVertexAttribArray(kNormalMesh);
    glVertexAttribPointer(kNormalMesh, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    if (!mesh.texcoords.empty()) {
        texcoords_ = uploadBuffer(GL_ARRAY_BUFFER, mesh.texcoords);
        glEnableVertexAttribArray(kTexcoordMesh);
        glVertexAttribPointer(kTexcoordMesh, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    indices_ = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    glBindVertexArray(0);
}

void MeshBuffers::draw(std::uint32_t firstTriangle, std::uint32_t triangleCount) const {
    glBindVertexArray(vertexArray_.id());
    const auto offset = static_cast<std::uintptr_t>(firstTriangle) * sizeof(uvec3);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangleCount), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
    glBindVertexArray(0);
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

} // namespace

void SceneBuffers::update(const scene::Snapshot& snapshot) {
    if (snapshot == snapshot_) return;
    const bool sameGeometry = snapshot_ && snapshot_->revisions.geometry == snapshot->revisions.geometry;
    const bool samePlaces = sameGeometry && snapshot_->revisions.transforms == snapshot->revisions.transforms;
    if (!samePlaces || snapshot_->revisions.lights != snapshot->revisions.lights) facing_.clear();
    if (!samePlaces) bounds_ = scene::objectBounds(*snapshot);
    // The previous snapshot keeps its meshes alive until the new ones have been matched by address.
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
}

/// Those of the snapshot; what was uploaded for the one before stays. Masks are told apart by address: `previous` in update()
/// keeps the old ones alive until then.
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

const Texture2D* SceneBuffers::mask(std::size_t object, std::size_t part) const {
    const scene::AlphaMask* mask = scene::maskOfPart(*snapshot_, snapshot_->objects[object], part);
    return mask ? &masks_.at(mask) : nullptr;
}

const ByteBufferTexture& SceneBuffers::facing(int light) const {
    const auto found = facing_.find(light);
    if (found != facing_.end()) return found->second;
    return facing_
        .emplace(light, ByteBufferTexture(facingSigns(*snapshot_, snapshot_->lights[static_cast<std::size_t>(light)]),
                                          "facing signs"))
        .first->second;
}

} // namespace shadowlab::gl
