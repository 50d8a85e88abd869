// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/judge/exact_visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/shading.h"

namespace shadowlab::trace {

namespace {

// Triangles per box: enough to skip most of a mesh with one test, few enough that a box stays tight.
constexpr std::uint32_t kRunLength = 32;

// A crossing nearer than this share of the distance to the light is contact, not a crossing: the hit point itself is
// only known to about 2^-50 of the coordinates, and coplanar neighbours would otherwise shadow each other by rounding.
constexpr double kTouching = 1e-10;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct RayTriangle {
    double distance;
    dvec3 barycentric;
};

/// Distance along the ray and weights of the corners, or nothing. Signed volumes relative to the ray's origin: for an
/// edge that two triangles share both compute the same number with opposite sign, so no ray slips between them.
std::optional<RayTriangle> intersect(const dvec3& origin, const dvec3& direction, const dvec3& cornerA,
                                     const dvec3& cornerB, const dvec3& cornerC) {
    const dvec3 a = cornerA - origin, b = cornerB - origin, c = cornerC - origin;
    const double u = glm::dot(direction, glm::cross(c, b));
    const double v = glm::dot(direction, glm::cross(a, c));
    const double w = glm::dot(direction, glm::cross(b, a));
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const double determinant = u + v + w;
    if (determinant == 0) return std::nullopt; // seen exactly edge-on
    const dvec3 normal = glm::cross(b - a, c - a);
    return RayTriangle{glm::dot(normal, a) / glm::dot(normal, direction), dvec3(u, v, w) / determinant};
}

/// Does the ray touch the box before `length`? The box is widened by rounding, so a miss is certain.
bool touches(const scene::Bounds& bounds, const dvec3& origin, const dvec3& direction, double length) {
    double enter = 0, leave = length;
    for (int axis = 0; axis < 3; ++axis) {
        const double margin =
            1e-12 * (std::abs(origin[axis]) + std::abs(bounds.lowerWorld[axis]) + std::abs(bounds.upperWorld[axis]));
        const double lower = bounds.lowerWorld[axis] - margin - origin[axis];
        const double upper = bounds.upperWorld[axis] + margin - origin[axis];
        if (direction[axis] == 0) {
            if (lower > 0 || upper < 0) return false;
            continue;
        }
        double t0 = lower / direction[axis], t1 = upper / direction[axis];
        if (t0 > t1) std::swap(t0, t1);
        enter = std::max(enter, t0 * (t0 > 0 ? 1 - 1e-12 : 1 + 1e-12));
        leave = std::min(leave, t1 * (t1 > 0 ? 1 + 1e-12 : 1 - 1e-12));
        if (enter > leave) return false;
    }
    return true;
}

} // namespace

ExactVisibility::ExactVisibility(scene::Snapshot snapshot) : snapshot_(std::move(snapshot)) {
    for (std::uint32_t o = 0; o < snapshot_->objects.size(); ++o) {
        const scene::Object& object = snapshot_->objects[o];
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        hasHoles_.push_back(scene::hasHoles(*snapshot_, object));
        firstTriangle_.push_back(static_cast<std::uint32_t>(triangles_.size()));
        const auto corner = [&](std::uint32_t vertex) {
            return transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[vertex]));
        };
        for (const uvec3& t : object.mesh->triangles) {
            const auto within = static_cast<std::uint32_t>(triangles_.size()) - firstTriangle_.back();
            if (within % kRunLength == 0) runs_.push_back({o, within, 0, {}});
            triangles_.push_back({corner(t.x), corner(t.y), corner(t.z)});
            ++runs_.back().count;
            for (const dvec3& p : {triangles_.back().a, triangles_.back().b, triangles_.back().c})
                runs_.back().bounds.include(p);
        }
    }
    for (const scene::Light& light : snapshot_->lights)
        facing_.push_back(scene::facingSigns(*snapshot_, light));
    coincident_ = scene::CoincidentFaces(*snapshot_);
}

template <typename OnHit>
void ExactVisibility::forEachHit(const dvec3& originWorld, const dvec3& directionWorld, double length,
                                 const OnHit& onHit) const {
    for (const Run& run : runs_) {
        if (!touches(run.bounds, originWorld, directionWorld, length)) continue;
        for (std::uint32_t t = run.first; t < run.first + run.count; ++t) {
            const Triangle& triangle = triangles_[firstTriangle_[run.object] + t];
            if (const auto hit = intersect(originWorld, directionWorld, triangle.a, triangle.b, triangle.c))
                if (onHit(run.object, t, *hit)) return;
        }
    }
}

std::optional<EyeHit> ExactVisibility::eyeHit(const scene::Camera& camera, dvec2 pixel, ivec2 size) const {
    const dvec3 direction = scene::rayDirectionWorld(camera, pixel, size);
    const dvec3 forward = glm::normalize(camera.targetWorld - camera.positionWorld);
    const double nearest = camera.near / glm::dot(direction, forward);
    std::optional<EyeHit> best;
    std::vector<EyeHit> coincident;
    forEachHit(camera.positionWorld, direction, kInfinity,
               [&](std::uint32_t object, std::uint32_t triangle, const RayTriangle& hit) {
                   if (!(hit.distance > nearest) || passes(object, triangle, hit.barycentric)) return false;
                   const EyeHit found{object, triangle, hit.distance, {}, {}, hit.barycentric};
                   if (!best || hit.distance < best->distance) best = found;
                   if (coincident_.touches(firstTriangle_[object] + triangle)) coincident.push_back(found);
                   return false;
               });
    if (!best) return std::nullopt;
    if (coincident_.touches(firstTriangle_[best->object] + best->triangle)) best = seenAmong(*best, coincident, direction);
    const Triangle& t = triangles_[firstTriangle_[best->object] + best->triangle];
    best->positionWorld = camera.positionWorld + best->distance * direction;
    best->geometricNormalWorld = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
    if (glm::dot(best->geometricNormalWorld, direction) > 0) best->geometricNormalWorld *= -1.0;
    return best;
}

