// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/facing.h"

#include "techniques/foundation/scene/query/lamp_plane.h"

namespace shadowlab::scene {

namespace {

// A determinant of this share of the sum of its terms' magnitudes is rounding, not geometry: about 45 units in the last
// place of double, for the three subtractions, nine products and the change of space before them.
constexpr double kRelativeRounding = 1e-14;

} // namespace

// The sign of the volume spanned by the triangle's edges and the way to the light.
std::int8_t facingSign(const dvec3& a, const dvec3& b, const dvec3& c, const dvec4& light) {
    const dvec3 u = b - a, v = c - a, w = dvec3(light) - a * light.w;
    const dvec3 products(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    const dvec3 magnitudes(std::abs(u.y * v.z) + std::abs(u.z * v.y), std::abs(u.z * v.x) + std::abs(u.x * v.z),
                           std::abs(u.x * v.y) + std::abs(u.y * v.x));
    const double determinant = glm::dot(products, w);
    const double bound = kRelativeRounding * glm::dot(magnitudes, glm::abs(dvec3(light)) + glm::abs(a * light.w));
    if (std::abs(determinant) <= bound) return 0;
    return determinant > 0 ? 1 : -1;
}

dvec4 lightMesh(const Object& object, const Light& light) {
    // The difference is taken first, relative to the mesh: far from the world's origin it keeps its digits, while a product
    // would lose them.
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    const dvec4 lightWorld = homogeneousPositionWorld(light);
    const dvec3 relativeWorld = dvec3(lightWorld) - dvec3(worldFromMesh[3]) * lightWorld.w;
    return {glm::inverse(dmat3(worldFromMesh)) * relativeWorld, lightWorld.w};
}

std::vector<std::int8_t> facingSigns(const Object& object, const Light& light) {
    const dvec4 lightInMesh = lightMesh(object, light);
    const Mesh& mesh = *object.mesh;
    std::vector<std::int8_t> signs;
    signs.reserve(mesh.triangles.size());
    for (const uvec3& t : mesh.triangles)
        signs.push_back(facingSign(dvec3(mesh.positionsMesh[t.x]), dvec3(mesh.positionsMesh[t.y]),
                                   dvec3(mesh.positionsMesh[t.z]), lightInMesh));
    clearInLampPlane(object, light, signs);
    return signs;
}

std::vector<std::int8_t> facingSigns(const Scene& scene, const Light& light) {
    std::vector<std::int8_t> signs;
    for (const Object& object : scene.objects) {
        const std::vector<std::int8_t> ofObject = facingSigns(object, light);
        signs.insert(signs.end(), ofObject.begin(), ofObject.end());
    }
    return signs;
}

} // namespace shadowlab::scene
