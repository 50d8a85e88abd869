// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/obstacles.h"

#include <algorithm>

namespace shadowlab::trace {

namespace {

// The sign of a triangle's side counts as certain for a whole box of points when it is beyond rounding: a determinant of
// coordinates is wrong by some 1e-15 of their cube.
constexpr double kCertain = 1e-12;

/// The side of the triangle that the whole box is on; 0: on both, or not certain.
int sideOf(const Triangle& t, const CentredBox& box) {
    const dvec3 normal = frontOf(t), middle = 0.5 * (box.lower + box.upper), half = 0.5 * (box.upper - box.lower);
    const dvec3 offset = middle - t.a;
    const double height = glm::dot(normal, offset);
    const double doubt =
        glm::dot(glm::abs(normal), half + kCertain * (glm::abs(middle) + glm::abs(t.a) + half + glm::abs(offset)));
    return height > doubt ? 1 : height < -doubt ? -1 : 0;
}

} // namespace

bool AreaVisibility::Bounds::isBelow(std::initializer_list<dvec3> cornersCentred) const {
    return !horizons.empty() && std::ranges::all_of(horizons, [&](const Horizon& horizon) {
        return std::ranges::all_of(cornersCentred,
                                   [&](const dvec3& corner) { return glm::dot(horizon.up, corner) <= horizon.level; });
    });
}

/// What may matter to the points within some bounds.
class AreaVisibility::Obstacles::Filter {
public:
    Filter(const AreaVisibility& owner, const Bounds& bounds)
        : shaft(bounds.box, owner.box_), owner_(owner), bounds_(bounds), aroundPoints_(bounds.box),
          aroundLight_(owner.box_) {
        const CentredBox& box = bounds.box;
        const double reach =
            glm::length(glm::max(glm::abs(owner.box_.upper - box.lower), glm::abs(box.upper - owner.box_.lower)));
        aroundPoints_.grow(2 * kContact * reach + owner.nearness(bounds.largestMove, reach));
        aroundLight_.grow(2 * kContact * reach);
    }

    [[nodiscard]] bool isBelow(const Triangle& t) const { return bounds_.isBelow({t.a, t.b, t.c}); }
    [[nodiscard]] bool isNear(const Triangle& triangle) const {
        const CentredBox own = boxOf(triangle);
        return own.touches(aroundPoints_) || own.touches(aroundLight_);
    }
    [[nodiscard]] bool mayMatter(std::uint32_t primitive) const {
        const Triangle& triangle = triangleOf(primitive);
        return shaft.mayTouch(triangle) && !isBelow(triangle);
    }
    [[nodiscard]] bool mayBeContour(std::uint32_t edgeNumber) const {
        const SurfaceEdges::Edge& edge = owner_.edges_.edge(edgeNumber);
        if (isWithinSphere(edge.firstCentred) && isWithinSphere(edge.secondCentred)) return false;
        if (!shaft.mayTouch(edge.firstCentred, edge.secondCentred) ||
            bounds_.isBelow({edge.firstCentred, edge.secondCentred}))
            return false;
        int turn = 0;
        for (const SurfaceEdges::Use& use : owner_.edges_.uses(edge)) {
            if (!owner_.casts_[use.primitive]) continue;
            const int side = sideOf(triangleOf(use.primitive), bounds_.box);
            if (side == 0) return true;
            turn += side * use.direction;
        }
        return turn != 0;
    }
    [[nodiscard]] bool mayMatter(const SphereCut& cut) const {
        return shaft.mayTouch(cut.firstCentred, cut.secondCentred) && !isBelow(triangleOf(cut.primitive));
    }
    [[nodiscard]] const Triangle& triangleOf(std::uint32_t primitive) const {
        return owner_.tracer_.bvh().triangles[primitive];
    }

    const Shaft shaft;

private:
    /// What lies there hides nothing of it.
    [[nodiscard]] bool isWithinSphere(const dvec3& placeCentred) const {
        return owner_.light_.type == scene::LightType::sphere && glm::distance(placeCentred, owner_.centreCentred_) < owner_.light_.radius;
    }

    const AreaVisibility& owner_;
    const Bounds& bounds_;
    CentredBox aroundPoints_, aroundLight_;
};

AreaVisibility::Obstacles::Obstacles(const AreaVisibility& owner, const Bounds& bounds) {
    const Filter filter(owner, bounds);
    const auto casts = [&](std::uint32_t primitive) { return owner.casts_[primitive] != 0; };
    for (const std::uint32_t primitive : filter.shaft.triangles(owner.tracer_.bvh(), casts)) {
        const Triangle& triangle = filter.triangleOf(primitive);
        if (filter.isBelow(triangle)) continue;
        if (owner.tracer_.mayHaveHoles(primitive)) perforated.push_back(primitive);
        if (filter.isNear(triangle)) near.push_back(primitive);
        for (const std::uint32_t edge : owner.edges_.ofPrimitive(primitive))
            if (filter.mayBeContour(edge)) edges.push_back(edge);
    }
    for (std::uint32_t cut = 0; cut < owner.cuts_.chords().size(); ++cut)
        if (filter.mayMatter(owner.cuts_.chords()[cut])) cuts.push_back(cut);
    std::ranges::sort(edges); // each comes from all of its triangles
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

AreaVisibility::Obstacles AreaVisibility::Obstacles::narrowed(const AreaVisibility& owner, const Bounds& bounds) const {
    const Filter filter(owner, bounds);
    Obstacles left;
    for (const std::uint32_t edge : edges)
        if (filter.mayBeContour(edge)) left.edges.push_back(edge);
    for (const std::uint32_t cut : cuts)
        if (filter.mayMatter(owner.cuts_.chords()[cut])) left.cuts.push_back(cut);
    for (const std::uint32_t primitive : near)
        if (filter.mayMatter(primitive) && filter.isNear(filter.triangleOf(primitive))) left.near.push_back(primitive);
    for (const std::uint32_t primitive : perforated)
        if (filter.mayMatter(primitive)) left.perforated.push_back(primitive);
    return left;
}

} // namespace shadowlab::trace
