// SPDX-License-Identifier: MIT
#include "app/picture/outside/pixel_shapes.h"

#include <array>
#include <cmath>

#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {

namespace {

// Of half the picture's height: arrows are read from the last row, and do not hide what they stand on.
constexpr double kArrowShare = 0.4;
constexpr double kLeastNamed = 0.26;  ///< likewise of a ray that has its name beside it
constexpr double kHeadShare = 0.16;   ///< of an arrow's length
constexpr std::size_t kNamedRays = 8; ///< more names would cover one another
constexpr double kOnRay = 0.6;        ///< length of the arrows on the ray itself, in those of the others

struct ShapeKind {
    const char* label;
    vec3 color;
};
/// In the order of Probe::Role.
const std::array<ShapeKind, 5>& kinds() {
    static const std::array<ShapeKind, 5> all = {{{"the pixel's ray", look::kEyeRay},
                                                  {"reflection rays", look::kReflectionRay},
                                                  {"refraction rays", look::kRefractionRay},
                                                  {"shadow ray: lit", look::kEqualDepth},
                                                  {"shadow ray: blocked", look::kOccluded}}};
    return all;
}

/// How large a share of half the picture's height is at a place.
struct Facing {
    explicit Facing(const scene::Camera& outside)
        : camera(outside), forward(glm::normalize(outside.targetWorld - outside.positionWorld)) {}
    [[nodiscard]] double metres(const dvec3& placeWorld, double share) const {
        return share * std::tan(glm::radians(camera.fovYDegrees / 2)) *
               std::abs(glm::dot(placeWorld - camera.positionWorld, forward));
    }
    const scene::Camera& camera;
    dvec3 forward;
};

/// The head lies in the picture's plane, as far as the arrow itself does.
void addArrow(std::vector<dvec3>& points, const Facing& facing, const dvec3& fromWorld, const dvec3& byWorld) {
    const dvec3 tip = fromWorld + byWorld;
    points.insert(points.end(), {fromWorld, tip});
    dvec3 across = glm::cross(byWorld, tip - facing.camera.positionWorld);
    if (glm::length(across) == 0) return; // seen from its end, it is a point
    across = glm::normalize(across) * glm::length(byWorld);
    for (const double side : {-1.0, 1.0})
        points.insert(points.end(), {tip, tip - kHeadShare * byWorld + side * 0.5 * kHeadShare * across});
}

Probe::Role roleOf(const Probe::Vector& vector) {
    return vector.label == "R" ? Probe::Role::reflection : vector.label == "T" ? Probe::Role::refraction : Probe::Role::eye;
}

/// u and V lie on the eye's ray.
bool isOnRay(const Probe::Vector& vector) { return vector.label == "u" || vector.label == "V"; }

struct Arrow {
    dvec3 fromWorld{0.0}, byWorld{0.0};
};
/// u is farther out, on its way in, than V.
Arrow arrowOf(const Probe& probe, const Facing& facing, const Probe::Vector& vector) {
    const dvec3 atWorld = probe.geometry.front().toWorld;
    const dvec3 by = (isOnRay(vector) ? kOnRay : 1.0) * facing.metres(atWorld, kArrowShare) * vector.directionWorld;
    return {vector.label == "u" ? atWorld - 2.5 * by : atWorld, by};
}

} // namespace

std::vector<SceneShape> pixelShapes(const Probe& probe, const scene::Camera& outside) {
    std::vector<SceneShape> shapes = probe.visited;
    const std::size_t first = shapes.size();
    for (const ShapeKind& kind : kinds())
        shapes.push_back({kind.label, kind.color, SceneShape::Kind::lines, {}});
    const auto pointsOf = [&](Probe::Role role) -> std::vector<dvec3>& {
        return shapes[first + static_cast<std::size_t>(role)].pointsWorld;
    };
    for (const Probe::Segment& segment : probe.geometry)
        pointsOf(segment.role).insert(pointsOf(segment.role).end(), {segment.fromWorld, segment.toWorld});
    if (probe.geometry.empty()) return {};

    const Facing facing(outside);
    for (const Probe::Vector& vector : probe.vectors) {
        const Arrow arrow = arrowOf(probe, facing, vector);
        addArrow(pointsOf(roleOf(vector)), facing, arrow.fromWorld, arrow.byWorld);
    }
    return shapes;
}

std::vector<NamedPoint> pixelNames(const Probe& probe, const scene::Camera& outside) {
    std::vector<NamedPoint> names;
    if (probe.geometry.empty()) return names;
    const Facing facing(outside);
    const auto colorOf = [](Probe::Role role) { return kinds()[static_cast<std::size_t>(role)].color; };
    for (const Probe::Vector& vector : probe.vectors) {
        const Arrow arrow = arrowOf(probe, facing, vector);
        names.push_back({vector.label, colorOf(roleOf(vector)), arrow.fromWorld + (isOnRay(vector) ? 0.5 : 1.0) * arrow.byWorld});
    }
    std::size_t named = 0;
    for (const Probe::Node& node : probe.tree) {
        if (node.segment < 0 || node.sign.empty() || named == kNamedRays) continue;
        const Probe::Segment& segment = probe.geometry[static_cast<std::size_t>(node.segment)];
        const dvec3 middle = 0.5 * (segment.fromWorld + segment.toWorld);
        if (glm::length(segment.toWorld - segment.fromWorld) < facing.metres(middle, kLeastNamed)) continue;
        ++named;
        names.push_back({node.sign, colorOf(node.role), middle});
    }
    return names;
}

} // namespace shadowlab::picture