EyeHit ExactVisibility::seenAmong(const EyeHit& nearest, std::span<const EyeHit> coincident, const dvec3& direction) const {
    const auto numberOf = [&](const EyeHit& hit) { return firstTriangle_[hit.object] + hit.triangle; };
    const auto rankOf = [&](const EyeHit& hit) {
        const Triangle& t = triangles_[numberOf(hit)];
        const bool isFront = (glm::dot(glm::cross(t.b - t.a, t.c - t.a), direction) < 0) != scene::isMirrored(snapshot_->objects[hit.object]);
        return coincident_.rank(numberOf(hit), isFront);
    };
    EyeHit seen = nearest;
    for (const EyeHit& hit : coincident)
        if (coincident_.areTogether(numberOf(nearest), numberOf(hit)) && rankOf(seen) < rankOf(hit)) seen = hit;
    return seen;
}

Visibility ExactVisibility::visibility(const EyeHit& hit, const scene::Camera& camera, int light) const {
    const scene::Light& source = snapshot_->light(light);
    const scene::Object& object = snapshot_->objects[hit.object];
    const std::uint32_t index = firstTriangle_[hit.object] + hit.triangle;
    const Triangle& t = triangles_[index];

    // The facing gate: eye and light on one side of the triangle. The stored sign counts in mesh space, where a
    // mirrored object's winding is the other way round.
    const bool mirrored = scene::isMirrored(object);
    const double eyeSide = glm::dot(glm::cross(t.b - t.a, t.c - t.a), camera.positionWorld - t.a) * (mirrored ? -1 : 1);
    const int lightSide = facing_[static_cast<std::size_t>(light)][index];
    if (eyeSide > 0 ? lightSide <= 0 : lightSide >= 0) return Visibility::turnedAway;
    if (!scene::lightShinesTo(source, hit.positionWorld)) return Visibility::turnedAway;

    if (!object.receivesShadow) return Visibility::lit;
    bool blocked = false;
    forEachBlocker(hit, light, [&](std::uint32_t blocker, std::uint32_t triangle, const dvec3& barycentric) {
        return blocked = !passes(blocker, triangle, barycentric);
    });
    return blocked ? Visibility::shadowed : Visibility::lit;
}

/// True if this point of a triangle lies in a hole, so that the ray goes on.
bool ExactVisibility::passes(std::uint32_t object, std::uint32_t triangle, const dvec3& barycentric) const {
    return hasHoles_[object] && scene::isInHole(*snapshot_, snapshot_->objects[object], triangle, barycentric);
}

Visibility ExactVisibility::at(const scene::Camera& camera, dvec2 pixel, ivec2 size, int light) const {
    const std::optional<EyeHit> hit = eyeHit(camera, pixel, size);
    return hit ? visibility(*hit, camera, light) : Visibility::noSurface;
}

int ExactVisibility::crossings(const EyeHit& hit, int light) const {
    int count = 0;
    forEachBlocker(hit, light, [&](std::uint32_t, std::uint32_t, const dvec3&) {
        ++count;
        return false;
    });
    return count;
}

template <typename OnBlocker>
void ExactVisibility::forEachBlocker(const EyeHit& hit, int light, const OnBlocker& onBlocker) const {
    const scene::Light& source = snapshot_->light(light);
    const std::vector<std::int8_t>& facing = facing_[static_cast<std::size_t>(light)];
    const bool directional = source.type == scene::LightType::directional;
    const dvec3 offset = source.positionWorld - hit.positionWorld;
    const dvec3 toward = directional ? -source.directionWorld : glm::normalize(offset);
    const double length = directional ? kInfinity : glm::length(offset);
    // A directional light has no distance; the size of the coordinates is used instead.
    const double contact = kTouching * (directional ? 1e-2 * (1.0 + glm::length(hit.positionWorld)) : length);
    forEachHit(hit.positionWorld, toward, length,
               [&](std::uint32_t object, std::uint32_t triangle, const RayTriangle& crossing) {
                   // What lies in the triangle's own plane, but for rounding, does not stand in the light's way either.
                   const std::uint32_t own = firstTriangle_[hit.object] + hit.triangle, other = firstTriangle_[object] + triangle;
                   const bool itself = other == own || coincident_.areTogether(own, other);
                   // A triangle whose plane holds the light is only ever touched, at the light itself, never crossed.
                   const bool edgeOn = facing[other] == 0;
                   const bool between = crossing.distance > contact && crossing.distance < length;
                   return !itself && !edgeOn && between && snapshot_->objects[object].castsShadow &&
                          onBlocker(object, triangle, crossing.barycentric);
               });
}

} // namespace shadowlab::trace
