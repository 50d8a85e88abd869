// SPDX-License-Identifier: MIT
#include "app/figures/volume/volume_sketch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

constexpr std::size_t kFewEdges =
    120; ///< of an outline: of so few each is cut in pieces, so that it bends with what it meets
constexpr int kEdgePieces = 4;
constexpr double kAround = 0.1;        ///< of the shadow's size: what is shown of a floor beside it
constexpr double kBeyond = 1.25;       ///< of the way to what is hit: so much is drawn of a volume that goes on
constexpr double kCurveGap = 0.02;     ///< of the caster's size: what lies farther apart is not one curve
constexpr double kSketchNear = 2.2;    ///< of the size of all else: a light that is farther away is drawn nearer
constexpr dvec2 kSketchMargin{70, 56}; ///< pixels for labels

} // namespace

VolumeSketch::VolumeSketch(const FigureSource& source, const CasterSolid& solid, const drawing::Box& area, bool hasEnds)
    : scene_(source.scene), solid_(solid), area_(area) {
    findReceivers();
    findStrips();
    chooseView(source.view.camera.positionWorld, hasEnds);
}

dvec3 VolumeSketch::away(const dvec3& placeWorld) const { return -glm::normalize(solid_.toLight(placeWorld)); }

void VolumeSketch::findReceivers() {
    for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
        const scene::Object& object = scene_.objects[o];
        if (o == solid_.caster->object || !object.receivesShadow) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        for (const uvec3& t : object.mesh->triangles) {
            Triangle triangle{{}, o};
            for (int i = 0; i < 3; ++i)
                triangle.cornersWorld[static_cast<std::size_t>(i)] =
                    transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[t[i]]));
            others_.push_back(triangle);
        }
    }
}

/// After Moeller and Trumbore (1997).
std::optional<VolumeSketch::Hit> VolumeSketch::firstHit(const dvec3& fromWorld, const dvec3& way, double most) const {
    constexpr double kContact = 1e-6; // metres: what lies on a floor touches it
    std::optional<Hit> first;
    for (const Triangle& triangle : others_) {
        const CasterSolid::Corners& c = triangle.cornersWorld;
        const dvec3 u = c[1] - c[0], v = c[2] - c[0], p = glm::cross(way, v);
        const double area = glm::dot(u, p);
        if (area == 0) continue;
        const dvec3 t = fromWorld - c[0];
        const double a = glm::dot(t, p) / area;
        if (a < 0 || a > 1) continue;
        const dvec3 q = glm::cross(t, u);
        const double b = glm::dot(way, q) / area, distance = glm::dot(v, q) / area;
        if (b < 0 || a + b > 1 || distance < kContact || distance > (first ? first->distance : most)) continue;
        const dvec3 normal = glm::normalize(glm::cross(u, v));
        first = Hit{fromWorld + distance * way, distance, triangle.object, dvec4(normal, -glm::dot(normal, c[0]))};
    }
    return first;
}

bool VolumeSketch::onOnePlane(const std::optional<Hit>& a, const std::optional<Hit>& b) const {
    constexpr double kFlat = 1e-6; // positions are floats of about a metre
    if (!a || !b) return false;
    return glm::length(dvec3(a->planeWorld) - dvec3(b->planeWorld)) < kFlat &&
           std::abs(a->planeWorld.w - b->planeWorld.w) < kFlat * size_;
}

double VolumeSketch::lengthOf(std::uint32_t vertex) const {
    const dvec4& end = solid_.caster->extrudedWorld[vertex];
    return end.w == 0 ? std::numeric_limits<double>::infinity()
                      : glm::length(dvec3(end) - solid_.verticesWorld[vertex]);
}

