// Which volumes a frame needs, kept from frame to frame until the light or the caster moves.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "techniques/foundation/gl/surfaces.h"
#include "techniques/foundation/scene/facing_planes.h"
#include "techniques/foundation/scene/outward_parts.h"
#include "techniques/shadow_volume/volume.h"
#include "techniques/shadow_volume/volume_buffers.h"

namespace shadowlab::shadow_volume {

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
    std::optional<dvec4> endWorld; ///< the plane where the volume ends; none: at infinity (volume_end.h)
    bool useful = true;            ///< its shadow can fall on something (scene/casters.h)
    scene::MeshReport report;
    std::unique_ptr<VolumeBuffers> buffers; ///< made when first drawn

    // What the volume was made of: as long as that is the same, so is the volume.
    std::shared_ptr<CasterMesh> mesh;
    dvec4 lightMesh{0.0};            ///< the light, seen from the mesh
    std::vector<std::int8_t> facing; ///< a light that moved a little may leave all signs as they were
};

/// The volumes of all casters for all lights. build() needs no GL; upload() does.
class Casters {
public:
    /// Brings the volumes of the next light up to date; true when all are. Only what moved is built again: an object seen
    /// from each light, or a light seen from each object.
    bool buildNext(const scene::Snapshot& snapshot);
    /// The casters of one light, their buffers on the card.
    const std::vector<CasterVolume>& upload(int light);
    /// The same, as they are.
    [[nodiscard]] const std::vector<CasterVolume>& of(int light) const {
        return perLight_[static_cast<std::size_t>(light)];
    }
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
    std::unordered_map<const scene::Mesh*, std::shared_ptr<CasterMesh>> meshes_;
    std::vector<Place> places_;         ///< of all objects
    std::vector<scene::Bounds> bounds_; ///< likewise
    std::vector<std::vector<CasterVolume>> perLight_;
    std::size_t next_ = 0;            ///< the first light whose volumes may be out of date
    std::vector<std::int8_t> facing_; ///< of the caster in hand; kept for its memory
    std::size_t rebuilt_ = 0;
};

/// What of a volume may touch something in view. A picture with and without the rest is the same.
struct VolumeInView {
    const CasterVolume* caster = nullptr;
    bool any = true, topCap = true, bottomCap = true;
};

/// False for what certainly does not: the caster's box, what it is extruded to, or for `any` both together, lie outside one
/// plane of the view.
VolumeInView volumeInView(const CasterVolume& caster, const scene::Light& light, const gl::EyeMatrices& eye);

} // namespace shadowlab::shadow_volume
