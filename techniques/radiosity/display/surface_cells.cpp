// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/surface_cells.h"

namespace shadowlab::radiosity {

std::optional<std::uint32_t> patchAt(const SurfaceCells& cells, std::uint32_t triangle, bool fromFront,
                                     const vec3& positionMesh) {
    const vec4 position(positionMesh, 1.0f);
    const vec2 place(glm::dot(cells.places[2 * triangle], position),
                     glm::dot(cells.places[2 * triangle + 1], position));
    std::uint32_t next = fromFront ? cells.roots[triangle].x : cells.roots[triangle].y;
    while ((next & PatchTree::kLeaf) == 0) {
        const vec4& line = cells.lines[next];
        next = glm::dot(vec2(line), place) + line.z > 0 ? cells.branches[next].x : cells.branches[next].y;
    }
    if (next == SurfaceCells::kNone) return std::nullopt;
    return cells.cells[next & ~PatchTree::kLeaf].x;
}

std::optional<std::uint32_t> patchOf(const trace::SurfacePoint& point, const SurfaceCells& cells, const trace::SceneTracer& tracer) {
    const scene::Mesh& mesh = *tracer.objectOf(point).mesh;
    const std::uint32_t triangle = tracer.world().triangleInMesh(point.primitive);
    const dvec3 weights = point.barycentric();
    dvec3 positionMesh(0);
    for (int i = 0; i < 3; ++i)
        positionMesh += weights[i] * dvec3(mesh.positionsMesh[mesh.triangles[triangle][i]]);
    return patchAt(cells, point.primitive, point.eyeOnFront, vec3(positionMesh));
}

std::vector<dvec3> blended(const SurfaceCells& cells, std::span<const dvec3> ofPatches) {
    std::vector<dvec3> values(cells.blends.size());
    if (cells.blends.empty()) return values;
    const std::vector<dvec3> corners = cells.corners.values(ofPatches);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const SurfaceCells::Blend& blend = cells.blends[i];
        values[i] = blend.weights.x * ofPatches[blend.patch] + blend.weights.y * corners[blend.corners[0]] +
                    blend.weights.z * corners[blend.corners[1]];
    }
    return values;
}

CellValues cellValues(const SurfaceCells& cells, std::span<const dvec3> ofPatches, std::span<const dvec3> ofBlends) {
    CellValues values;
    const auto add = [](std::vector<vec4>& to, const dvec3& value) { to.emplace_back(vec3(value), 1.0f); };
    for (const dvec3& value : ofPatches)
        add(values.ofPatches, value);
    for (const dvec3& value : cells.corners.values(ofPatches))
        add(values.ofBorders, value);
    for (const dvec3& value : ofPatches)
        add(values.ofBorders, value);
    for (std::size_t i = 0; i < ofBlends.size(); ++i)
        add(values.ofBorders, i % 4 == 3 ? (ofBlends[i - 3] + ofBlends[i - 2] + ofBlends[i - 1]) / 3.0 : ofBlends[i]);
    return values;
}

} // namespace shadowlab::radiosity
