// Precision that each vertex needs, then connected parts, then origins.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/mesh_pieces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>

#include "techniques/foundation/base/disjoint_sets.h"
#include "techniques/foundation/scene/obj/vertex_welder.h"

namespace shadowlab::scene {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNone = 0xffffffffu;

/// Each piece is drawn, traced and judged as an object of its own. Where it took more of them, each reaches farther for less precision.
/// What reaches out of them may double the number.
constexpr std::size_t kMostPieces = 64;

/// An edge that is so many times as long as another one at its end joins nothing: the triangle is not part of the detail there, as where
/// one corner of a post was left at the origin. Less than the reach, so that what it separates may still share an origin.
constexpr double kLongEdge = 0x1p10;

double largest(const dvec3& v) { return glm::max(v.x, glm::max(v.y, v.z)); }
double distance(const dvec3& a, const dvec3& b) { return largest(glm::abs(a - b)); }

struct Box {
    dvec3 lower{kInfinity}, upper{-kInfinity};
    void include(const dvec3& position) { lower = glm::min(lower, position), upper = glm::max(upper, position); }
    [[nodiscard]] double size() const { return largest(upper - lower); }
    /// Below zero inside.
    [[nodiscard]] double distanceTo(const dvec3& position) const { return largest(glm::max(lower - position, position - upper)); }
};

/// A connected part. Its vertices stand in a row in `Cutter::members_`.
struct Component {
    std::size_t firstMember = 0, memberCount = 0, triangles = 0;
    Box box;
    double detail = kInfinity; ///< shortest edge that counts
    double coarsest = 0;       ///< of the shortest edges at its vertices, the longest
    std::uint32_t piece = kNone;

    [[nodiscard]] dvec3 centre() const { return 0.5 * (box.lower + box.upper); }
};

class Cutter {
public:
    Cutter(std::span<const dvec3> positions, std::span<const uvec3> triangles)
        : positions_(positions), triangles_(triangles), place_(samePlaces(positions)) {
        findDetails();
    }

    /// Does that origin hold all?
    [[nodiscard]] bool holds(const dvec3& origin) const {
        for (std::uint32_t v = 0; v < details_.size(); ++v)
            if (!holds(origin, v)) return false;
        return true;
    }

    MeshPieces cut() {
        findComponents();
        // A few thousand parts tell how far origins have to reach at least; a million of them would take seconds for each try.
        constexpr std::size_t kEnough = 8192;
        for (const std::size_t step : {std::max<std::size_t>(1, components_.size() / kEnough), std::size_t{1}})
            while (seedPieces(step) > kMostPieces)
                reach_ *= 2;
        return pieces();
    }

private:
    void findDetails() {
        details_.assign(positions_.size(), kInfinity);
        forEdges([&](std::uint32_t a, std::uint32_t b, double length) {
            details_[a] = std::min(details_[a], length);
            details_[b] = std::min(details_[b], length);
        });
        std::vector<double> sorted;
        std::ranges::copy_if(details_, std::back_inserter(sorted), [](double detail) { return detail < kInfinity; });
        if (sorted.empty()) return;
        const auto least = sorted.begin() + static_cast<std::ptrdiff_t>(kCrumbs * static_cast<double>(sorted.size()));
        std::ranges::nth_element(sorted, least);
        for (double& detail : details_)
            detail = std::max(detail, *least);
    }

    /// Edges that have a length, once for each triangle that has them.
    template <typename Take>
    void forEdges(const Take& take) const {
        for (const uvec3& triangle : triangles_)
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t a = place_[triangle[i]], b = place_[triangle[(i + 1) % 3]];
                if (a != b) take(a, b, glm::length(positions_[a] - positions_[b]));
            }
    }

