// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/cull/casters.h"

#include <algorithm>

#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/lamp_plane.h"
#include "techniques/shadow_volume/count/volume.h"
#include "techniques/shadow_volume/cull/overlaps.h"

namespace shadowlab::shadow_volume {

CasterMesh::CasterMesh(std::shared_ptr<const scene::Mesh> itsMesh) : mesh(std::move(itsMesh)), planes(mesh) {
    const scene::MeshTopology topology = scene::buildTopology(*mesh);
    report = scene::reportMesh(*mesh, topology);
    outward = scene::outwardParts(*mesh, topology);
    edges = edgeTable(topology);
}

bool Casters::buildNext(const scene::Snapshot& snapshot, Construction construction) {
    if (construction_ != construction) {
        construction_ = construction;
        perLight_.clear();
        snapshot_ = nullptr;
    }
    if (snapshot_ != snapshot) {
        const bool same = snapshot_ && snapshot_->revisions.geometry == snapshot->revisions.geometry &&
                          snapshot_->revisions.transforms == snapshot->revisions.transforms &&
                          snapshot_->revisions.lights == snapshot->revisions.lights;
        if (!same) begin(*snapshot);
        snapshot_ = snapshot;
    }
    if (next_ == snapshot->lights.size()) return true;

    const scene::Light& light = snapshot->lights[next_];
    scene::Bounds sceneBounds;
    for (const scene::Bounds& bounds : bounds_)
        sceneBounds.include(bounds);
    const std::vector<std::size_t> useful = scene::usefulCasters(*snapshot, light, bounds_);
    std::vector<CasterVolume> known = std::exchange(perLight_[next_], {});
    auto old = known.begin(); // both are in the order of the objects
    for (const std::size_t o : scene::allCasters(*snapshot)) {
        while (old != known.end() && old->object < o)
            ++old;
        CasterVolume caster;
        if (old != known.end() && old->object == o) caster = std::move(*old);
        caster.object = o;
        update(caster, snapshot->objects[o], light);
        // The indices do not depend on where the volume ends: the shader takes that as a uniform, and it may change at any
        // time.
        caster.bounds = bounds_[o];
        caster.endWorld = endPlaneWorld(caster.bounds, light, sceneBounds);
        caster.useful = std::ranges::binary_search(useful, o);
        perLight_[next_].push_back(std::move(caster));
    }
    overlaps_[next_] = mostOverlaps(*snapshot, light, perLight_[next_]);
    return ++next_ == snapshot->lights.size();
}

void Casters::begin(const scene::Scene& scene) {
    ++revision_;
    const std::size_t objects = scene.objects.size();
    places_.resize(objects);
    bounds_.resize(objects);
    for (std::size_t o = 0; o < objects; ++o) {
        const scene::Object& object = scene.objects[o];
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        if (places_[o].mesh == object.mesh && places_[o].worldFromMesh == worldFromMesh) continue;
        places_[o] = {object.mesh, worldFromMesh};
        bounds_[o] = scene::boundsWorld(object);
    }
    std::erase_if(meshes_, [&](const auto& entry) {
        return std::ranges::none_of(places_, [&](const Place& place) { return place.mesh.get() == entry.first; });
    });
    perLight_.resize(scene.lights.size());
    overlaps_.resize(scene.lights.size());
    next_ = 0;
}

void Casters::update(CasterVolume& caster, const scene::Object& object, const scene::Light& light) {
    const std::shared_ptr<CasterMesh>& mesh = shared(object.mesh);
    const dvec4 lightMesh = scene::lightMesh(object, light);
    const bool sameMesh = caster.mesh == mesh;
    const dvec3 lampNormalWorld = light.type == scene::LightType::rect ? scene::rectNormalWorld(light) : dvec3(0.0);
    if (sameMesh && caster.lightMesh == lightMesh && caster.lampNormalWorld == lampNormalWorld) return;
    caster.lightMesh = lightMesh;
    caster.lampNormalWorld = lampNormalWorld;
    facing_.resize(mesh->planes.size());
    mesh->planes.findSigns(lightMesh, facing_);
    scene::clearInLampPlane(object, light, facing_);
    if (construction_ == Construction::general) scene::keepFrontFacesAlone(facing_, mesh->outward, lightMesh);
    if (sameMesh && caster.facing == facing_) return;
    caster.mesh = mesh;
    caster.report = mesh->report;
    std::swap(caster.facing, facing_);
    const auto build = construction_ == Construction::general ? buildVolume : buildLectureVolume;
    build(*mesh->mesh, mesh->edges, caster.facing, caster.silhouette, caster.volume);
    caster.buffers = nullptr;
    caster.extruded = nullptr;
    ++rebuilt_;
}

const std::vector<CasterVolume>& Casters::upload(int light) {
    std::vector<CasterVolume>& casters = perLight_[static_cast<std::size_t>(light)];
    for (CasterVolume& caster : casters) {
        if (caster.buffers) continue;
        std::unique_ptr<ExtrusionVertices>& vertices = caster.mesh->vertices;
        if (!vertices) vertices = std::make_unique<ExtrusionVertices>(*caster.mesh->mesh);
        caster.buffers =
            std::make_unique<VolumeBuffers>(caster.volume, caster.silhouette, [&] { vertices->bindAttributes(); });
    }
    return casters;
}

const VolumeBuffers& Casters::extrude(int light, std::size_t caster, const Extrusion& extrusion) {
    CasterVolume& volume = perLight_[static_cast<std::size_t>(light)][caster];
    if (volume.extruded && volume.extruded->extrusion == extrusion) return *volume.extruded->buffers;
    volume.extruded = std::make_unique<ExtrudedVolume>();
    volume.extruded->extrusion = extrusion;
    volume.extruded->vertices = gl::uploadBuffer(GL_ARRAY_BUFFER, extrudedMesh(*volume.mesh->mesh, extrusion));
    volume.extruded->buffers = std::make_unique<VolumeBuffers>(volume.volume, volume.silhouette, [&] {
        glBindBuffer(GL_ARRAY_BUFFER, volume.extruded->vertices.id());
        glEnableVertexAttribArray(gl::kPositionMesh);
        glVertexAttribPointer(gl::kPositionMesh, 4, GL_FLOAT, GL_FALSE, sizeof(vec4), nullptr);
    });
    return *volume.extruded->buffers;
}

std::size_t Casters::count() const {
    std::size_t count = 0;
    for (const std::vector<CasterVolume>& casters : perLight_)
        count += casters.size();
    return count;
}

const std::shared_ptr<CasterMesh>& Casters::shared(const std::shared_ptr<const scene::Mesh>& mesh) {
    std::shared_ptr<CasterMesh>& shared = meshes_[mesh.get()];
    if (!shared) shared = std::make_shared<CasterMesh>(mesh);
    return shared;
}

} // namespace shadowlab::shadow_volume
