// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>

#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/facing_planes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/shadow_volume/count/volume.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_scene.h"

namespace shadowlab::fuzz {

namespace {

using shadow_volume::Volume;

bool isFinite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void requireSound(const scene::Mesh& mesh) {
    const std::size_t vertices = mesh.positionsMesh.size();
    require(mesh.normalsMesh.size() == vertices, "as many normals as vertices");
    require(mesh.texcoords.empty() || mesh.texcoords.size() == vertices, "as many texture coordinates as vertices");
    require(std::ranges::all_of(mesh.positionsMesh, isFinite), "positions are numbers");
    for (const vec3& normal : mesh.normalsMesh)
        require(std::abs(glm::length(normal) - 1) < 1e-3f,
                "normals are unit vectors"); // within float's rounding, amply
    for (const uvec3& triangle : mesh.triangles)
        require(std::max({triangle.x, triangle.y, triangle.z}) < vertices, "triangles name vertices");
    std::uint32_t next = 0;
    for (const scene::MeshPart& part : mesh.parts) {
        require(part.firstTriangle == next, "parts follow each other");
        next += part.triangleCount;
    }
    require(next == mesh.triangles.size(), "parts cover all triangles");
}

/// Is every directed edge of the triangles met by one that runs the other way? Vertices at one place are one.
class Boundary {
public:
    explicit Boundary(const scene::MeshTopology& topology) : welded_(topology.welded) {}
    void add(const std::vector<std::uint32_t>& triangles, bool reversed) {
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                addEdge(welded(triangles[i + k]), welded(triangles[i + (k + 1) % 3]), reversed ? -1 : 1);
    }
    [[nodiscard]] bool isNothing() const {
        return std::ranges::all_of(count_, [](const auto& edge) { return edge.second == 0; });
    }

private:
    [[nodiscard]] std::uint32_t welded(std::uint32_t index) const {
        const auto vertices = static_cast<std::uint32_t>(welded_.size());
        require(index < 2 * vertices, "volumes name vertices");
        return index < vertices ? welded_[index] : welded_[index - vertices] + vertices;
    }
    void addEdge(std::uint32_t from, std::uint32_t to, int times) {
        if (from < to)
            count_[{from, to}] += times;
        else
            count_[{to, from}] -= times;
    }
    const std::vector<std::uint32_t>& welded_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count_;
};

void requireClosed(const scene::MeshTopology& topology, const Volume& volume) {
    Boundary boundary(topology);
    boundary.add(volume.topCap, false);
    boundary.add(volume.topCapReversed, true);
    boundary.add(volume.sides, false);
    boundary.add(volume.bottomCap, false);
    require(boundary.isNothing(), "a shadow volume is closed");
}

} // namespace

void useMesh(const std::shared_ptr<const scene::Mesh>& mesh) {
    requireSound(*mesh);
    const scene::MeshTopology topology = scene::buildTopology(*mesh);
    const scene::MeshReport report = scene::reportMesh(*mesh, topology);
    require(report.triangles == mesh->triangles.size(), "a report counts all triangles");
    const shadow_volume::EdgeTable edges = shadow_volume::edgeTable(topology);
    const scene::OutwardParts outward = scene::outwardParts(*mesh, topology);
    const scene::FacingPlanes planes(mesh);
    std::vector<std::int8_t> facing(mesh->triangles.size());
    std::vector<shadow_volume::SilhouetteEdge> silhouette;
    Volume volume;
    // A lamp above, one among the vertices, the sun, and one in a vertex, where its triangles are seen edge-on.
    const std::array lights{dvec4(1, 5, 2, 1), dvec4(0.1, 0.2, 0.3, 1), dvec4(0.6, 0.8, 0, 0),
                            dvec4(mesh->positionsMesh.empty() ? vec3(0) : mesh->positionsMesh.front(), 1)};
    for (const dvec4& light : lights) {
        planes.findSigns(light, facing);
        for (std::size_t t = 0; t < facing.size(); ++t) {
            const auto corner = [&](int i) { return dvec3(mesh->positionsMesh[mesh->triangles[t][i]]); };
            require(facing[t] == scene::facingSign(corner(0), corner(1), corner(2), light), "signs, fast and plainly");
        }
        shadow_volume::buildLectureVolume(*mesh, edges, facing, silhouette, volume);
        shadow_volume::buildVolume(*mesh, edges, facing, silhouette, volume);
        requireClosed(topology, volume);
        scene::keepFrontFacesAlone(facing, outward, light);
        shadow_volume::buildVolume(*mesh, edges, facing, silhouette, volume);
        requireClosed(topology, volume);
    }
}

} // namespace shadowlab::fuzz
