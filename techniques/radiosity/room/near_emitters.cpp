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

/// What shines of an object.
struct Emitter {
    std::uint32_t object = 0;
    trace::CentredBox box;
    std::vector<Plane> planes; ///< of its faces
    [[nodiscard]] dvec3 centre() const { return 0.5 * (box.lower + box.upper); }
    [[nodiscard]] bool shinesAt(const dvec3& place) const {
        return std::ranges::any_of(planes, [&](const Plane& plane) { return plane.height(place) > 0; });
    }
};

/// None where much of the scene glows.
std::vector<Emitter> emittersOf(const scene::Scene& scene, const Sides& sides) {
    std::vector<Emitter> emitters; // in the order of their objects, as faces are
    double glowing = 0, all = 0;   // m^2, of the sides that exchange light: a loose one, such as the underside of a ground, may be very large
    for (std::size_t f = 0; f < sides.exchanging; ++f) {
        const Face& face = sides.faces.all[f];
        const double area = glm::length(areaVector(face.polygon));
        all += area;
        if (!face.shines || luminance(dvec3(scene.materials[face.material].emission)) <= 0) continue;
        glowing += area;
        auto own = std::ranges::find(emitters, face.object, &Emitter::object);
        if (own == emitters.end()) own = emitters.insert(own, Emitter{face.object, {}, {}});
        const trace::CentredBox box = boxOf(face.polygon);
        own->box.include(box.lower);
        own->box.include(box.upper);
        own->planes.push_back(face.plane);
    }
    if (glowing > kMostOfRoom * all) emitters.clear();
    return emitters;
}

class NearDivider {
public:
    NearDivider(const trace::SceneTracer& tracer, const std::vector<Emitter>& emitters, double scale) : tracer_(tracer), emitters_(emitters), scale_(scale) {}

    void divide(const Patch& piece, std::uint32_t object, int doublings, std::vector<FacePart>& parts) const {
        const bool isTooLong = std::ranges::any_of(emitters_, [&](const Emitter& emitter) {
            const double longest = std::ldexp(longestNear(emitter, piece), doublings); // twice as long where all patches are
            return emitter.object != object && sizeOf(piece.polygon) > longest && sees(piece, emitter);
        });
        const std::vector<Polygon> polygons = isTooLong ? dividedPatch(piece) : std::vector{piece.polygon};
        if (polygons.size() == 1) {
            parts.push_back({piece.polygon, doublings});
            return;
        }
        for (const Polygon& polygon : polygons)
            divide(pieceOf(piece, polygon), object, doublings, parts);
    }

private:
    [[nodiscard]] double longestNear(const Emitter& emitter, const Patch& piece) const {
        const trace::CentredBox box = boxOf(piece.polygon);
        const dvec3 gap = glm::max(dvec3(0), glm::max(box.lower - emitter.box.upper, emitter.box.lower - box.upper));
        return scale_ * std::max(kOfDistance * glm::length(gap), kOfSize * glm::distance(emitter.box.lower, emitter.box.upper));
    }

    /// From its middle or from near one of its corners.
    [[nodiscard]] bool sees(const Patch& piece, const Emitter& emitter) const {
        constexpr double kInward = 0.1;
        const auto seesFrom = [&](const dvec3& place) {
            const dvec3 from = place + 2 * kTouching * sizeOf(piece.polygon) * piece.normal, toward = emitter.centre() - from;
            if (!emitter.shinesAt(from) || glm::dot(toward, piece.normal) <= 0) return false;
            const trace::SurfacePoint met = tracer_.nextPoint(from, trace::kNoPrimitive, glm::normalize(toward));
            return met && tracer_.world().objects[met.primitive] == emitter.object;
        };
        return seesFrom(piece.centre) || std::ranges::any_of(piece.polygon.corners(), [&](const dvec3& corner) {
                   return seesFrom(glm::mix(corner, piece.centre, kInward));
               });
    }

    const trace::SceneTracer& tracer_;
    const std::vector<Emitter>& emitters_;
    double scale_;
};

} // namespace

std::optional<FaceParts> dividedNearEmitters(const FaceParts& parts, const trace::SceneTracer& tracer, const Sides& sides, double scale, std::size_t most) {
    const std::vector<Emitter> emitters = emittersOf(tracer.scene(), sides);
    const NearDivider divider(tracer, emitters, scale);
    FaceParts divided(emitters.empty() ? 0 : sides.exchanging);
    std::size_t added = 0;
    for (std::uint32_t f = 0; f < divided.size() && added <= most; ++f) {
        const Face& face = sides.faces.all[f];
        const std::vector<FacePart> whole{{face.polygon, 0}};
        const std::vector<FacePart>& before = f < parts.size() && !parts[f].empty() ? parts[f] : whole;
        for (const FacePart& part : before)
            divider.divide(pieceOf(wholePatch(face, f), part.polygon), face.object, part.doublings, divided[f]);
        added += divided[f].size() - before.size();
    }
    if (added == 0 || added > most) return std::nullopt;
    return divided;
}

} // namespace shadowlab::radiosity
