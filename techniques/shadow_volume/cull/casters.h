// Which volumes a frame needs, kept from frame to frame until the light or the caster moves.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/foundation/scene/query/facing_planes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/shadow_volume/count/extrusion.h"
#include "techniques/shadow_volume/count/volume.h"
#include "techniques/shadow_volume/count/volume_buffers.h"

namespace shadowlab::shadow_volume {

/// general: for any triangles, by signed counts at the edges (volume.h); lecture: as the lecture builds it
/// (lecture_volume.cpp).
enum class Construction { general, lecture };

/// A volume whose vertices the processor has pushed, on the card.
struct ExtrudedVolume {
    Extrusion extrusion;
    gl::BufferHandle vertices;
    std::unique_ptr<VolumeBuffers> buffers;
};

/// What all volumes of a mesh share, whatever the number of objects and lights.
struct CasterMesh {
    explicit CasterMesh(std::shared_ptr<const scene::Mesh> mesh);

    std::shared_ptr<const scene::Mesh> mesh;
    scene::FacingPlanes planes;
    scene::MeshReport report;
    scene::OutwardParts outward;
    EdgeTable edges;
    std::unique_ptr<ExtrusionVertices> vertices; ///< made when first drawn
};

/// One caster's volume for one light.
struct CasterVolume {
    std::size_t object = 0;
    Volume volume;
    std::vector<SilhouetteEdge> silhouette;
    scene::Bounds bounds;
    std::optional<dvec4> endWorld; ///< the plane beyond all objects where the volume may end (volume_end.h)
    bool useful = true;            ///< its shadow can fall on something (scene/query/casters.h)
    scene::MeshReport report;
    std::unique_ptr<VolumeBuffers> buffers;   ///< made when first drawn
    std::unique_ptr<ExtrudedVolume> extruded; ///< made when the processor first has to extrude

    // The cache key of the volume: as long as these are the same, so is the volume.
    std::shared_ptr<CasterMesh> mesh;
    dvec4 lightMesh{0.0};            ///< the light, seen from the mesh
    dvec3 lampNormalWorld{0.0};      ///< of a rect light; what lies in its plane casts no shadow
    std::vector<std::int8_t> facing; ///< a light that moved a little may leave all signs as they were
};

/// The volumes of all casters for all lights. build() needs no GL; upload() does.
class Casters {
public:
    /// Brings the volumes of the next light up to date; true when all are. Only what moved is built again: an object seen
    /// from each light, or a light seen from each object.
    bool buildNext(const scene::Snapshot& snapshot, Construction construction = Construction::general);
    /// The casters of one light, with their buffers uploaded.
    const std::vector<CasterVolume>& upload(int light);
    /// Extrudes one of them on the processor, unless that is done already.
    const VolumeBuffers& extrude(int light, std::size_t caster, const Extrusion& extrusion);
    /// The casters of one light, without uploading anything.
    [[nodiscard]] const std::vector<CasterVolume>& of(int light) const {
        return perLight_[static_cast<std::size_t>(light)];
    }
    /// At most so many of its casters' triangles lie between that light and any point (overlaps.h).
    [[nodiscard]] int overlaps(int light) const { return overlaps_[static_cast<std::size_t>(light)]; }
    /// The boxes of all objects, in their order.
    [[nodiscard]] std::span<const scene::Bounds> bounds() const { return bounds_; }
    /// Changes whenever the list of casters changes, or moves in memory.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    /// How many volumes there are, for all lights together.
    [[nodiscard]] std::size_t count() const;
    /// How many of them were built since this was last asked.
    std::size_t takeRebuilt() { return std::exchange(rebuilt_, 0); }

private:
    struct Place { ///< where an object is: what its box follows from
        std::shared_ptr<const scene::Mesh> mesh;
        dmat4 worldFromMesh{1.0};
    };
    void begin(const scene::Scene& scene);
    void update(CasterVolume& caster, const scene::Object& object, const scene::Light& light);
    const std::shared_ptr<CasterMesh>& shared(const std::shared_ptr<const scene::Mesh>& mesh);

    scene::Snapshot snapshot_;
    Construction construction_ = Construction::general;
    std::unordered_map<const scene::Mesh*, std::shared_ptr<CasterMesh>> meshes_;
    std::vector<Place> places_;         ///< of all objects
    std::vector<scene::Bounds> bounds_; ///< likewise
    std::vector<std::vector<CasterVolume>> perLight_;
    std::vector<int> overlaps_;       ///< likewise
    std::size_t next_ = 0;            ///< the first light whose volumes may be out of date
    std::vector<std::int8_t> facing_; ///< of the caster that is being built; a member so that its memory is reused
    std::size_t rebuilt_ = 0;
    std::uint64_t revision_ = 0;
};

} // namespace shadowlab::shadow_volume