    [[nodiscard]] bool holds(const dvec3& origin, std::uint32_t vertex) const {
        return distance(positions_[vertex], origin) <= reach_ * details_[vertex];
    }
    [[nodiscard]] static double farthest(const Component& component, const dvec3& origin) {
        return largest(glm::max(glm::abs(component.box.lower - origin), glm::abs(component.box.upper - origin)));
    }
    [[nodiscard]] bool holds(const dvec3& origin, const Component& component) const {
        if (farthest(component, origin) <= reach_ * component.detail) return true;
        if (component.box.distanceTo(origin) > reach_ * component.coarsest) return false; // scattered crumbs are millions of such questions
        return std::ranges::all_of(membersOf(component), [&](std::uint32_t v) { return holds(origin, v); });
    }
    [[nodiscard]] std::span<const std::uint32_t> membersOf(const Component& component) const {
        return std::span(members_).subspan(component.firstMember, component.memberCount);
    }

    /// The corner with the finest detail decides where a triangle belongs.
    [[nodiscard]] std::uint32_t componentOf(const uvec3& triangle) const {
        std::uint32_t finest = place_[triangle.x];
        for (const std::uint32_t corner : {triangle.y, triangle.z})
            if (details_[place_[corner]] < details_[finest]) finest = place_[corner];
        return componentOf_[finest];
    }

    void findComponents() {
        DisjointSets joined(positions_.size());
        forEdges([&](std::uint32_t a, std::uint32_t b, double length) {
            if (length <= kLongEdge * std::min(details_[a], details_[b])) joined.join(a, b);
        });
        componentOf_.assign(positions_.size(), kNone);
        for (std::uint32_t v = 0; v < positions_.size(); ++v) {
            if (place_[v] != v || details_[v] == kInfinity) continue;
            const std::uint32_t root = joined.nameOf(v); // the least of its part, so it was met before
            if (root == v) {
                componentOf_[v] = static_cast<std::uint32_t>(components_.size());
                components_.emplace_back();
            }
            Component& component = components_[componentOf_[v] = componentOf_[root]];
            ++component.memberCount;
            component.box.include(positions_[v]);
            component.detail = std::min(component.detail, details_[v]);
            component.coarsest = std::max(component.coarsest, details_[v]);
        }
        std::size_t next = 0;
        for (Component& component : components_)
            component.firstMember = next, next += component.memberCount, component.memberCount = 0;
        members_.resize(next);
        for (std::uint32_t v = 0; v < componentOf_.size(); ++v)
            if (componentOf_[v] != kNone) {
                Component& component = components_[componentOf_[v]];
                members_[component.firstMember + component.memberCount++] = v;
            }
        for (const uvec3& triangle : triangles_)
            if (const std::uint32_t component = componentOf(triangle); component != kNone) ++components_[component].triangles;
    }

