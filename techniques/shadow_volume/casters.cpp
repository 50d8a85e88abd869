// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/casters.h"

#include <algorithm>

#include "techniques/foundation/scene/casters.h"
#include "techniques/foundation/scene/facing.h"
#include "techniques/shadow_volume/volume_end.h"

namespace shadowlab::shadow_volume {

bool Casters::buildNext(const scene::Snapshot& snapshot) {
    if (snapshot_ != snapshot) {
        const bool sameMeshes = snapshot_ && snapshot_->revisions.geometry == snapshot->revisions.geometry;
        const bool sameVolumes = sameMeshes && snapshot_->revisions.transforms == snapshot->revisions.transforms &&
                                 snapshot_->revisions.lights == snapshot->revisions.lights;
        if (!sameVolumes) perLight_.clear();
        if (!sameMeshes) meshes_.clear();
        snapshot_ = snapshot;
    }
    if (perLight_.size() == snapshot->lights.size()) return true;

    const scene::Light& light = snapshot->lights[perLight_.size()];
    scene::Bounds sceneBounds;
    for (const scene::Bounds& bounds : scene::objectBounds(*snapshot))
        sceneBounds.include(bounds);
    const std::vector<std::size_t> useful = scene::usefulCasters(*snapshot, light);
    std::vector<CasterVolume> casters;
    for (const std::size_t o : scene::allCasters(*snapshot)) {
        const scene::Object& object = snapshot->objects[o];
        const SharedMesh& mesh = shared(object.mesh);
        std::vector<std::int8_t> facing = scene::facingSigns(object, light);
        scene::keepFrontFacesAlone(facing, mesh.outward, scene::lightMesh(object, light));
        const scene::Bounds bounds = scene::boundsWorld(object);
        CasterVolume caster{.object = o,
                            .volume = {},
                            .silhouette = silhouetteEdges(mesh.topology, facing),
                            .bounds = bounds,
                            .endWorld = endPlaneWorld(bounds, light, sceneBounds),
                            .useful = std::ranges::binary_search(useful, o),
                            .report = mesh.report,
                            .buffers = nullptr};
        caster.volume = buildVolume(*object.mesh, facing, caster.silhouette);
        casters.push_back(std::move(caster));
    }
    perLight_.push_back(std::move(casters));
    return perLight_.size() == snapshot->lights.size();
}

const std::vector<CasterVolume>& Casters::upload(const scene::Snapshot& snapshot, int light) {
    std::vector<CasterVolume>& casters = perLight_[static_cast<std::size_t>(light)];
    for (CasterVolume& caster : casters) {
        if (caster.buffers) continue;
        SharedMesh& mesh = shared(snapshot->objects[caster.object].mesh);
        if (!mesh.vertices) mesh.vertices = std::make_unique<ExtrusionVertices>(*mesh.mesh);
        caster.buffers = std::make_unique<VolumeBuffers>(caster.volume, caster.silhouette, *mesh.vertices);
    }
    return casters;
}

Casters::SharedMesh& Casters::shared(const std::shared_ptr<const scene::Mesh>& mesh) {
    SharedMesh& shared = meshes_[mesh.get()];
    if (!shared.mesh) {
        shared.mesh = mesh;
        shared.topology = scene::buildTopology(*mesh);
        shared.report = scene::reportMesh(*mesh, shared.topology);
        shared.outward = scene::outwardParts(*mesh, shared.topology);
    }
    return shared;
}

VolumeInView volumeInView(const CasterVolume& caster, const scene::Light& light, const gl::EyeMatrices& eye) {
    // The volume lies in the convex hull of the box's corners and their images at the end, all as clip coordinates: the top
    // cap among the former, the bottom cap among the latter.
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
    const dvec4 lightWorld = scene::homogeneousPositionWorld(light);
    dvec4 points[16];
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner = caster.bounds.corner(i);
        points[i] = clipFromWorld * dvec4(corner, 1.0);
        points[8 + i] = clipFromWorld * (caster.endWorld ? dvec4(pushedToPlane(corner, light, *caster.endWorld), 1.0)
                                                         : dvec4(corner * lightWorld.w - dvec3(lightWorld), 0.0));
    }
    const scene::PicturePart part = eye.part.value_or(scene::PicturePart{});
    const std::span<const dvec4> all(points);
    return {&caster, scene::mayTouch(all, part), scene::mayTouch(all.first(8), part),
            scene::mayTouch(all.last(8), part)};
}

} // namespace shadowlab::shadow_volume
