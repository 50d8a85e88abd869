// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/simple_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowlab::scene {

namespace {

// Relative to the lengths that are multiplied: what rounding in double can make of zero is a thousand times less.
constexpr double kClearOfPlane = 1e-12;

// Entries of the grid per triangle, on average, at which it is given up.
constexpr std::size_t kMostEntries = 64;

// Pairs in one cell per triangle, likewise: some hundred where triangles are of one size, far more where a few large ones make
// the cells large.
constexpr std::size_t kMostPairs = 4096;

struct Corner {
    dvec3 position{0.0};
    std::uint32_t vertex = 0; ///< welded
};
using SurfaceTriangle = std::array<Corner, 3>;

dvec3 edgeOf(const SurfaceTriangle& t, std::size_t i) { return t[(i + 1) % 3].position - t[i].position; }
dvec3 normalOf(const SurfaceTriangle& t) { return glm::cross(edgeOf(t, 0), t[2].position - t[0].position); }

/// True if the intervals of the two triangles along the axis do not overlap.
bool separates(const dvec3& axis, const SurfaceTriangle& a, const SurfaceTriangle& b) {
    double lower[2] = {1e300, 1e300}, upper[2] = {-1e300, -1e300};
    const SurfaceTriangle* both[2] = {&a, &b};
    for (int k = 0; k < 2; ++k)
        for (const Corner& corner : *both[k]) {
            // From a corner of the first: far from zero the products would lose their digits.
            const double at = glm::dot(axis, corner.position - a[0].position);
            lower[k] = std::min(lower[k], at);
            upper[k] = std::max(upper[k], at);
        }
    const double clear = kClearOfPlane * sumOfMagnitudes(axis) *
                         (std::abs(upper[0] - lower[0]) + std::abs(upper[1] - lower[1])) /
                         std::max(glm::length(axis), 1e-300);
    return lower[1] - upper[0] > clear || lower[0] - upper[1] > clear;
}

bool areApart(const SurfaceTriangle& a, const SurfaceTriangle& b) {
    const dvec3 normalA = normalOf(a), normalB = normalOf(b);
    if (separates(normalA, a, b) || separates(normalB, a, b)) return true;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (separates(glm::cross(edgeOf(a, i), edgeOf(b, j)), a, b)) return true;
    for (std::size_t i = 0; i < 3; ++i) // both in one plane
        if (separates(glm::cross(normalA, edgeOf(a, i)), a, b) || separates(glm::cross(normalB, edgeOf(b, i)), a, b))
            return true;
    return false;
}

/// Two rays from the corner that both have along the sides of each triangle; the axis is square to a plane through it.
bool separatesAtCorner(const dvec3& axis, const std::array<dvec3, 2>& a, const std::array<dvec3, 2>& b) {
    const auto side = [&](const dvec3& ray) {
        const double at = glm::dot(axis, ray), clear = kClearOfPlane * sumOfMagnitudes(axis) * sumOfMagnitudes(ray);
        return at > clear ? 1 : at < -clear ? -1 : 0;
    };
    const int ofA[2] = {side(a[0]), side(a[1])}, ofB[2] = {side(b[0]), side(b[1])};
    for (const int sign : {1, -1}) {
        const bool onSides = sign * ofA[0] >= 0 && sign * ofA[1] >= 0 && sign * ofB[0] <= 0 && sign * ofB[1] <= 0;
        if (!onSides) continue;
        const bool touchesA = ofA[0] == 0 || ofA[1] == 0, touchesB = ofB[0] == 0 || ofB[1] == 0;
        if (!touchesA || !touchesB) return true;
        if ((ofA[0] == 0 && ofA[1] == 0) || (ofB[0] == 0 && ofB[1] == 0)) continue;
        // A ray of each lies in the plane: they must not be the same one.
        const dvec3 &p = ofA[0] == 0 ? a[0] : a[1], &q = ofB[0] == 0 ? b[0] : b[1];
        const dvec3 across = glm::cross(p, q);
        if (glm::length(across) > 1e-6 * glm::length(p) * glm::length(q) || glm::dot(p, q) < 0) return true;
    }
    return false;
}

bool meetInCornerAlone(const SurfaceTriangle& a, std::size_t i, const SurfaceTriangle& b, std::size_t j) {
    const dvec3& at = a[i].position;
    const std::array<dvec3, 2> raysA = {a[(i + 1) % 3].position - at, a[(i + 2) % 3].position - at};
    const std::array<dvec3, 2> raysB = {b[(j + 1) % 3].position - at, b[(j + 2) % 3].position - at};
    const dvec3 normalA = glm::cross(raysA[0], raysA[1]), normalB = glm::cross(raysB[0], raysB[1]);
    if (separatesAtCorner(normalA, raysA, raysB) || separatesAtCorner(normalB, raysA, raysB)) return true;
    for (const dvec3& rayA : raysA)
        for (const dvec3& rayB : raysB)
            if (separatesAtCorner(glm::cross(rayA, rayB), raysA, raysB)) return true;
    for (const auto& [normal, rays] : {std::pair(normalA, raysA), std::pair(normalB, raysB)}) // both in one plane
        for (const dvec3& ray : rays)
            if (separatesAtCorner(glm::cross(normal, ray), raysA, raysB)) return true;
    return false;
}

/// Two triangles at one edge meet elsewhere only when one is folded flat onto the other.
bool meetInEdgeAlone(const SurfaceTriangle& a, const SurfaceTriangle& b) {
    const auto shares = [](const SurfaceTriangle& t, std::uint32_t vertex) {
        return std::ranges::any_of(t, [&](const Corner& corner) { return corner.vertex == vertex; });
    };
    std::size_t loneA = 0, loneB = 0;
    while (shares(b, a[loneA].vertex))
        ++loneA;
    while (shares(a, b[loneB].vertex))
        ++loneB;
    const dvec3 from = a[(loneA + 1) % 3].position, along = a[(loneA + 2) % 3].position - from;
    const dvec3 toA = a[loneA].position - from, toB = b[loneB].position - from;
    const dvec3 normalA = glm::cross(along, toA), normalB = glm::cross(along, toB);
    const double volume = glm::dot(normalA, toB);
    return std::abs(volume) > kClearOfPlane * sumOfMagnitudes(normalA) * sumOfMagnitudes(toB) ||
           glm::dot(normalA, normalB) < 0;
}

bool meetAsTheyMay(const SurfaceTriangle& a, const SurfaceTriangle& b) {
    std::size_t shared = 0, cornerA = 0, cornerB = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (a[i].vertex == b[j].vertex) ++shared, cornerA = i, cornerB = j;
    switch (shared) {
    case 0: return areApart(a, b);
    case 1: return meetInCornerAlone(a, cornerA, b, cornerB);
    case 2: return meetInEdgeAlone(a, b);
    default: return false;
    }
}

struct Box {
    dvec3 lower{1e300}, upper{-1e300};
};

/// Cubes about as large as the triangles; each holds those whose boxes reach into it.
class Grid {
public:
    Grid(std::span<const Box> boxes) {
        dvec3 extent(0.0);
        for (const Box& box : boxes) {
            lower_ = glm::min(lower_, box.lower);
            extent += (box.upper - box.lower) / static_cast<double>(boxes.size());
        }
        side_ = std::max({extent.x, extent.y, extent.z, 1e-300}) * 1.5;
    }
    [[nodiscard]] glm::ivec3 cellOf(const dvec3& position) const {
        return glm::ivec3(glm::floor((position - lower_) / side_));
    }
    /// Into how many cells a box reaches; more than there are numbers for where it is too far away.
    [[nodiscard]] double cellsOf(const Box& box) const {
        const dvec3 cells = (box.upper - lower_) / side_;
        if (!(std::max({cells.x, cells.y, cells.z}) < kMostCells)) return 1e300;
        const dvec3 across = dvec3(cellOf(box.upper) - cellOf(box.lower)) + 1.0;
        return across.x * across.y * across.z;
    }
    template <typename Visit>
    void forEachCell(const Box& box, const Visit& visit) const {
        const glm::ivec3 first = cellOf(box.lower), last = cellOf(box.upper);
        for (int x = first.x; x <= last.x; ++x)
            for (int y = first.y; y <= last.y; ++y)
                for (int z = first.z; z <= last.z; ++z)
                    visit(number({x, y, z}));
    }
    [[nodiscard]] std::uint64_t numberOf(const dvec3& position) const { return number(cellOf(position)); }

private:
    static constexpr std::uint64_t kMostCells = 1u << 20; ///< along an axis, so that three fit into one number
    static std::uint64_t number(const glm::ivec3& cell) {
        return (static_cast<std::uint64_t>(cell.x) * kMostCells + static_cast<std::uint64_t>(cell.y)) * kMostCells +
               static_cast<std::uint64_t>(cell.z);
    }
    dvec3 lower_{1e300};
    double side_ = 1;
};

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) && glm::all(glm::lessThanEqual(b.lower, a.upper));
}

} // namespace

