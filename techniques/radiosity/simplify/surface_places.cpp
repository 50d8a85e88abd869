// SPDX-License-Identifier: MIT
#include "techniques/radiosity/simplify/surface_places.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

// Normals less than some 80 degrees apart face the same way; those on the other side of a thin sheet do not.
constexpr double kSameWay = 0.2;

struct NearestPlace {
    dvec3 weights{0.0};
    double squaredDistance = std::numeric_limits<double>::infinity();
};

/// The point of a triangle nearest to p.
NearestPlace nearestPlace(const dvec3& p, const std::array<dvec3, 3>& corners) {
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double squared = glm::dot(normal, normal);
    dvec3 weights(0.0);
    for (int i = 0; i < 3; ++i) {
        const dvec3 &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
        weights[i] = glm::dot(normal, glm::cross(c - b, p - b)) / squared;
    }
    if (weights.x >= 0 && weights.y >= 0 && weights.z >= 0) {
        const double height = glm::dot(normal, p - corners[0]);
        return {weights, height * height / squared};
    }
    NearestPlace nearest;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const dvec3 side = corners[j] - corners[i], way = p - corners[i];
        const double share = glm::clamp(glm::dot(way, side) / glm::dot(side, side), 0.0, 1.0);
        const dvec3 off = way - share * side;
        if (!(glm::dot(off, off) < nearest.squaredDistance)) continue;
        nearest = {dvec3(0.0), glm::dot(off, off)};
        nearest.weights[i] = 1 - share;
        nearest.weights[j] = share;
    }
    return nearest;
}

/// The coarse triangles near each cluster: those with a corner there, and those that share a corner with one of these.
class Surroundings {
public:
    Surroundings(const ClusteredMesh& coarse, const scene::Mesh& original);
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t cluster) const { return triangles_.at(cluster); }

    /// By cluster.
private:
    std::map<std::uint32_t, std::vector<std::uint32_t>> triangles_;
};

Surroundings::Surroundings(const ClusteredMesh& coarse, const scene::Mesh& original) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> ending;
    for (std::uint32_t t = 0; t < coarse.triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner)
            ending[coarse.triangles[t][corner]].push_back(t);
    const auto nearest = [&](std::uint32_t cluster) {
        return std::ranges::min_element(ending, {}, [&](const auto& place) {
            return glm::distance(coarse.positions[place.first], coarse.positions[cluster]);
        });
    };
    for (const uvec3& t : original.triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t cluster = coarse.clusterOfVertex[t[corner]];
            const auto [entry, isNew] = triangles_.try_emplace(cluster);
            if (!isNew) continue;
            const auto here = ending.find(cluster);
            std::vector<std::uint32_t>& found = entry->second;
            for (const std::uint32_t first : (here == ending.end() ? nearest(cluster) : here)->second)
                for (int other = 0; other < 3; ++other) {
                    const auto& more = ending.at(coarse.triangles[first][other]);
                    found.insert(found.end(), more.begin(), more.end());
                }
            std::ranges::sort(found);
            const auto repeated = std::ranges::unique(found);
            found.erase(repeated.begin(), repeated.end());
        }
}

struct CoarseTriangle {
    std::array<dvec3, 3> corners;
    dvec3 normal{0.0}, middle{0.0};
    double radius = 0; ///< about the middle
    std::uint32_t part = 0;
};

std::vector<CoarseTriangle> trianglesOf(const ClusteredMesh& coarse) {
    std::vector<CoarseTriangle> triangles;
    for (std::size_t i = 0; i < coarse.triangles.size(); ++i) {
        const uvec3& t = coarse.triangles[i];
        const dvec3 &a = coarse.positions[t.x], &b = coarse.positions[t.y], &c = coarse.positions[t.z];
        const dvec3 middle = (a + b + c) / 3.0;
        const double radius = std::max({glm::distance(a, middle), glm::distance(b, middle), glm::distance(c, middle)});
        triangles.push_back({{a, b, c}, glm::normalize(glm::cross(b - a, c - a)), middle, radius, coarse.parts[i]});
    }
    return triangles;
}

/// The best place found so far for a corner. Ranked first by direction and part: a triangle that faces the same way and is of the
/// same part, then one of another part, then one at a right angle, then one that faces the other way. Within a rank the nearest
/// wins.
class Best {
public:
    Best(const dvec3& position, const dvec3& normal, std::uint32_t part)
        : position_(position), normal_(normal), part_(part) {}
    [[nodiscard]] bool isSameWay() const { return rank_ >= kSameWayRank; }
    void offer(std::uint32_t number, const CoarseTriangle& triangle) {
        const double facing = glm::dot(normal_, triangle.normal);
        const int rank = facing < -kSameWay  ? 0
                         : facing < kSameWay ? 1
                                             : kSameWayRank + (triangle.part == part_ ? 1 : 0);
        if (rank < rank_) return;
        const double atLeast = glm::distance(position_, triangle.middle) - triangle.radius;
        if (rank == rank_ && atLeast > 0 && atLeast * atLeast > place_.squaredDistance) return;
        const NearestPlace place = nearestPlace(position_, triangle.corners);
        if (rank == rank_ && !(place.squaredDistance < place_.squaredDistance)) return;
        number_ = number;
        rank_ = rank;
        place_ = place;
    }
    [[nodiscard]] SurfacePlace place(std::uint32_t firstTriangle) const {
        const vec3 weights(place_.weights);
        return {firstTriangle + number_, {weights.x, weights.y, weights.z}};
    }

private:
    static constexpr int kSameWayRank = 2;
    const dvec3 &position_, &normal_;
    std::uint32_t part_, number_ = 0;
    int rank_ = -1;
    NearestPlace place_;
};

} // namespace

std::vector<std::array<SurfacePlace, 3>> cornerPlaces(const scene::Mesh& original, const VertexClusters& clusters,
                                                      const ClusteredMesh& coarse, std::uint32_t firstTriangle) {
    const Surroundings surroundings(coarse, original);
    const std::vector<CoarseTriangle> triangles = trianglesOf(coarse);
    const std::vector<dvec3>& positions = clusters.positions();
    std::vector<std::array<SurfacePlace, 3>> places(original.triangles.size());
    const auto fill = [&](std::size_t t) {
        const uvec3& corners = original.triangles[t];
        const dvec3 vector =
            glm::cross(positions[corners.y] - positions[corners.x], positions[corners.z] - positions[corners.x]);
        const double length = glm::length(vector);
        const dvec3 normal = length > 0 ? vector / length : dvec3(0.0);
        for (int corner = 0; corner < 3; ++corner) {
            Best best(positions[corners[corner]], normal, clusters.partOf(t));
            for (int tried = 0; tried < 3 && !best.isSameWay();
                 ++tried) // its own cell, then those of the other two corners
                for (const std::uint32_t near : surroundings.of(coarse.clusterOfVertex[corners[(corner + tried) % 3]]))
                    best.offer(near, triangles[near]);
            for (std::uint32_t any = 0; any < triangles.size() && !best.isSameWay(); ++any)
                best.offer(any, triangles[any]);
            places[t][static_cast<std::size_t>(corner)] = best.place(firstTriangle);
        }
    };
    constexpr std::size_t kTogether = 1024; // some milliseconds
    trace::parallelFor((places.size() + kTogether - 1) / kTogether, [&](std::size_t piece) {
        for (std::size_t t = piece * kTogether; t < std::min(places.size(), (piece + 1) * kTogether); ++t)
            fill(t);
    });
    return places;
}

} // namespace shadowlab::radiosity
