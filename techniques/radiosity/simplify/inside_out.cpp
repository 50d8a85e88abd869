// SPDX-License-Identifier: MIT
#include "techniques/radiosity/simplify/inside_out.h"

#include <cmath>
#include <utility>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "techniques/radiosity/patches/winding_number.h"

namespace shadowlab::radiosity {

namespace {

// Enough rays to tell whether most places are inside out. Coarse meshes intersect themselves here and there, so single places
// prove little.
constexpr int kRays = 32;

/// The winding number at a place on a triangle, without that triangle itself.
int winding(const trace::Bvh& bvh, std::uint32_t triangle, const dvec3& from, const dvec3& direction) {
    int sum = 0;
    const auto isOther = [&](std::uint32_t number) { return number != triangle; };
    const auto count = [&](std::uint32_t number, const dvec3&) {
        sum += windingOf(bvh.triangles[number], direction);
        return true; // continue to the next hit
    };
    (void)bvh.any({from, direction}, isOther, count);
    return sum;
}

/// One round: turns the triangles that have a negative winding number before their front. Returns how many.
std::size_t orientOnce(ClusteredMesh& mesh) {
    std::vector<trace::Triangle> triangles;
    for (const uvec3& t : mesh.triangles)
        triangles.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    const trace::Bvh bvh = trace::buildBvh(std::move(triangles));
    std::vector<std::uint8_t> isTurned(mesh.triangles.size());
    trace::parallelFor(isTurned.size(), [&](std::size_t i) {
        const trace::Triangle& t = bvh.triangles[i];
        const dvec3 normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
        int negative = 0;
        for (int ray = 0; ray < kRays; ++ray) {
            const auto x = hammersley4(ray, kRays);
            const double height = 2 * x[2] - 1, radius = std::sqrt(1 - height * height),
                         angle = glm::two_pi<double>() * x[3];
            const dvec3 direction(radius * std::cos(angle), height, radius * std::sin(angle)); // uniform on the sphere
            const dvec3 forward = glm::dot(direction, normal) < 0 ? -direction : direction;
            const Place from = placeIn({t.a, t.b, t.c}, x[0], x[1]);
            negative += winding(bvh, static_cast<std::uint32_t>(i), from.point, forward) < 0;
        }
        isTurned[i] = 2 * negative > kRays;
    });
    std::size_t count = 0;
    for (std::size_t i = 0; i < isTurned.size(); ++i) {
        if (!isTurned[i]) continue;
        std::swap(mesh.triangles[i].y, mesh.triangles[i].z);
        ++count;
    }
    return count;
}

} // namespace

void orientOutward(ClusteredMesh& mesh, bool isMirrored) {
    const auto turnAll = [&] {
        for (uvec3& t : mesh.triangles)
            std::swap(t.y, t.z);
    };
    if (isMirrored) turnAll();
    // Turning a triangle changes the winding number near it, so this is repeated. A few triangles that intersect others may never
    // settle.
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds && orientOnce(mesh) > 0; ++round) {
    }
    if (isMirrored) turnAll();
}

} // namespace shadowlab::radiosity