bool isCertainlySimple(const Mesh& mesh, const MeshTopology& topology, std::span<const std::uint32_t> triangles) {
    std::vector<SurfaceTriangle> surface(triangles.size());
    std::vector<Box> boxes(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const uvec3& t = mesh.triangles[triangles[i]];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = topology.welded[t[static_cast<int>(k)]];
            surface[i][k] = {dvec3(mesh.positionsMesh[vertex]), vertex};
            boxes[i].lower = glm::min(boxes[i].lower, surface[i][k].position);
            boxes[i].upper = glm::max(boxes[i].upper, surface[i][k].position);
        }
    }
    const Grid grid(boxes);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> entries; // cell, triangle
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (static_cast<double>(entries.size()) + grid.cellsOf(boxes[i]) > kMostEntries * (boxes.size() + 16))
            return false;
        grid.forEachCell(boxes[i],
                         [&](std::uint64_t cell) { entries.emplace_back(cell, static_cast<std::uint32_t>(i)); });
    }
    std::ranges::sort(entries);
    std::size_t pairs = 0;
    for (std::size_t first = 0; first < entries.size();) {
        std::size_t end = first;
        while (end < entries.size() && entries[end].first == entries[first].first)
            ++end;
        pairs += (end - first) * (end - first) / 2;
        if (pairs > kMostPairs * (boxes.size() + 16)) return false;
        for (std::size_t i = first; i < end; ++i)
            for (std::size_t j = i + 1; j < end; ++j) {
                const std::uint32_t a = entries[i].second, b = entries[j].second;
                if (!overlap(boxes[a], boxes[b])) continue;
                // Two boxes may share several cells: the one with the lower corner of what they have in common counts.
                if (grid.numberOf(glm::max(boxes[a].lower, boxes[b].lower)) != entries[first].first) continue;
                if (!meetAsTheyMay(surface[a], surface[b])) return false;
            }
        first = end;
    }
    return true;
}

} // namespace shadowlab::scene
