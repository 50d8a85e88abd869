// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/scene_buffers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/facing.h"

namespace shadowlab::gl {

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

// The eye, and a light that has moved since: two pictures of one scene have the same ones.
constexpr std::size_t kMostViewers = 4;

/// One viewer, found from two projections of another near plane or width: apart by their rounding, a millionth of what a list leaves open.
bool isSameViewer(const dvec4& one, const dvec4& other) {
    constexpr double kRounding = 1e-9;
    return one.w == other.w && glm::distance(dvec3(one), dvec3(other)) <= kRounding * glm::length(dvec3(one));
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
    if (!sameGeometry) fronts_.clear();
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
    updateSeenRuns();
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

void SceneBuffers::updateSeenRuns() {
    std::shared_ptr<const scene::CoincidentFaces> coincident = scene::CoincidentFaces::of(*snapshot_);
    if (coincident == coincident_) return;
    coincident_ = std::move(coincident);
    const auto known = std::exchange(ordered_, {}); // an object that is dragged is drawn as before
    seenRuns_.clear();
    const std::vector<scene::SeenSides> sides = scene::seenSides(*snapshot_, *coincident_);
    for (std::size_t o = 0; o < snapshot_->objects.size(); ++o) {
        const scene::Mesh& mesh = *snapshot_->objects[o].mesh;
        const auto base = static_cast<std::uint32_t>(triangleBases_[o]);
        std::vector<scene::SeenSides> ofObject;
        for (auto side = std::ranges::lower_bound(sides, base, {}, &scene::SeenSides::triangle);
             side != sides.end() && side->triangle < base + mesh.triangles.size(); ++side)
            ofObject.push_back({side->triangle - base, side->front, side->back, side->gap});
        if (ofObject.empty()) continue;
        SeenRuns& runs = seenRuns_.emplace(o, gl::seenRuns(mesh, std::move(ofObject))).first->second;
        const auto [entry, isNew] = ordered_.try_emplace({&mesh, runs.order});
        if (isNew) {
            const auto old = known.find(entry->first);
            entry->second = old != known.end() ? old->second : std::make_shared<OrderedTriangles>(mesh, *objectMeshes_[o], runs.order);
        }
        runs.triangles = entry->second;
    }
}

const Texture2D& SceneBuffers::colorImage(std::size_t object, std::size_t part) const {
    return colorImages_.at(scene::colorImageOfPart(*snapshot_, snapshot_->objects[object], part));
}

const Texture2D* SceneBuffers::mask(std::size_t object, std::size_t part) const {
    const scene::AlphaMask* mask = scene::maskOfPart(*snapshot_, snapshot_->objects[object], part);
    return mask ? &masks_.at(mask) : nullptr;
}

const FrontTriangles& SceneBuffers::fronts(std::size_t object, const dvec4& viewerMesh) const {
    std::vector<FrontTriangles>& known = fronts_[object]; // the one asked for last stands last
    const auto found = std::ranges::find_if(known, [&](const FrontTriangles& list) { return isSameViewer(list.viewerMesh(), viewerMesh); });
    if (found != known.end()) {
        std::rotate(found, found + 1, known.end());
    } else {
        if (known.size() == kMostViewers) known.erase(known.begin());
        known.emplace_back(*snapshot_->objects[object].mesh, *objectMeshes_[object], viewerMesh);
    }
    return known.back();
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
