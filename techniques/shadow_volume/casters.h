// Which volumes a frame needs, kept from frame to frame until the light or the caster moves.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "techniques/foundation/gl/surfaces.h"
#include "techniques/foundation/scene/outward_parts.h"
#include "techniques/shadow_volume/volume.h"
#include "techniques/shadow_volume/volume_buffers.h"

namespace shadowlab::shadow_volume {

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
};

/// The volumes of all casters for all lights. build() needs no GL; upload() does.
class Casters {
public:
    /// Builds the volumes of the next light that has none yet; true when all are built. Drops what a revision outdates.
    bool buildNext(const scene::Snapshot& snapshot);
    /// The casters of one light, their buffers on the card.
    const std::vector<CasterVolume>& upload(const scene::Snapshot& snapshot, int light);
    /// The same, as they are.
    [[nodiscard]] const std::vector<CasterVolume>& of(int light) const {
        return perLight_[static_cast<std::size_t>(light)];
    }

private:
    struct SharedMesh { ///< kept per mesh, whatever the number of objects and lights
        std::shared_ptr<const scene::Mesh> mesh;
        scene::MeshTopology topology;
        scene::MeshReport report;
        scene::OutwardParts outward;
        std::unique_ptr<ExtrusionVertices> vertices;
    };
    SharedMesh& shared(const std::shared_ptr<const scene::Mesh>& mesh);

    scene::Snapshot snapshot_;
    std::unordered_map<const scene::Mesh*, SharedMesh> meshes_;
    std::vector<std::vector<CasterVolume>> perLight_;
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
