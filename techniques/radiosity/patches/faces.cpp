// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace shadowlab::radiosity {

namespace {

// A quad is flat when its fourth corner lies within this share of its size from the plane of the others: vertices are floats,
// transformed by a matrix in double.
constexpr double kFlat = 1e-7;

dvec3 normalOf(const trace::Triangle& t) { return glm::cross(t.b - t.a, t.c - t.a); }

const dvec3& cornerOf(const trace::Triangle& t, int i) { return i == 0 ? t.a : i == 1 ? t.b : t.c; }

/// The quad of two triangles that share the edge from corner `edge` of the first to the next; nothing if it is not flat, or not
/// convex.
std::optional<Polygon> quadOf(const trace::Triangle& first, int edge, const trace::Triangle& second, int opposite) {
    const dvec3 &from = cornerOf(first, edge), &to = cornerOf(first, (edge + 1) % 3),
                &apex = cornerOf(first, (edge + 2) % 3), &fourth = cornerOf(second, opposite);
    const dvec3 normal = glm::normalize(normalOf(first));
    const double size = glm::length(to - from) + glm::length(fourth - apex);
    if (!(std::abs(glm::dot(normal, fourth - apex)) <= kFlat * size)) return std::nullopt;
    const Polygon quad{apex, from, fourth, to};
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3 before = quad[(i + 1) % 4] - quad[i], after = quad[(i + 2) % 4] - quad[(i + 1) % 4];
        if (!(glm::dot(normal, glm::cross(before, after)) > kFlat * size * size)) return std::nullopt;
    }
    return quad;
}

bool isQuad(const Face& face) { return face.triangles[0] != face.triangles[1]; }

/// Edges, the longest first: in a rectangle made of two triangles it is the diagonal.
std::array<int, 3> edgesByLength(const trace::Triangle& t) {
    std::array<int, 3> edges = {0, 1, 2};
    const auto length = [&](int e) { return glm::length(cornerOf(t, (e + 1) % 3) - cornerOf(t, e)); };
    std::ranges::stable_sort(edges, [&](int a, int b) { return length(a) > length(b); });
    return edges;
}

} // namespace

Faces facesOf(const scene::Scene& scene, const trace::WorldTriangles& world) {
    Faces faces;
    faces.ofTriangle.assign(world.triangles.size(), kNoFace);
    for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        const scene::Mesh& mesh = *object.mesh;
        const std::uint32_t first = world.firstOfObject[o];
        std::vector<std::uint32_t> materials;
        for (std::size_t part = 0; part < mesh.parts.size(); ++part) // in order, covering all triangles
            materials.insert(materials.end(), mesh.parts[part].triangleCount, object.partMaterials[part]);
        // The triangles at each directed edge. Positions identify it, for a vertex may be stored twice.
        const auto key = [&](std::size_t t, int edge) {
            const auto place = [&](int corner) {
                const vec3& p = mesh.positionsMesh[mesh.triangles[t][corner % 3]];
                return std::array{p.x, p.y, p.z};
            };
            return std::pair(place(edge), place(edge + 1));
        };
        std::multimap<std::pair<std::array<float, 3>, std::array<float, 3>>, std::pair<std::uint32_t, int>> edges;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (int edge = 0; edge < 3; ++edge)
                edges.emplace(key(t, edge), std::pair(t, edge));
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (faces.ofTriangle[first + t] != kNoFace) continue;
            const trace::Triangle& triangle = world.triangles[first + t];
            Face face{{triangle.a, triangle.b, triangle.c}, {}, {first + t, first + t}, o, materials[t]};
            for (const int edge : edgesByLength(triangle)) {
                const auto [from, to] = key(t, edge);
                // Several where the two sides of a thin sheet coincide.
                const auto [begin, end] = edges.equal_range({to, from});
                for (auto other = begin; other != end && !isQuad(face); ++other) {
                    const auto [u, otherEdge] = other->second;
                    if (u == t || faces.ofTriangle[first + u] != kNoFace || materials[u] != materials[t]) continue;
                    const auto quad = quadOf(triangle, edge, world.triangles[first + u], (otherEdge + 2) % 3);
                    if (!quad) continue;
                    face.polygon = *quad;
                    face.triangles[1] = first + u;
                }
                if (isQuad(face)) break;
            }
            const auto number = static_cast<std::uint32_t>(faces.all.size());
            for (const std::uint32_t part : face.triangles)
                faces.ofTriangle[part] = number;
            face.plane = planeOf(face.polygon);
            faces.all.push_back(face);
        }
    }
    return faces;
}

} // namespace shadowlab::radiosity
