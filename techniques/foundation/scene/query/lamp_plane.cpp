// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/lamp_plane.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/query/mesh_rounding.h"

namespace shadowlab::scene {

namespace {

/// The height over the lamp's plane of a point of an object's mesh, and how much of it may be rounding.
class LampPlane {
public:
    LampPlane(const Object& object, const Light& light) {
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        const dvec3 normalWorld = rectNormalWorld(light), translation(worldFromMesh[3]);
        normalMesh_ = glm::transpose(dmat3(worldFromMesh)) * normalWorld;
        height_ = glm::dot(normalWorld, translation - light.positionWorld);
        rounding_ =
            kDoubleRounding * glm::dot(glm::abs(normalWorld), glm::abs(translation) + glm::abs(light.positionWorld));
    }
    [[nodiscard]] bool holds(const vec3& positionMesh) const {
        const dvec3 products = normalMesh_ * dvec3(positionMesh);
        const dvec3 magnitudes = glm::abs(products);
        return std::abs(height_ + products.x + products.y + products.z) <=
               rounding_ + kFloatRounding * (magnitudes.x + magnitudes.y + magnitudes.z);
    }

private:
    dvec3 normalMesh_{0.0};
    double height_ = 0, rounding_ = 0; ///< metres; the height of the mesh's origin
};

} // namespace

std::vector<std::uint8_t> inLampPlane(const Object& object, const Light& light) {
    if (light.type != LightType::rect) return {};
    const LampPlane plane(object, light);
    const Mesh& mesh = *object.mesh;
    std::vector<std::uint8_t> flags;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const uvec3& t = mesh.triangles[i];
        if (!plane.holds(mesh.positionsMesh[t.x]) || !plane.holds(mesh.positionsMesh[t.y]) ||
            !plane.holds(mesh.positionsMesh[t.z]))
            continue;
        flags.resize(mesh.triangles.size(), 0);
        flags[i] = 1;
    }
    return flags;
}

std::vector<std::uint8_t> inLampPlane(const Scene& scene, const Light& light) {
    std::vector<std::uint8_t> all;
    std::size_t first = 0;
    for (const Object& object : scene.objects) {
        if (object.emitterOfLight < 0) { // the lamp's own surface casts no shadow anyway
            const std::vector<std::uint8_t> flags = inLampPlane(object, light);
            if (!flags.empty()) {
                all.resize(triangleCount(scene), 0);
                std::copy(flags.begin(), flags.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
            }
        }
        first += object.mesh->triangles.size();
    }
    return all;
}

void clearInLampPlane(const Object& object, const Light& light, std::span<std::int8_t> signs) {
    const std::vector<std::uint8_t> flags = inLampPlane(object, light);
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i]) signs[i] = 0;
}

} // namespace shadowlab::scene
