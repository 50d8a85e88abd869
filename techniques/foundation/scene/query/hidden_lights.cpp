// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/hidden_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/holes.h"

namespace shadowlab::scene {

namespace {

// A caster encloses a point if it is hit in all of these directions. A hole that all of them miss is narrower than about 10
// degrees. Large meshes are asked in fewer directions, so that loading them takes no longer than before.
constexpr std::size_t kMostDirections = 256, kLeastDirections = 32;
constexpr std::size_t kMostTests = 20'000'000; // rays times triangles: a tenth of a second

/// Evenly over the sphere: on a spiral, each a golden angle from the one before.
dvec3 directionOf(std::size_t i, std::size_t count) {
    constexpr double kGoldenAngle = 2.399963229728653; // pi (3 - sqrt 5)
    const double y = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double across = std::sqrt(1 - y * y), turn = kGoldenAngle * static_cast<double>(i);
    return {across * std::cos(turn), y, across * std::sin(turn)};
}

/// The triangles of an object about a point, which is the origin.
class Shell {
public:
    Shell(const Object& object, const dvec3& aboutWorld) : mesh_(*object.mesh) {
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        corners_.reserve(mesh_.positionsMesh.size());
        for (const vec3& position : mesh_.positionsMesh)
            corners_.push_back(transformPoint(worldFromMesh, dvec3(position)) - aboutWorld);
    }

    /// Is the way to origin + direction * t hit for a t in (least, most)? (Moeller and Trumbore, 1997)
    [[nodiscard]] bool isHit(const dvec3& direction, double least, double most) const {
        return std::ranges::any_of(mesh_.triangles, [&](const uvec3& t) {
            const dvec3 &a = corners_[t.x], ab = corners_[t.y] - a, ac = corners_[t.z] - a;
            const dvec3 p = glm::cross(direction, ac);
            const double volume = glm::dot(ab, p);
            if (volume == 0) return false;
            constexpr double kEdge = 1e-9; // a ray through an edge hits one of the two triangles at least
            const double b = -glm::dot(a, p) / volume;
            const dvec3 q = glm::cross(-a, ab);
            const double c = glm::dot(direction, q) / volume, distance = glm::dot(ac, q) / volume;
            return b >= -kEdge && c >= -kEdge && b + c <= 1 + kEdge && distance > least && distance < most;
        });
    }

    /// Is the origin enclosed, and all within `least` of it with it?
    [[nodiscard]] bool encloses(double least = 0) const {
        const std::size_t count = std::clamp(kMostTests / std::max<std::size_t>(mesh_.triangles.size(), 1),
                                             kLeastDirections, kMostDirections);
        for (std::size_t i = 0; i < count; ++i)
            if (!isHit(directionOf(i, count), least, std::numeric_limits<double>::infinity())) return false;
        return true;
    }

private:
    const Mesh& mesh_;
    std::vector<dvec3> corners_;
};

bool isWithin(const Bounds& bounds, const dvec3& point) {
    return glm::all(glm::lessThan(bounds.lowerWorld, point)) && glm::all(glm::lessThan(point, bounds.upperWorld));
}

/// How far a light's surface reaches from its centre.
double reach(const Light& light) {
    if (light.type == LightType::sphere) return light.radius;
    if (light.type == LightType::rect)
        return 0.5 * glm::length(glm::abs(light.edgeUWorld) + glm::abs(light.edgeVWorld));
    return 0;
}

bool hides(const Object& object, const Light& light, const dvec3& eyeWorld) {
    const Shell aboutLight(object, light.positionWorld);
    // Most lights are seen by the eye: one ray tells.
    if (!aboutLight.isHit(eyeWorld - light.positionWorld, 0, 1)) return false;
    return aboutLight.encloses(reach(light)) && !Shell(object, eyeWorld).encloses();
}

} // namespace

std::vector<std::string> notesOnHiddenLights(const Scene& scene) {
    std::vector<std::string> notes;
    if (std::ranges::all_of(scene.lights, [](const Light& l) { return l.type == LightType::directional; }))
        return notes;
    const std::vector<Bounds> bounds = objectBounds(scene);
    for (const Light& light : scene.lights) {
        if (light.type == LightType::directional) continue;
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const Object& object = scene.objects[i];
            if (!object.castsShadow || object.emitterOfLight >= 0 || hasHoles(scene, object)) continue;
            if (!isWithin(bounds[i], light.positionWorld) || !hides(object, light, scene.camera.positionWorld))
                continue;
            notes.push_back(
                "light " + inQuotes(light.name) + " stands inside of object " + inQuotes(object.name) +
                ", which is closed and casts a shadow on all sides, also where its material is transparent: "
                "outside of it this light lights nothing; set \"castsShadow\": false for the object, or move "
                "the light out");
            break; // one reason is enough
        }
    }
    return notes;
}

} // namespace shadowlab::scene
