// SPDX-License-Identifier: MIT
#include "techniques/planar/receivers/flat_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::planar {

namespace {

// Coordinates are floats: each is off by up to 2^-25 of the largest. Three of a corner, and a plane that goes through
// three corners as uncertain and is continued to the far end of the face, are off by no more than this share.
constexpr double kCoplanar = 1.0 / (1 << 21);

// Shading normals within one degree of the plane's: files write them with four decimals, a tenth of that.
const double kFlatCosine = std::cos(0.0175);

// A face that extends over this share of the mesh's diagonal is large, whatever its outline: a side of a plinth is, a facet
// of a ball is not.
constexpr double kLargeShare = 1.0 / 8.0;

// A smaller one must have sharp edges (a step of a stair, a window sill). At most this many of these receive, the largest
// first: not every leaf of a tree has to.
constexpr std::size_t kMostFaces = 2048;

// Two faces that meet at less than 30 degrees approximate a curve: a column of twelve sides, any finer one, and the facets
// of a ball or a teapot. Chamfers have 45.
const double kGentleCosine = std::cos(30.0 * M_PI / 180.0);

// Of a small face's outline, by length, this much may bend gently: one short side of a long sill.
constexpr double kGentleShare = 0.1;

struct Triangle {
    dvec3 a, b, c, normal; ///< mesh space; the normal is unit
    double area;
};

Triangle triangleOf(const scene::Mesh& mesh, std::uint32_t index) {
    const uvec3& t = mesh.triangles[index];
    Triangle triangle{dvec3(mesh.positionsMesh[t.x]), dvec3(mesh.positionsMesh[t.y]), dvec3(mesh.positionsMesh[t.z]),
                      dvec3(0.0), 0};
    const dvec3 cross = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    triangle.area = 0.5 * glm::length(cross);
    if (triangle.area > 0) triangle.normal = cross / (2 * triangle.area);
    return triangle;
}

bool isShadedFlat(const scene::Mesh& mesh, std::uint32_t index, const dvec3& normal) {
    const uvec3& t = mesh.triangles[index];
    return std::ranges::all_of(std::array{t.x, t.y, t.z}, [&](std::uint32_t corner) {
        return std::abs(glm::dot(dvec3(mesh.normalsMesh[corner]), normal)) >= kFlatCosine;
    });
}

/// The rectangle around the corners of a face, along the longest edge of its outline.
std::array<dvec3, 4> frameAround(const FlatFace& face, const std::vector<dvec3>& corners) {
    dvec3 along = corners[1] - corners[0]; // a face may be there twice, and then nothing bounds it
    for (const auto& [from, to] : face.outlineMesh)
        if (glm::length(to - from) > glm::length(along)) along = to - from;
    const dvec3 u = glm::normalize(along), v = glm::cross(face.normalMesh, u);
    dvec2 lower(1e300), upper(-1e300);
    for (const dvec3& corner : corners) {
        const dvec2 uv(glm::dot(corner - face.pointMesh, u), glm::dot(corner - face.pointMesh, v));
        lower = glm::min(lower, uv);
        upper = glm::max(upper, uv);
    }
    const auto at = [&](double x, double y) { return face.pointMesh + x * u + y * v; };
    return {at(lower.x, lower.y), at(upper.x, lower.y), at(upper.x, upper.y), at(lower.x, upper.y)};
}

class Finder {
public:
    explicit Finder(const scene::Mesh& mesh) : mesh_(mesh), free_(mesh.triangles.size(), 0) {
        dvec3 lower(1e300), upper(-1e300);
        for (const vec3& position : mesh.positionsMesh) {
            lower = glm::min(lower, dvec3(position));
            upper = glm::max(upper, dvec3(position));
            largest_ = std::max<double>(largest_, glm::length(position));
        }
        diagonal_ = glm::length(upper - lower);
    }

    FlatFaces find() {
        FlatFaces found;
        std::vector<std::pair<double, std::uint32_t>> seeds; // largest first: their planes are the most certain
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            const Triangle triangle = triangleOf(mesh_, t);
            found.area += triangle.area;
            if (triangle.area <= 0) continue;
            if (!isShadedFlat(mesh_, t, triangle.normal)) {
                found.smoothArea += triangle.area;
                continue;
            }
            free_[t] = 1;
            seeds.emplace_back(-triangle.area, t);
        }
        if (seeds.empty()) return found;
        std::ranges::sort(seeds);
        connect();
        std::vector<std::pair<std::uint32_t, FlatFace>> faces;
        for (const auto& [area, seed] : seeds) {
            if (!free_[seed]) continue;
            const std::vector<std::uint32_t> members = spread(seed);
            FlatFace face = faceOf(seed, members);
            const double size = glm::length(face.frameMesh[2] - face.frameMesh[0]) / diagonal_;
            if (faces.size() == kMostFaces)
                found.leftOverArea += areaOf(members);
            else if (size < kLargeShare && gentleShare(members) > kGentleShare)
                found.facetArea += areaOf(members);
            else
                faces.emplace_back(members.front(), std::move(face));
        }
        std::ranges::sort(faces, {}, [](const auto& entry) { return entry.first; });
        for (auto& [first, face] : faces)
            found.faces.push_back(std::move(face));
        return found;
    }

private:
    void connect() {
        topology_ = scene::buildTopology(mesh_);
        edgesOf_.resize(mesh_.triangles.size());
        for (std::uint32_t e = 0; e < topology_.edges.size(); ++e)
            for (std::uint32_t i = 0; i < topology_.edges[e].useCount; ++i)
                edgesOf_[topology_.uses[topology_.edges[e].firstUse + i].triangle].push_back(e);
    }

