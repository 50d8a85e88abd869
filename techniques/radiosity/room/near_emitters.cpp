// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/near_emitters.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::radiosity {

namespace {

// Diagonals of pieces are no longer than so many times their distance from the emitter, but may be a quarter of its size: where it is closer than that, it
// covers what it lights, and outlines are cut (contacts.h).
constexpr double kOfDistance = 2, kOfSize = 0.25;

// A lamp is a small part of a room. Where more than this share of all surfaces glows, everything is close to what glows.
constexpr double kMostOfRoom = 0.1;

/// Diagonals of pieces at that place, metres.
double longestNear(const trace::CentredBox& emitter, const Polygon& piece) {
    return std::max(kOfDistance * distanceBetween(boxOf(piece), emitter), kOfSize * glm::distance(emitter.lower, emitter.upper));
}

} // namespace

bool isInGap(const Patch& patch, const trace::CentredBox& body, std::span<const Plane> fronts, double reach) {
    if (distanceBetween(boxOf(patch.polygon), body) >= std::max(reach, sizeOf(patch.polygon))) return false;
    const double touches = kTouching * sizeOf(patch.polygon);
    const auto isShoneAt = [&](const dvec3& place) { return std::ranges::any_of(fronts, [&](const Plane& front) { return front.height(place) > touches; }); };
    if (!fronts.empty() && std::ranges::none_of(patch.polygon.corners(), isShoneAt)) return false;
    const dvec3 farthest = glm::mix(body.lower, body.upper, glm::step(0.0, patch.normal)); // along the normal
    return patch.plane().height(farthest) > touches;
}

NearEmitters::NearEmitters(const trace::SceneTracer& tracer, const Sides& sides) : tracer_(tracer), sides_(sides) {
    double glowing = 0, all = 0; // m^2, of the sides that exchange light: a loose one, such as the underside of a ground, may be very large
    for (std::size_t f = 0; f < sides.exchanging; ++f) {
        const Face& face = sides.faces.all[f];
        const double area = glm::length(areaVector(face.polygon));
        all += area;
        if (!face.shines || luminance(dvec3(tracer.scene().materials[face.material].emission)) <= 0) continue;
        glowing += area;
        auto own = std::ranges::find(emitters_, face.object, &Emitter::object);
        if (own == emitters_.end()) own = emitters_.insert(own, Emitter{face.object, {}, {}});
        own->box = around(own->box, boxOf(face.polygon));
        own->planes.push_back(face.plane);
    }
    if (glowing > kMostOfRoom * all) emitters_.clear();
}

std::optional<FaceParts> NearEmitters::divided(const FaceParts& parts, double scale, std::size_t most) const {
    FaceParts divided(emitters_.empty() ? 0 : sides_.exchanging);
    std::size_t added = 0;
    for (std::uint32_t f = 0; f < divided.size() && added <= most; ++f) {
        const Face& face = sides_.faces.all[f];
        const std::vector<FacePart> whole{{face.polygon, 0}};
        const std::vector<FacePart>& before = f < parts.size() && !parts[f].empty() ? parts[f] : whole;
        for (const FacePart& part : before)
            divide(pieceOf(wholePatch(face, f), part.polygon), scale, part.doublings, divided[f]);
        added += divided[f].size() - before.size();
    }
    if (added == 0 || added > most) return std::nullopt;
    return divided;
}

void NearEmitters::divide(const Patch& piece, double scale, int doublings, std::vector<FacePart>& parts) const {
    const bool isTooLong = std::ranges::any_of(emitters_, [&](const Emitter& emitter) {
        const double longest = std::ldexp(scale * longestNear(emitter.box, piece.polygon), doublings); // twice as long where all patches are
        return emitter.object != objectOf(piece) && sizeOf(piece.polygon) > longest && sees(piece, emitter);
    });
    const std::vector<Polygon> polygons = isTooLong ? dividedPatch(piece) : std::vector{piece.polygon};
    if (polygons.size() == 1) {
        parts.push_back({piece.polygon, doublings});
        return;
    }
    for (const Polygon& polygon : polygons)
        divide(pieceOf(piece, polygon), scale, doublings, parts);
}

std::vector<std::uint8_t> NearEmitters::followed(std::span<const Patch> patches, const IsSimplified& isSimplified) const {
    std::vector<std::uint8_t> followed(patches.size(), 0);
    std::vector<std::uint32_t> objects; // of emitters that are followed
    for (const Emitter& emitter : emitters_) {
        bool isFollowed = isSimplified(emitter.object);
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const Patch& patch = patches[i];
            if (objectOf(patch) == emitter.object || !isInGap(patch, emitter.box, emitter.planes)) continue;
            isFollowed = true;
            followed[i] = 1;
        }
        if (isFollowed) objects.push_back(emitter.object);
    }
    for (std::size_t i = 0; i < patches.size(); ++i)
        if (std::ranges::find(objects, objectOf(patches[i])) != objects.end()) followed[i] = 1;
    return followed;
}

/// From its middle or from near one of its corners.
bool NearEmitters::sees(const Patch& piece, const Emitter& emitter) const {
    constexpr double kInward = 0.1;
    const dvec3 middle = 0.5 * (emitter.box.lower + emitter.box.upper);
    const auto seesFrom = [&](const dvec3& place) {
        const dvec3 from = place + 2 * kTouching * sizeOf(piece.polygon) * piece.normal, toward = middle - from;
        const bool isShoneAt = std::ranges::any_of(emitter.planes, [&](const Plane& plane) { return plane.height(from) > 0; });
        if (!isShoneAt || glm::dot(toward, piece.normal) <= 0) return false;
        const trace::SurfacePoint met = tracer_.nextPoint(from, trace::kNoPrimitive, glm::normalize(toward));
        return met && tracer_.world().objects[met.primitive] == emitter.object;
    };
    return seesFrom(piece.centre) ||
           std::ranges::any_of(piece.polygon.corners(), [&](const dvec3& corner) { return seesFrom(glm::mix(corner, piece.centre, kInward)); });
}

} // namespace shadowlab::radiosity