    /// The finest part that is left gets an origin at its centre, and all that this one holds come along. Returns how many that makes;
    /// one that is too many is enough to know. Of the parts every one is taken, or one of `step`.
    std::size_t seedPieces(std::size_t step) {
        origins_.clear();
        std::vector<std::uint32_t> order;
        for (Component& component : components_)
            component.piece = kNone;
        for (std::size_t i = 0; i < components_.size(); i += step)
            if (components_[i].triangles > 0) order.push_back(static_cast<std::uint32_t>(i));
        std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return components_[i].detail; });
        for (const std::uint32_t seed : order) {
            if (components_[seed].piece != kNone) continue;
            if (origins_.size() == kMostPieces) return kMostPieces + 1;
            const auto piece = static_cast<std::uint32_t>(origins_.size());
            origins_.push_back(components_[seed].centre());
            for (const std::uint32_t other : order)
                if (components_[other].piece == kNone && (other == seed || holds(origins_.back(), components_[other])))
                    components_[other].piece = piece;
        }
        // A ground with long edges may have come along with a far village: its own is nearer.
        for (const std::uint32_t i : order) {
            Component& component = components_[i];
            for (std::uint32_t piece = 0; piece < origins_.size(); ++piece)
                if (farthest(component, origins_[piece]) < farthest(component, origins_[component.piece])) component.piece = piece;
        }
        return origins_.size();
    }

    /// In the middle of the piece's vertices, where that holds them all: the median, which a few that lie apart do not move. It is a
    /// round number, an eighth of the piece's size or finer, so that it can be read.
    [[nodiscard]] dvec3 roundOrigin(std::uint32_t piece, Box& box) const {
        std::vector<std::uint32_t> vertices;
        for (const Component& component : components_)
            if (component.piece == piece) vertices.insert(vertices.end(), membersOf(component).begin(), membersOf(component).end());
        dvec3 median(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const auto middle = vertices.begin() + static_cast<std::ptrdiff_t>(vertices.size() / 2);
            std::ranges::nth_element(vertices, middle, {}, [&](std::uint32_t v) { return positions_[v][axis]; });
            median[axis] = positions_[*middle][axis];
        }
        for (const std::uint32_t v : vertices)
            box.include(positions_[v]);
        const double grid = std::exp2(std::ceil(std::log2(box.size())) - 3);
        const dvec3 rounded = glm::round(median / grid) * grid;
        const bool holdsAll = std::ranges::all_of(vertices, [&](std::uint32_t v) { return holds(rounded, v); });
        return holdsAll ? rounded : origins_[piece];
    }

    [[nodiscard]] MeshPieces pieces() const {
        std::vector<std::size_t> triangles(origins_.size(), 0);
        for (const Component& component : components_)
            if (component.piece != kNone) triangles[component.piece] += component.triangles;
        std::vector<std::uint32_t> order(origins_.size()), rank(origins_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::stable_sort(order, std::greater<>(), [&](std::uint32_t piece) { return triangles[piece]; });
        MeshPieces result;
        std::vector<Box> boxes(order.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            rank[order[i]] = i;
            result.origins.push_back(roundOrigin(order[i], boxes[i]));
        }
        std::vector<std::uint32_t> reaching(order.size(), kNone);
        result.pieceOf.reserve(triangles_.size());
        for (const uvec3& triangle : triangles_) {
            const std::uint32_t component = componentOf(triangle);
            std::uint32_t piece = component == kNone ? 0 : rank[components_[component].piece]; // kNone: a triangle that is one point
            if (component != kNone && reachesOut(triangle, boxes[piece])) {
                if (reaching[piece] == kNone) {
                    reaching[piece] = static_cast<std::uint32_t>(result.origins.size());
                    result.origins.push_back(dvec3(result.origins[piece]));
                }
                piece = reaching[piece];
            }
            result.pieceOf.push_back(piece);
        }
        if (result.origins.size() < 2) result.pieceOf.clear();
        return result;
    }

    /// Does it leave the box of the detail by more than the box's size, so that nothing that is fitted to the box would fit any more?
    [[nodiscard]] bool reachesOut(const uvec3& triangle, const Box& box) const {
        for (int i = 0; i < 3; ++i) {
            const dvec3& corner = positions_[triangle[i]];
            if (box.distanceTo(corner) > box.size()) return true;
        }
        return false;
    }

    std::span<const dvec3> positions_;
    std::span<const uvec3> triangles_;
    std::vector<std::uint32_t> place_;
    std::vector<double> details_; ///< of each place: its shortest edge; infinite where no triangle has one
    double reach_ = kReachInEdges;
    std::vector<std::uint32_t> componentOf_; ///< of each place
    std::vector<Component> components_;
    std::vector<std::uint32_t> members_; ///< places, those of a component in a row
    std::vector<dvec3> origins_;
};

} // namespace

std::vector<std::uint32_t> samePlaces(std::span<const dvec3> positions) {
    VertexWelder welder(positions.size());
    std::vector<std::uint32_t> firstOf, places;
    places.reserve(positions.size());
    for (const dvec3& position : positions) {
        // The welder compares bits: two floats hold those of a double. Zero, added, turns -0 into +0.
        const auto bits = std::bit_cast<std::array<float, 6>>(position + dvec3(0.0));
        const std::uint32_t place =
            welder.index({.position = {bits[0], bits[1], bits[2]}, .normal = {bits[3], bits[4], bits[5]}});
        if (place == firstOf.size()) firstOf.push_back(static_cast<std::uint32_t>(places.size()));
        places.push_back(firstOf[place]);
    }
    return places;
}

MeshPieces meshPieces(std::span<const dvec3> positions, std::span<const uvec3> triangles, const dvec3& usual) {
    Cutter cutter(positions, triangles);
    return cutter.holds(usual) ? MeshPieces() : cutter.cut();
}

} // namespace shadowlab::scene
