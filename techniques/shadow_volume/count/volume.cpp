// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/volume.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace shadowlab::shadow_volume {

namespace {

// Sides. The cap runs a -> b, so the side that joins it there runs b -> a, and where it joins the bottom cap a -> b.
void buildSides(const EdgeTable& edges, std::span<const std::int8_t> facing, std::uint32_t far,
                std::vector<SilhouetteEdge>& silhouette, std::vector<std::uint32_t>& sides) {
    silhouette.clear();
    sides.clear();
    forEachSilhouetteEdge(edges, facing, [&](std::uint32_t a, std::uint32_t b, int sum, std::uint32_t triangles) {
        if (sum < 0) std::swap(a, b);
        const auto multiplicity = static_cast<std::uint32_t>(std::abs(sum));
        silhouette.push_back({a, b, multiplicity, triangles});
        for (std::uint32_t i = 0; i < multiplicity; ++i)
            sides.insert(sides.end(), {b, a, a + far});
    });
    // The other half of each quad comes after the first halves of all.
    sides.reserve(2 * sides.size());
    for (const SilhouetteEdge& edge : silhouette)
        for (std::uint32_t i = 0; i < edge.multiplicity; ++i)
            sides.insert(sides.end(), {edge.b, edge.a + far, edge.b + far});
}

// Caps. The top cap keeps the order in which the mesh itself is drawn: with another order the rasteriser's depth may differ
// in the last bit and the cap would fight with the very surface it lies on.
//
// Without branches: each triangle is written to the end of every list, and the end of a list advances only if the triangle
// belongs there; otherwise the next triangle overwrites it. A branch on the sign would be mispredicted half of the time,
// because neighbours in the mesh are in no useful order. Each list needs room for one triangle more than it keeps.
void buildCaps(const scene::Mesh& mesh, std::span<const std::int8_t> facing, std::uint32_t far, Volume& volume) {
    const auto front = static_cast<std::size_t>(std::ranges::count(facing, 1));
    const auto back = static_cast<std::size_t>(std::ranges::count(facing, -1));
    volume.topCap.resize(3 * (front + 1));
    volume.topCapReversed.resize(3 * (back + 1));
    volume.bottomCap.resize(3 * (front + back + 1));
    std::uint32_t *top = volume.topCap.data(), *reversed = volume.topCapReversed.data(),
                  *bottom = volume.bottomCap.data();
    const uvec3* corner = mesh.triangles.data();
    for (const std::int8_t sign : facing) {
        const auto isFront = static_cast<std::ptrdiff_t>(sign > 0), isBack = static_cast<std::ptrdiff_t>(sign < 0);
        const std::uint32_t x = corner->x, y = corner->y, z = corner->z;
        top[0] = reversed[0] = x;
        top[1] = reversed[1] = y;
        top[2] = reversed[2] = z;
        const std::uint32_t swapped = (y ^ z) & static_cast<std::uint32_t>(-isFront); // the bottom looks the other way
        bottom[0] = x + far;
        bottom[1] = (y ^ swapped) + far;
        bottom[2] = (z ^ swapped) + far;
        top += 3 * isFront;
        reversed += 3 * isBack;
        bottom += 3 * (isFront + isBack);
        ++corner;
    }
    volume.topCap.resize(3 * front);
    volume.topCapReversed.resize(3 * back);
    volume.bottomCap.resize(3 * (front + back));
}

} // namespace

void buildVolume(const scene::Mesh& mesh, const EdgeTable& edges, std::span<const std::int8_t> facing,
                 std::vector<SilhouetteEdge>& silhouette, Volume& volume) {
    const auto far = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    buildSides(edges, facing, far, silhouette, volume.sides);
    buildCaps(mesh, facing, far, volume);
}

} // namespace shadowlab::shadow_volume