/// One strip where both its ends fall on one plane: what is between them does, too, along a line. Else it is halved, so that the
/// curve bends where the surface does.
void VolumeSketch::addStrips(const VolumeProbe::Caster::SilhouetteEdge& edge, double from, double to, int depth) {
    Strip strip;
    strip.isBorder = from == 0;
    const std::array shares{from, to};
    for (std::size_t end = 0; end < 2; ++end) {
        strip.fromWorld[end] = glm::mix(solid_.verticesWorld[edge.a], solid_.verticesWorld[edge.b], shares[end]);
        strip.toWorld[end] = glm::mix(drawnEnd(edge.a), drawnEnd(edge.b), shares[end]);
        strip.hits[end] = firstHit(strip.fromWorld[end], away(strip.fromWorld[end]),
                                   std::min(glm::length(strip.toWorld[end] - strip.fromWorld[end]), cutOff_));
    }
    const auto& [first, second] = strip.hits;
    const bool misses = !first && !second;
    if (depth > 0 && !misses && !onOnePlane(first, second)) {
        const double middle = 0.5 * (from + to);
        addStrips(edge, from, middle, depth - 1);
        addStrips(edge, middle, to, depth - 1);
        return;
    }
    strips_.push_back(strip);
    // From one surface to the next, but not across a gap between them.
    if (first && second &&
        (onOnePlane(first, second) || glm::length(first->placeWorld - second->placeWorld) < kCurveGap * size_))
        curveWorld_.insert(curveWorld_.end(), {first->placeWorld, second->placeWorld});
}

/// What of a polygon of the top cap falls on one plane.
void VolumeSketch::addShadow(const std::array<dvec3, 3>& c, int depth) {
    std::array<std::optional<Hit>, 3> hits;
    for (std::size_t i = 0; i < 3; ++i)
        hits[i] = firstHit(c[i], away(c[i]), cutOff_);
    if (onOnePlane(hits[0], hits[1]) && onOnePlane(hits[1], hits[2])) {
        for (const auto& hit : hits)
            shadowWorld_.push_back(hit->placeWorld);
        return;
    }
    if (depth == 0 || (!hits[0] && !hits[1] && !hits[2])) return;
    const dvec3 ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), ca = 0.5 * (c[2] + c[0]);
    for (const std::array<dvec3, 3>& part :
         {std::array{c[0], ab, ca}, std::array{ab, c[1], bc}, std::array{ca, bc, c[2]}, std::array{ab, bc, ca}})
        addShadow(part, depth - 1);
}

void VolumeSketch::findStrips() {
    const VolumeProbe::Caster& caster = *solid_.caster;
    scene::Bounds box;
    for (const dvec3& vertex : solid_.verticesWorld)
        box.include(vertex);
    size_ = glm::length(box.upperWorld - box.lowerWorld);
    double longest = 0, farthest = 0;
    std::map<std::size_t, int> met;
    for (const VolumeProbe::Caster::SilhouetteEdge& edge : caster.outline) {
        const dvec3& from = solid_.verticesWorld[edge.a];
        longest = std::max({longest, lengthOf(edge.a), lengthOf(edge.b)});
        if (const auto hit = firstHit(from, away(from), lengthOf(edge.a))) {
            farthest = std::max(farthest, hit->distance);
            ++met[hit->object];
        }
    }
    cutOff_ = std::max(kBeyond * farthest, size_);
    isCutOff_ = longest > cutOff_ * (1 + 1e-9);
    if (!isCutOff_) cutOff_ = longest;
    if (!met.empty())
        receiver_ =
            scene_.objects[std::ranges::max_element(met, {}, [](const auto& one) { return one.second; })->first].name;

    const bool isCoarse = caster.outline.size() <= kFewEdges;
    for (const VolumeProbe::Caster::SilhouetteEdge& edge : caster.outline)
        for (int i = 0; i < (isCoarse ? kEdgePieces : 1); ++i)
            addStrips(edge, isCoarse ? static_cast<double>(i) / kEdgePieces : 0,
                      isCoarse ? static_cast<double>(i + 1) / kEdgePieces : 1, isCoarse ? 8 : 3);
    for (std::size_t i = 0; i + 2 < caster.topCap.size(); i += 3)
        addShadow({solid_.verticesWorld[caster.topCap[i]], solid_.verticesWorld[caster.topCap[i + 1]],
                   solid_.verticesWorld[caster.topCap[i + 2]]},
                  isCoarse ? 4 : 0);
    shownWorld_ = box;
    for (const dvec3& place : curveWorld_)
        shownWorld_.include(place);
    const double more = kAround * glm::length(shownWorld_.upperWorld - shownWorld_.lowerWorld);
    shownWorld_.lowerWorld -= more;
    shownWorld_.upperWorld += more;
}

