// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/facing_planes.h"

#include <algorithm>

#include "techniques/foundation/scene/query/facing.h"

namespace shadowlab::scene {

namespace {

// In units of S (|L| + |A|), S being the magnitude of the normal's products, |L| and |A| sums of the magnitudes of the
// light's coordinates and the corner's: facing.h takes up to 1e-14 for zero. Its determinant and the one here have the same
// normal and differ by the rounding of what follows, less than 16 * 2^-53 < 0.2e-14 of it. So beyond twice 1e-14 both have
// the same sign, and it is not zero.
constexpr double kClear = 2e-14;

// The compiler vectorises plain loops without branches, but not a loop that converts double to bytes. So there are two
// loops per block, from double to float and from float to bytes. A block of this size stays in the L1 cache.
constexpr std::size_t kBlock = 256;

} // namespace

FacingPlanes::FacingPlanes(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {
    const std::size_t size = mesh_->triangles.size();
    for (std::vector<double>* coordinate : {&x_, &y_, &z_, &w_})
        coordinate->resize(size);
    for (const vec3& positionMesh : mesh_->positionsMesh)
        farthest_ = std::max(farthest_, sumOfMagnitudes(dvec3(positionMesh)));
    for (std::size_t t = 0; t < size; ++t) {
        const uvec3& corner = mesh_->triangles[t];
        const dvec3 a(mesh_->positionsMesh[corner.x]);
        const dvec3 u = dvec3(mesh_->positionsMesh[corner.y]) - a, v = dvec3(mesh_->positionsMesh[corner.z]) - a;
        const dvec3 normal(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
        const double scale =
            std::max({std::abs(u.y * v.z) + std::abs(u.z * v.y), std::abs(u.z * v.x) + std::abs(u.x * v.z),
                      std::abs(u.x * v.y) + std::abs(u.y * v.x)});
        if (scale == 0) continue; // a degenerate triangle: its plane stays zero, so it is always in doubt
        x_[t] = normal.x / scale;
        y_[t] = normal.y / scale;
        z_[t] = normal.z / scale;
        w_[t] = -glm::dot(normal, a) / scale;
    }
}

void FacingPlanes::findSigns(const dvec4& lightMesh, std::span<std::int8_t> signs) const {
    const double clear = kClear * (sumOfMagnitudes(dvec3(lightMesh)) + farthest_ * std::abs(lightMesh.w));
    for (std::size_t first = 0; first < signs.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, signs.size() - first);
        const double *const x = x_.data() + first, *const y = y_.data() + first, *const z = z_.data() + first,
                            *const w = w_.data() + first;
        float clearSide[kBlock];
        for (std::size_t i = 0; i < count; ++i) {
            const double side = x[i] * lightMesh.x + y[i] * lightMesh.y + z[i] * lightMesh.z + w[i] * lightMesh.w;
            clearSide[i] = static_cast<float>((side > clear ? 1.0 : 0.0) - (side < -clear ? 1.0 : 0.0));
        }
        for (std::size_t i = 0; i < count; ++i)
            signs[first + i] = static_cast<std::int8_t>(clearSide[i]);
    }
    // Zero so far means in doubt.
    for (auto doubt = std::ranges::find(signs, 0); doubt != signs.end(); doubt = std::find(doubt + 1, signs.end(), 0)) {
        const uvec3& corner = mesh_->triangles[static_cast<std::size_t>(doubt - signs.begin())];
        *doubt = facingSign(dvec3(mesh_->positionsMesh[corner.x]), dvec3(mesh_->positionsMesh[corner.y]),
                            dvec3(mesh_->positionsMesh[corner.z]), lightMesh);
    }
}

} // namespace shadowlab::scene
