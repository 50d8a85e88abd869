// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/triangle_order.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "techniques/foundation/math/morton.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::scene {

namespace {

// What graphics cards keep; a software renderer keeps some hundreds for a thousand corners.
constexpr std::uint64_t kKept = 32;

// With fewer triangles a frame gains nothing, and the order of the file is easier to follow.
constexpr std::size_t kFewest = 4000;

// From here on an order is bad: what is written row by row has 1 at most, and along the curve it is 0.7 to 0.9. Another order has to be better
// by so much: leaves that share no corner need 3 in any order.
constexpr double kBad = 1.25, kBetter = 0.8;

// Of a place along each axis: a thousandth of the mesh's longest side.
constexpr int kBits = 10;

template <typename T>
std::vector<T> inOrder(const std::vector<T>& values, std::span<const std::uint32_t> order) {
    std::vector<T> result;
    result.reserve(order.size());
    for (const std::uint32_t i : order)
        result.push_back(values[i]);
    return result;
}

/// Vertices stand in the order in which triangles need them: what is read together then lies together in memory.
void numberByFirstUse(Mesh& mesh) {
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> numbers(mesh.positionsMesh.size(), kNone), order;
    order.reserve(numbers.size());
    for (uvec3& corners : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            std::uint32_t& number = numbers[corners[i]];
            if (number == kNone) {
                number = static_cast<std::uint32_t>(order.size());
                order.push_back(corners[i]);
            }
            corners[i] = number;
        }
    mesh.positionsMesh = inOrder(mesh.positionsMesh, order);
    mesh.normalsMesh = inOrder(mesh.normalsMesh, order);
    if (!mesh.texcoords.empty()) mesh.texcoords = inOrder(mesh.texcoords, order);
    if (!mesh.colors.empty()) mesh.colors = inOrder(mesh.colors, order);
}

/// Of each triangle, along Morton's curve.
std::vector<std::uint64_t> placesAlongCurve(const Mesh& mesh) {
    vec3 lower(std::numeric_limits<float>::max()), upper(std::numeric_limits<float>::lowest());
    for (const vec3& position : mesh.positionsMesh) {
        lower = glm::min(lower, position);
        upper = glm::max(upper, position);
    }
    const vec3 extent = upper - lower;
    const float side = std::max({extent.x, extent.y, extent.z}), steps = static_cast<float>((1 << kBits) - 1);
    std::vector<std::uint64_t> places;
    places.reserve(mesh.triangles.size());
    for (const uvec3& corners : mesh.triangles) {
        vec3 sum(0);
        for (int i = 0; i < 3; ++i)
            sum += (mesh.positionsMesh[corners[i]] - lower) / side; // a triangle with an area: the side is not 0
        places.push_back(alongMortonCurve(glm::ivec3(glm::clamp(sum / 3.0f * steps, 0.0f, steps)), kBits));
    }
    return places;
}

} // namespace

double transformedPerTriangle(std::span<const uvec3> triangles) {
    std::uint32_t last = 0;
    for (const uvec3& corners : triangles)
        last = std::max({last, corners.x, corners.y, corners.z});
    std::vector<std::uint64_t> keptAs(std::size_t{last} + 1, 0); // of each corner, the how manieth was kept; 0: none yet
    std::uint64_t kept = 0;
    for (const uvec3& corners : triangles)
        for (int i = 0; i < 3; ++i)
            if (std::uint64_t& number = keptAs[corners[i]]; number == 0 || number + kKept <= kept) number = ++kept;
    return triangles.empty() ? 0 : static_cast<double>(kept) / static_cast<double>(triangles.size());
}

void keepNeighboursTogether(Mesh& mesh) {
    if (mesh.triangles.size() < kFewest) return;
    const std::vector<uvec3> welded = weldedTriangles(mesh);
    const double before = transformedPerTriangle(welded);
    if (before < kBad) return;
    const std::vector<std::uint64_t> places = placesAlongCurve(mesh);
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    for (const MeshPart& part : mesh.parts) {
        const auto first = order.begin() + part.firstTriangle;
        std::ranges::stable_sort(first, first + part.triangleCount, {}, [&](std::uint32_t triangle) { return places[triangle]; });
    }
    if (transformedPerTriangle(inOrder(welded, order)) > kBetter * before) return;
    mesh.triangles = inOrder(mesh.triangles, order);
    mesh.fileOrder = mesh.fileOrder.empty() ? std::move(order) : inOrder(mesh.fileOrder, order);
    numberByFirstUse(mesh);
}

} // namespace shadowlab::scene