dvec3 VolumeSketch::drawnEnd(std::uint32_t vertex) const {
    const dvec3& from = solid_.verticesWorld[vertex];
    const dvec4& end = solid_.caster->extrudedWorld[vertex];
    if (end.w != 0 && glm::length(dvec3(end) - from) <= cutOff_) return dvec3(end);
    return from + cutOff_ * away(from);
}

dvec3 VolumeSketch::firstMet(std::uint32_t vertex) const {
    const dvec3& from = solid_.verticesWorld[vertex];
    const auto hit = firstHit(from, away(from), std::min(lengthOf(vertex), cutOff_));
    return hit ? hit->placeWorld : drawnEnd(vertex);
}

void VolumeSketch::placeLight(double size, const dvec3& middleWorld) {
    const dvec3 toLight = solid_.toLight(middleWorld);
    lightIsNear_ = solid_.lightWorld.w != 0 && glm::length(toLight) < kSketchNear * size;
    lightWorld_ = lightIsNear_ ? dvec3(solid_.lightWorld) : middleWorld + 0.75 * size * glm::normalize(toLight);
}

/// All that is drawn where the volume meets something: what of it lies beyond that is cut off at the border.
std::vector<dvec3> VolumeSketch::seenPlaces(const dvec3& middleWorld) const {
    std::vector<dvec3> seen(solid_.verticesWorld);
    seen.insert(seen.end(), curveWorld_.begin(), curveWorld_.end());
    for (const Strip& strip : strips_)
        for (std::size_t end = 0; end < 2; ++end)
            if (!strip.hits[end]) seen.push_back(strip.toWorld[end]);
    const double lowest = std::ranges::min_element(seen, {}, &dvec3::y)->y;
    seen.push_back(lightWorld_);
    for (int corner = 0; corner < 8; ++corner) { // what is shown of a floor
        dvec3 place = shownWorld_.corner(corner);
        if (place.y >= middleWorld.y) continue;
        place.y = std::max(place.y, lowest);
        seen.push_back(place);
    }
    return seen;
}

/// From the side of the light's way, a little from above, and rather from where the eye is.
void VolumeSketch::chooseView(const dvec3& eyeWorld, bool hasEnds) {
    std::vector<dvec3> shown(solid_.verticesWorld);
    for (const Strip& strip : strips_)
        shown.insert(shown.end(), strip.toWorld.begin(), strip.toWorld.end());
    scene::Bounds box;
    for (const dvec3& place : shown)
        box.include(place);
    const dvec3 middle = 0.5 * (box.lowerWorld + box.upperWorld);
    placeLight(glm::length(box.upperWorld - box.lowerWorld), middle);
    shown.push_back(lightWorld_);
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 place = shownWorld_.corner(corner);
        if (place.y < middle.y) shown.push_back(place); // what is shown of a floor
    }
    const dvec3 axis = glm::normalize(lightWorld_ - middle), towardEye = glm::normalize(eyeWorld - middle);
    const dvec3 best = bestDirection([&](const dvec3& d) {
        const double height = d.y > 0.2 && d.y < 0.5 ? 0.35 : d.y < 0 ? -1 : 0;
        return glm::length(glm::cross(axis, d)) + height + 0.25 * glm::dot(d, towardEye);
    });
    view_.emplace(hasEnds || curveWorld_.empty() ? shown : seenPlaces(middle), best, area_, kSketchMargin);
}

} // namespace shadowlab::figures
