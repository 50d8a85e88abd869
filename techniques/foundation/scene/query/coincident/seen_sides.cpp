// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/coincident/seen_sides.h"

#include <algorithm>
#include <map>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/coincident/placed_triangle.h"

namespace shadowlab::scene {

namespace {

using Polygon = std::vector<dvec2>; ///< convex

/// What of the polygon lies beyond the line through `from` and `to`, seen from the other side of `within`; thinner than `slack`: nothing.
/// `rest`: what lies before it.
Polygon cutOff(const Polygon& polygon, const dvec2& from, const dvec2& to, const dvec2& within, double slack, Polygon& rest) {
    dvec2 across(to.y - from.y, from.x - to.x);
    const double length = glm::length(across);
    across *= (glm::dot(across, within - from) > 0 ? -1 : 1) / length;
    const auto beyond = [&](const dvec2& p) { return glm::dot(across, p - from); };
    Polygon outside;
    rest.clear();
    double most = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2 &p = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        const double here = beyond(p), there = beyond(next);
        most = std::max(most, here);
        if (here >= 0) outside.push_back(p);
        if (here <= 0) rest.push_back(p);
        if (here * there >= 0) continue;
        const dvec2 crossing = p + here / (here - there) * (next - p);
        outside.push_back(crossing);
        rest.push_back(crossing);
    }
    if (most > slack) return outside;
    rest = polygon;
    return {};
}

/// Do the others, taken together, cover the triangle, but for slivers of rounding?
bool isCovered(const PlacedTriangle& triangle, const std::vector<const PlacedTriangle*>& others) {
    constexpr std::size_t kMostPieces = 256; // of a floor under many tiles; to call it not covered is right as well, only slower
    const int axis = mainAxis(triangle.normal);
    const auto flat = [axis](const dvec3& p) { return dvec2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
    const auto polygonOf = [&](const PlacedTriangle& t) {
        return Polygon{flat(t.cornersWorld[0]), flat(t.cornersWorld[1]), flat(t.cornersWorld[2])};
    };
    std::vector<Polygon> left{polygonOf(triangle)};
    Polygon rest;
    for (const PlacedTriangle* other : others) {
        const Polygon cover = polygonOf(*other);
        const double slack = 3 * (triangle.rounding + other->rounding);
        std::vector<Polygon> pieces;
        for (Polygon piece : left)
            for (std::size_t i = 0; i < 3 && piece.size() > 2; ++i) {
                Polygon outside = cutOff(piece, cover[i], cover[(i + 1) % 3], cover[(i + 2) % 3], slack, rest);
                if (outside.size() > 2) pieces.push_back(std::move(outside));
                piece = rest;
            }
        left = std::move(pieces);
        if (left.empty()) return true;
        if (left.size() > kMostPieces) return false;
    }
    return false;
}

/// The sides of all triangles that coincide with others, and what stands over and under each.
class Layers {
public:
    Layers(const Scene& scene, const CoincidentFaces& faces);
    [[nodiscard]] std::vector<SeenSides> result() const;

private:
    struct Entry {
        PlacedTriangle placed;
        const Object* object = nullptr;
        bool coversWhole = true; ///< no holes
        SeenSide sides[2];       ///< back, front
    };
    struct Side {
        std::uint32_t triangle;
        bool isFront;
    };
    [[nodiscard]] SideRank rankOf(const Side& side) const { return faces_.rank(side.triangle, side.isFront); }
    [[nodiscard]] SeenSide& at(const Side& side) { return entries_.at(side.triangle).sides[side.isFront ? 1 : 0]; }
    /// The side of the pair's other triangle that an eye would see in the place of this one.
    static Side otherSide(const Side& side, const CoincidentFaces::Pair& pair) {
        return {pair.other, side.isFront == pair.faceAlike};
    }
    [[nodiscard]] bool isInner(const Side& side) const {
        return CoincidentFaces::isInner(scene_, *entries_.at(side.triangle).object, side.isFront);
    }
    void hide(const Side& side);
    void findWithin(const CoincidentFaces::Triangle& triangle);
    void lift(const Side& side);
    [[nodiscard]] bool mayShade(const Side& under, const Side& side) const;
    [[nodiscard]] bool areTwins(const Side& a, const Side& b) const;

    const Scene& scene_;
    const CoincidentFaces& faces_;
    std::map<std::uint32_t, Entry> entries_;
};

Layers::Layers(const Scene& scene, const CoincidentFaces& faces) : scene_(scene), faces_(faces) {
    std::map<std::uint32_t, TrianglePlacer> placers; // by object
    for (const CoincidentFaces::Triangle& triangle : faces.triangles()) {
        const Object& object = scene.objects[triangle.object];
        const TrianglePlacer& place = placers.try_emplace(triangle.object, object).first->second;
        const bool isHoled = hasHoles(scene, object) && maskOfPart(scene, object, partOf(*object.mesh, triangle.inObject));
        entries_[triangle.number] = {place(triangle.inObject), &object, !isHoled, {}};
    }
    std::vector<Side> sides;
    for (const auto& [triangle, entry] : entries_) {
        sides.push_back({triangle, false});
        sides.push_back({triangle, true});
    }
    std::ranges::sort(sides, {}, [&](const Side& side) { return rankOf(side); }); // the lowest first
    for (const Side& side : sides)
        hide(side);
    for (const Side& side : sides)
        lift(side);
    for (const CoincidentFaces::Triangle& triangle : faces.triangles())
        if (!hasHoles(scene, scene.objects[triangle.object])) findWithin(triangle);
}

void Layers::hide(const Side& side) {
    std::vector<const PlacedTriangle*> over;
    for (const CoincidentFaces::Pair& pair : faces_.of(side.triangle)) {
        const Entry& other = entries_.at(pair.other);
        if (other.coversWhole && rankOf(otherSide(side, pair)) > rankOf(side)) over.push_back(&other.placed);
    }
    at(side).isHidden = isCovered(entries_.at(side.triangle).placed, over);
}

/// The inner skin of a body that is written twice. The depths of the two sides of an edge at which the body turns away from the eye are
/// equal, but for rounding, so without this a few pixels along it would show the inside.
void Layers::findWithin(const CoincidentFaces::Triangle& triangle) {
    std::vector<const PlacedTriangle*> skin;
    for (const CoincidentFaces::Pair& pair : faces_.of(triangle.number)) {
        const CoincidentFaces::Triangle& other = faces_.triangle(pair.other);
        if (!pair.faceAlike && other.object == triangle.object && faces_.isInOuterSkin(scene_.objects[other.object], other.inObject))
            skin.push_back(&entries_.at(pair.other).placed);
    }
    Entry& entry = entries_.at(triangle.number);
    if (!skin.empty()) entry.sides[1].isWithin = isCovered(entry.placed, skin);
}

/// Could the shadow volume of the lower one begin in front of this side by rounding, and put it in shadow? Every triangle that casts has a
/// cap in its own plane, also one that is turned over: with its corners in another order its depths are others by rounding. Of a closed
/// body the inner side is no danger: what stands on this side is the far end of its volume.
bool Layers::mayShade(const Side& under, const Side& side) const {
    const Entry &lower = entries_.at(under.triangle), &upper = entries_.at(side.triangle);
    const bool same = lower.object->mesh == upper.object->mesh && lower.object->worldFromObject == upper.object->worldFromObject &&
                      lower.placed.cornersWorld == upper.placed.cornersWorld;
    return lower.object->castsShadow && !same && !isInner(under);
}

/// Two triangles of one object with the same three corners: the rasteriser moves these alike, so the depths differ by rounding alone.
bool Layers::areTwins(const Side& a, const Side& b) const {
    const Entry &one = entries_.at(a.triangle), &other = entries_.at(b.triangle);
    return one.object == other.object && std::ranges::is_permutation(one.placed.cornersWorld, other.placed.cornersWorld);
}

void Layers::lift(const Side& side) {
    if (at(side).isHidden) return;
    int layer = 0;
    bool isUnder = false;
    for (const CoincidentFaces::Pair& pair : faces_.of(side.triangle)) {
        const Side other = otherSide(side, pair);
        isUnder |= rankOf(other) > rankOf(side);
        if (rankOf(other) > rankOf(side) || isInner(other)) continue;
        if (!at(other).isHidden) layer = std::max(layer, at(other).layer + 1);
        if (!mayShade(other, side)) continue;
        if (areTwins(other, side))
            at(side).isTwin = true;
        else
            layer = std::max(layer, 1);
    }
    // The inner side of a body that stands partly beside what it stands on: seen from within alone, so it is what gives way.
    if (isInner(side) && isUnder) layer = -1;
    at(side).layer = static_cast<std::int8_t>(std::min(layer, 100)); // nobody stacks so many decals
}

std::vector<SeenSides> Layers::result() const {
    std::vector<SeenSides> result;
    for (const auto& [triangle, entry] : entries_) {
        SeenSides sides{triangle, entry.sides[1], entry.sides[0]};
        for (const CoincidentFaces::Pair& pair : faces_.of(triangle))
            sides.gap = std::max(sides.gap, pair.gap);
        if (!sides.isOrdinary()) result.push_back(sides);
    }
    return result;
}

} // namespace

std::vector<SeenSides> seenSides(const Scene& scene, const CoincidentFaces& faces) {
    return faces.isEmpty() ? std::vector<SeenSides>{} : Layers(scene, faces).result();
}

} // namespace shadowlab::scene