    [[nodiscard]] double distance(std::uint32_t t, const dvec3& pointMesh, const dvec3& normalMesh) const {
        double farthest = 0;
        for (int corner = 0; corner < 3; ++corner) {
            const dvec3 offset = dvec3(mesh_.positionsMesh[mesh_.triangles[t][corner]]) - pointMesh;
            farthest = std::max(farthest, std::abs(glm::dot(offset, normalMesh)));
        }
        return farthest;
    }

    /// All triangles connected with the seed that lie in its plane, in ascending order; marks them as used.
    std::vector<std::uint32_t> spread(std::uint32_t seed) {
        const Triangle plane = triangleOf(mesh_, seed);
        std::vector<std::uint32_t> members = {seed};
        free_[seed] = 0;
        for (std::size_t i = 0; i < members.size(); ++i)
            for (const std::uint32_t e : edgesOf_[members[i]])
                for (std::uint32_t u = 0; u < topology_.edges[e].useCount; ++u) {
                    const std::uint32_t next = topology_.uses[topology_.edges[e].firstUse + u].triangle;
                    if (!free_[next] || distance(next, plane.a, plane.normal) > kCoplanar * largest_) continue;
                    free_[next] = 0;
                    members.push_back(next);
                }
        std::ranges::sort(members);
        return members;
    }

    [[nodiscard]] double areaOf(const std::vector<std::uint32_t>& members) const {
        double area = 0;
        for (const std::uint32_t t : members)
            area += triangleOf(mesh_, t).area;
        return area;
    }

    /// The share of the outline, by length, at which the surface continues at a small angle. The boundary of an open mesh
    /// counts as sharp.
    [[nodiscard]] double gentleShare(const std::vector<std::uint32_t>& members) const {
        double gentle = 0, all = 0;
        for (const std::uint32_t t : members) {
            const dvec3 normal = triangleOf(mesh_, t).normal;
            for (const std::uint32_t e : edgesOf_[t]) {
                const scene::Edge& edge = topology_.edges[e];
                bool inside = false, bendsGently = false;
                for (std::uint32_t u = 0; u < edge.useCount; ++u) {
                    const std::uint32_t other = topology_.uses[edge.firstUse + u].triangle;
                    if (other == t) continue;
                    inside = inside || std::ranges::binary_search(members, other);
                    bendsGently = bendsGently || glm::dot(normal, triangleOf(mesh_, other).normal) > kGentleCosine;
                }
                if (inside) continue;
                const double length =
                    glm::length(dvec3(mesh_.positionsMesh[edge.a]) - dvec3(mesh_.positionsMesh[edge.b]));
                all += length;
                gentle += bendsGently ? length : 0;
            }
        }
        return all > 0 ? gentle / all : 0;
    }

    [[nodiscard]] FlatFace faceOf(std::uint32_t seed, const std::vector<std::uint32_t>& members) const {
        const Triangle plane = triangleOf(mesh_, seed);
        FlatFace face;
        face.pointMesh = plane.a;
        face.normalMesh = plane.normal;
        face.runs = runsOf(members);
        std::map<std::uint32_t, int> uses; // of an edge, by triangles of the face: an odd number of them bounds it
        std::vector<dvec3> corners;
        for (const std::uint32_t t : members) {
            const Triangle triangle = triangleOf(mesh_, t);
            corners.insert(corners.end(), {triangle.a, triangle.b, triangle.c});
            face.unevenness = std::max(face.unevenness, distance(t, plane.a, plane.normal));
            for (const std::uint32_t e : edgesOf_[t])
                ++uses[e];
        }
        for (const auto& [e, count] : uses)
            if (count % 2 == 1)
                face.outlineMesh.push_back({dvec3(mesh_.positionsMesh[topology_.edges[e].a]),
                                            dvec3(mesh_.positionsMesh[topology_.edges[e].b])});
        face.frameMesh = frameAround(face, corners);
        return face;
    }

    const scene::Mesh& mesh_;
    std::vector<std::uint8_t> free_; ///< per triangle: shaded flat, and of no face yet
    double largest_ = 0, diagonal_ = 0;
    scene::MeshTopology topology_;
    std::vector<std::vector<std::uint32_t>> edgesOf_; ///< per triangle
};

} // namespace

std::vector<TriangleRun> runsOf(const std::vector<std::uint32_t>& ascending) {
    std::vector<TriangleRun> runs;
    for (const std::uint32_t t : ascending)
        if (!runs.empty() && runs.back().first + runs.back().count == t)
            ++runs.back().count;
        else
            runs.push_back({t, 1});
    return runs;
}

bool contains(const std::vector<TriangleRun>& runs, std::uint32_t triangle) {
    return std::ranges::any_of(
        runs, [&](const TriangleRun& run) { return triangle >= run.first && triangle - run.first < run.count; });
}

FlatFaces flatFaces(const scene::Mesh& mesh) { return Finder(mesh).find(); }

} // namespace shadowlab::planar
