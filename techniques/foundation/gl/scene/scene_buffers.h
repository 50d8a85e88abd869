// The scene on the graphics card: object-space floats, uploaded once per geometry revision and shared by all slots.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/scene/front_triangles.h"
#include "techniques/foundation/gl/scene/mesh_buffers.h"
#include "techniques/foundation/gl/scene/seen_runs.h"
#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/coincident/coincident_faces.h"

namespace shadowlab::gl {

/// A program that shades with all lights of a scene at once holds a bit for each in a word.
constexpr std::size_t kMostLightsAtOnce = 32;

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
    /// Where sides of the object are left out or drawn in layers, since others coincide with them. nullptr: it is drawn as it is.
    [[nodiscard]] const SeenRuns* seenRuns(std::size_t object) const {
        const auto found = seenRuns_.find(object);
        return found == seenRuns_.end() ? nullptr : &found->second;
    }
    /// Is it quicker to draw a list of the object's fronts than to let backs be culled?
    [[nodiscard]] bool listsFronts(std::size_t object) const { return paysToListFronts(*snapshot_->objects[object].mesh); }
    /// What of the object can show its front to such a viewer (front_triangles.h), made when first asked for.
    [[nodiscard]] const FrontTriangles& fronts(std::size_t object, const dvec4& viewerMesh) const;
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
    void updateSeenRuns();

    scene::Snapshot snapshot_;
    std::unordered_map<const scene::Mesh*, std::unique_ptr<MeshBuffers>> meshes_;
    std::vector<const MeshBuffers*> objectMeshes_;
    std::unordered_map<const scene::AlphaMask*, Texture2D> masks_;
    std::unordered_map<const scene::ColorImage*, Texture2D> colorImages_; ///< null: one white texel
    bool anyOwnColors_ = false;
    std::vector<bool> hasHoles_; ///< per object
    std::vector<int> triangleBases_;
    std::vector<scene::Bounds> bounds_;
    std::shared_ptr<const scene::CoincidentFaces> coincident_;
    std::map<std::size_t, SeenRuns> seenRuns_; ///< by object
    /// Objects of one mesh that are drawn alike share them: columns on a floor. By mesh and order.
    std::map<std::pair<const scene::Mesh*, std::vector<std::uint32_t>>, std::shared_ptr<const OrderedTriangles>> ordered_;
    mutable std::map<std::size_t, std::vector<FrontTriangles>> fronts_; ///< by object, of the last few viewers
    mutable std::map<int, TriangleTexture> facing_;
    mutable std::optional<TriangleTexture> facingOfAllLights_;
    Program greyed_{"fullscreen.vert", "greyed.frag"};
};

} // namespace shadowlab::gl
