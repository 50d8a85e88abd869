// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/area_asker.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/bvh/bvh_traverse.h"

namespace shadowlab::trace {

namespace {

// Number of rays if triangles with holes cover the whole light; a piece gets its share of them.
constexpr double kSamples = 1024;

/// A part of an edge, from 0 at its first end to 1 at its second.
struct Part {
    double begin = 0, end = 1;
    /// Leaves out where a function, given by its values at the ends, is negative.
    void keep(double atFirst, double atSecond) {
        if (atFirst < 0 && atSecond < 0) end = -1;
        if (atFirst < 0 && atSecond >= 0) begin = std::max(begin, atFirst / (atFirst - atSecond));
        if (atFirst >= 0 && atSecond < 0) end = std::min(end, atFirst / (atFirst - atSecond));
    }
};

} // namespace

/// Products with these tell where on the light's plane something is seen, and how far on the way there it is.
struct AreaVisibility::Asker::LightPlane {
    explicit LightPlane(const SeenLight& seen) {
        const dvec3 across = glm::cross(seen.axisU, seen.axisV);
        unitArea = glm::length(across);
        placeU = glm::cross(seen.axisV, across) / (unitArea * unitArea);
        placeV = glm::cross(across, seen.axisU) / (unitArea * unitArea);
        depth = across / glm::dot(across, seen.middle);
        middle = dvec2(glm::dot(placeU, seen.middle), glm::dot(placeV, seen.middle));
    }
    dvec3 placeU, placeV, depth;
    dvec2 middle;
    double unitArea; ///< m^2, of the square between the axes
};

AreaShare AreaVisibility::Asker::ask(const SurfacePoint& point, double move) {
    // Within a sphere there is no disc; its centre answers for it.
    if (!lookFrom(point, move))
        return {owner_.tracer_.visibility(point, owner_.number_) == Visibility::lit ? 1.0 : 0.0, 1.0};
    double visible = 0;
    pieces_.cut(outline_, borders_, contours_, [&](std::span<const dvec2> polygon) {
        const LightPiece piece(seen_, polygon);
        if (piece.area() > 0) visible += piece.area() * seenOf(piece, polygon, dvec3(0.0)).area;
    });
    return {std::clamp(visible / seen_.area, 0.0, 1.0), change_};
}

AreaIrradiance AreaVisibility::Asker::askIrradiance(const SurfacePoint& point, const dvec3& normalWorld) {
    if (!lookFrom(point, 0))
        return {owner_.tracer_.visibility(point, owner_.number_) == Visibility::lit ? 1.0 : 0.0, 0.0, 0.0};
    const bool receives = owner_.tracer_.objectOf(point).receivesShadow;
    if (!receives) contours_.clear();
    AreaIrradiance answer;
    if (outline_.size() < 3) return {receives ? 0.0 : 1.0, 0.0, 0.0};
    const Contour horizon{seen_.product(normalWorld)}; // of the normal
    std::vector<dvec2> aboveHorizon = outline_;
    keepPart(aboveHorizon, horizon.line);
    if (aboveHorizon.size() >= 3) answer.unshadowed = irradianceOf(LightPiece(seen_, aboveHorizon), normalWorld);
    if (!receives) return {1.0, answer.unshadowed, answer.unshadowed};
    if (contours_.empty() && obstacles_->perforated.empty()) { // either all within the borders is seen, or nothing
        for (const dvec3& border : borders_) keepPart(outline_, border);
        const LightPiece whole(seen_, outline_);
        if (!(whole.area() > 0) || !isFree(whole.middle())) return {0.0, 0.0, answer.unshadowed};
        answer.visible = std::clamp(whole.area() / seen_.area, 0.0, 1.0);
        answer.irradiance = answer.unshadowed;
        if (borders_.empty()) return answer;
        aboveHorizon = outline_;
        keepPart(aboveHorizon, horizon.line);
        const double irradiance = aboveHorizon == outline_ ? irradianceOf(whole, normalWorld) : irradianceOf(LightPiece(seen_, aboveHorizon), normalWorld);
        answer.irradiance = std::min(irradiance, answer.unshadowed);
        return answer;
    }
    contours_.push_back(horizon); // each piece is above it or below
    pieces_.cut(outline_, borders_, contours_, [&](std::span<const dvec2> polygon) {
        const LightPiece piece(seen_, polygon);
        if (!(piece.area() > 0)) return;
        const Seen seen = seenOf(piece, polygon, normalWorld);
        answer.visible += piece.area() * seen.area;
        if (seen.irradiance > 0 && glm::dot(normalWorld, seen_.toward(piece.middle())) > 0)
            answer.irradiance += irradianceOf(piece, normalWorld) * seen.irradiance;
    });
    answer.visible = std::clamp(answer.visible / seen_.area, 0.0, 1.0);
    answer.irradiance = std::min(answer.irradiance, answer.unshadowed); // it is not more but by rounding
    return answer;
}

/// Of a piece that is seen wholly, above the normal's horizon; in the units of AreaIrradiance.
double AreaVisibility::Asker::irradianceOf(const LightPiece& piece, const dvec3& normalWorld) const {
    // By rounding a piece of next to nothing may seem to have less than that.
    return std::max(glm::dot(normalWorld, piece.vectorIrradiance()), 0.0) / glm::pi<double>();
}

/// Finds what of the light is above the point's triangle, and the contours before it. False for points within a sphere.
bool AreaVisibility::Asker::lookFrom(const SurfacePoint& point, double move) {
    point_ = point;
    positionCentred_ = owner_.tracer_.positionCentred(point);
    move_ = move;
    change_ = 0;
    contours_.clear();
    chords_.clear();
    borders_.clear();
    outline_.clear();
    const dvec3 toLight = owner_.centreCentred_ - positionCentred_;
    const std::optional<SeenLight> seen = seenLight(owner_.light_, toLight);
    if (!seen) return false;
    seen_ = *seen;

    dvec3 up = frontOf(bvh_.triangles[point.primitive]);
    if (!point.eyeOnFront) up = -up;
    const dvec3 elevation = seen_.product(up);
    outline_.assign(seen_.outline.begin(), seen_.outline.end());
    if (elevation.z < seen_.range(elevation)) {
        keepPart(outline_, elevation);
        // A rect stays where it is, and the plane, too. A disc turns with the point, by less than it moves over its distance;
        // a chord is at most 2/pi of the area times the radius, so four makes more than twice of it.
        if (seen_.isDisc) change_ += 4 * move_ / glm::length(toLight);
    }
    if (outline_.size() < 3) return true; // all of it is below
    addLines();
    addCrossings();
    mindCuts();
    if (move_ > 0) mindWhatIsNear(up);
    return true;
}

int AreaVisibility::Asker::turnAt(const SurfaceEdges::Edge& edge) const {
    int turn = 0;
    for (const SurfaceEdges::Use& use : owner_.edges_.uses(edge)) {
        if (!owner_.casts_[use.primitive] || isLeft(use.primitive)) continue;
        const double height = heightOver(bvh_.triangles[use.primitive]);
        turn += height > 0 ? use.direction : height < 0 ? -use.direction : 0;
    }
    return turn;
}

/// How far the point is above a triangle's plane, times twice the triangle's area.
double AreaVisibility::Asker::heightOver(const Triangle& triangle) const {
    return glm::dot(frontOf(triangle), positionCentred_ - triangle.a);
}

/// Adds what of edges is seen before the light, and finds the chords of cuts that are.
void AreaVisibility::Asker::addLines() {
    const LightPlane plane(seen_);
    for (const std::uint32_t number : obstacles_->edges) {
        const SurfaceEdges::Edge& edge = owner_.edges_.edge(number);
        if (comesBefore(plane, edge.firstCentred, edge.secondCentred, [&] { return turnAt(edge) != 0; }))
            addContour(edge.firstCentred, edge.secondCentred);
    }
    for (const std::uint32_t number : obstacles_->cuts) {
        const SphereCut& cut = owner_.cuts_.chords()[number];
        if (comesBefore(plane, cut.firstCentred, cut.secondCentred, [&] { return !isLeft(cut.primitive); }))
            chords_.push_back(number);
    }
}

/// Whether a part of the line from one place to the other is seen before the light, or not far beside it, and is a contour.
template <typename IsContour>
bool AreaVisibility::Asker::comesBefore(const LightPlane& plane, const dvec3& firstCentred, const dvec3& secondCentred, const IsContour& isContour) {
    const dvec3 first = firstCentred - positionCentred_, second = secondCentred - positionCentred_;
    const dvec2 half = (1 + kMargin) * seen_.half;
    const double atFirst = glm::dot(plane.depth, first), atSecond = glm::dot(plane.depth, second);
    Part part;
    part.keep(1 - atFirst, 1 - atSecond);
    const dvec2 u(glm::dot(plane.placeU, first) - atFirst * plane.middle.x, glm::dot(plane.placeU, second) - atSecond * plane.middle.x);
    const dvec2 v(glm::dot(plane.placeV, first) - atFirst * plane.middle.y, glm::dot(plane.placeV, second) - atSecond * plane.middle.y);
    part.keep(half.x * atFirst - u.x, half.x * atSecond - u.y);
    part.keep(half.x * atFirst + u.x, half.x * atSecond + u.y);
    part.keep(half.y * atFirst - v.x, half.y * atSecond - v.y);
    part.keep(half.y * atFirst + v.x, half.y * atSecond + v.y);
    if (part.begin > part.end || !isContour()) return false;
    if (!(move_ > 0)) return true;
    // What stands at a share t of the way moves by (1 - t) / t on the light's plane, against the point, and more where that
    // is seen aslant; the disc of a sphere itself moves by less than the point. To first order a contour sweeps its length
    // times its way; twice that is well beyond.
    const double atBegin = glm::mix(atFirst, atSecond, part.begin), atEnd = glm::mix(atFirst, atSecond, part.end);
    const double nearest = std::min(atBegin, atEnd);
    const double length = glm::length(glm::mix(first, second, part.begin) / atBegin - glm::mix(first, second, part.end) / atEnd);
    const double swept = std::min(length, seen_.diameter()) * move_ * farthestOnLight() * glm::length(plane.depth) * (1 / nearest);
    change_ += nearest > 0 ? 2 * swept / (seen_.area * plane.unitArea) : 1;
    return true;
}

void AreaVisibility::Asker::addContour(const dvec3& firstCentred, const dvec3& secondCentred) {
    const dvec3 first = firstCentred - positionCentred_, second = secondCentred - positionCentred_, normal = glm::cross(first, second);
    contours_.push_back({seen_.product(normal), seen_.product(glm::cross(normal, first)), seen_.product(glm::cross(second, normal))});
}

/// Where chords of cuts bound one convex part of the sphere, they are borders of what is seen; else they are contours.
void AreaVisibility::Asker::mindCuts() {
    const bool areBorders = obstacles_->perforated.empty() && owner_.cuts_.boundOneConvexPart(chords_, positionCentred_);
    for (const std::uint32_t number : chords_)
        if (!areBorders)
            addContour(owner_.cuts_.chords()[number].firstCentred, owner_.cuts_.chords()[number].secondCentred);
        else if (const dvec3 inward = owner_.cuts_.inward(number, positionCentred_); inward != dvec3(0.0))
            borders_.push_back(seen_.product(inward));
}

/// Handles triangles so near that they might come before the light from outside of the margin in which contours are
/// counted.
void AreaVisibility::Asker::mindWhatIsNear(const dvec3& up) {
    // So close to a sphere its disc is smaller than the margin takes it to be.
    if (owner_.light_.type == scene::LightType::sphere && glm::length(seen_.axisU) < kLeastDisc * owner_.light_.radius)
        change_ = 1;
    CentredBox around;
    around.include(positionCentred_);
    around.grow(owner_.nearness(move_, farthestOnLight()));
    for (const std::uint32_t primitive : obstacles_->near) {
        const Triangle& triangle = bvh_.triangles[primitive];
        if (isLeft(primitive) || !boxOf(triangle).touches(around)) continue;
        const double level = glm::dot(up, positionCentred_);
        const double rounding = kInPlane * glm::length(up) * farthestOnLight();
        const bool below = glm::dot(up, triangle.a) <= level + rounding &&
                           glm::dot(up, triangle.b) <= level + rounding && glm::dot(up, triangle.c) <= level + rounding;
        if (!below) change_ = 1;
    }
}

double AreaVisibility::Asker::farthestOnLight() const { return glm::length(seen_.middle) + 0.5 * seen_.diameter(); }

/// A triangle that the light's plane, or the contact at the point, cuts ends there too. (At a sphere it ends where it cuts that.)
void AreaVisibility::Asker::addCrossings() {
    for (const std::uint32_t primitive : obstacles_->near) {
        if (isLeft(primitive)) continue;
        const Triangle& triangle = bvh_.triangles[primitive];
        const double height = -heightOver(triangle);
        const dvec3 depth = seen_.product(height < 0 ? -frontOf(triangle) : frontOf(triangle));
        for (const double end : {kContact, 1 - kContact}) {
            if (seen_.isDisc && end > kContact) continue;
            // The triangle is met at |height| / depth of the way.
            const dvec3 line = depth - dvec3(0, 0, std::abs(height) / end);
            if (std::abs(line.z) > seen_.range(line)) continue;
            contours_.push_back({line});
            if (move_ > 0) change_ = 1; // whatever there may be
        }
    }
}

AreaVisibility::Asker::Seen AreaVisibility::Asker::seenOf(const LightPiece& piece, std::span<const dvec2> polygon,
                                                          const dvec3& normalWorld) {
    const dvec2 middle = piece.middle();
    if (!isFree(middle)) return {0, 0};
    return obstacles_->perforated.empty() || isFreeOf(true, middle) ? Seen{1, 1}
                                                                    : sampledSeenOf(piece, polygon, normalWorld);
}

/// True if no triangle without holes covers that place of the light.
bool AreaVisibility::Asker::isFree(dvec2 place) {
    if (obstacles_->count() > 0) return isFreeOf(false, place);
    // Where there is no contour, no way to the light differs from any other.
    if (!allFree_) allFree_ = isFreeOf(false, place);
    return *allFree_;
}

/// True if no triangle covers that place of the light. `perforated`: tests only triangles with holes, as if they were
/// solid; else only those without.
bool AreaVisibility::Asker::isFreeOf(bool perforated, dvec2 place) {
    const Ray ray{positionCentred_, seen_.toward(place), kContact, (1 - kContact) * seen_.reach(place)};
    if (!isUsable(ray)) return true;
    const auto accept = [&](std::uint32_t primitive) {
        return owner_.casts_[primitive] && !isLeft(primitive) &&
               (obstacles_->perforated.empty() || owner_.tracer_.mayHaveHoles(primitive) == perforated);
    };
    // The triangle that covered the last piece often covers this one, so it is tested first.
    if (lastBlocker_ != kNoPrimitive && accept(lastBlocker_)) {
        const ShearedRay sheared(ray);
        const auto hit = intersect(sheared, bvh_.triangles[lastBlocker_], sheared.farthest);
        if (hit && hit->reach < sheared.farthest) return false;
    }
    const std::uint32_t blocker = bvh_.any(ray, accept);
    if (blocker != kNoPrimitive) lastBlocker_ = blocker;
    return blocker == kNoPrimitive;
}

/// Traces rays through the holes to places spread evenly over the polygon (of a disc, to those within it), by a
/// low-discrepancy sequence (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
AreaVisibility::Asker::Seen AreaVisibility::Asker::sampledSeenOf(const LightPiece& piece,
                                                                 std::span<const dvec2> polygon,
                                                                 const dvec3& normalWorld) {
    constexpr double kRoot = 1.3247179572447460260; // of x^3 = x + 1
    const double area = areaOf(polygon);
    const int count = static_cast<int>(std::ceil(kSamples * area / seen_.area));
    const auto goesOn = [&](std::uint32_t primitive, const dvec3& barycentric) {
        return owner_.tracer_.mayHaveHoles(primitive) &&
               owner_.tracer_.isInHole({primitive, false, dvec2(barycentric)});
    };
    const auto accept = [&](std::uint32_t primitive) { return owner_.casts_[primitive] && !isLeft(primitive); };
    const dvec3 lightNormal = glm::cross(seen_.axisU, seen_.axisV);
    double free = 0, all = 0, freeIrradiance = 0, allIrradiance = 0;
    const auto look = [&](dvec2 place) {
        const dvec3 toward = seen_.toward(place);
        const Ray ray{positionCentred_, toward, kContact, (1 - kContact) * seen_.reach(place)};
        const double seen = bvh_.any(ray, accept, goesOn) == kNoPrimitive ? 1 : 0;
        // What a place adds to the irradiance goes with both cosines over the square of its distance.
        const double squared = glm::dot(toward, toward);
        const double weight =
            std::abs(glm::dot(normalWorld, toward) * glm::dot(lightNormal, toward)) / (squared * squared);
        free += seen, all += 1;
        freeIrradiance += weight * seen, allIrradiance += weight;
    };
    for (int i = 0; i < count; ++i) {
        double along = glm::fract((i + 0.5) / kRoot), across = std::sqrt(glm::fract((i + 0.5) / (kRoot * kRoot)));
        // The triangle of the polygon's fan in which that share of the area ends, and in it a place by square root.
        std::size_t corner = 2;
        double left = along * area, part = areaOf(std::array{polygon[0], polygon[1], polygon[2]});
        while (left > part && corner + 1 < polygon.size()) {
            left -= part;
            ++corner;
            part = areaOf(std::array{polygon[0], polygon[corner - 1], polygon[corner]});
        }
        along = part > 0 ? std::min(left / part, 1.0) : 0.5;
        const dvec2 side = glm::mix(polygon[corner - 1], polygon[corner], along);
        const dvec2 place = glm::mix(polygon[0], side, across);
        if (!seen_.isDisc || glm::dot(place, place) <= 1) look(place);
    }
    if (all == 0) look(piece.middle()); // too small a part of the disc to contain a sample
    return {free / all, allIrradiance > 0 ? freeIrradiance / allIrradiance : free / all};
}

} // namespace shadowlab::trace
