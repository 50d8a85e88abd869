// Triangles that are longer than a patch are cut; smaller ones are joined, or a fine mesh would make more patches than there is time
// for. Simplified: patches do not end where other things stand on them, and are no smaller where light changes fast.
// SPDX-License-Identifier: MIT
#include "techniques/lecture/parts/patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::lecture {

namespace {

/// Points that stand for a patch: more find shadows and near neighbours more exactly, at a cost that grows with their square.
constexpr std::size_t kPoints = 4;

/// In which of the m x m a point (1 - b - c) A + b B + c C lies. Twin of shaders/lecture/patch.frag.
std::size_t placeOfPatch(double b, double c, int m) {
    const int i = static_cast<int>(b * m), j = static_cast<int>(c * m);
    const bool upper = b * m - i + c * m - j > 1;
    return static_cast<std::size_t>(i * (2 * m - i) + 2 * j + upper);
}

// Of the many points of joined triangles, every so-manieth stands for all.
void thinOut(Patch& patch) {
    if (patch.points.size() <= kPoints) return;
    std::vector<SurfacePoint> kept;
    for (std::size_t p = 0; p < kPoints; ++p) {
        kept.push_back(patch.points[(2 * p + 1) * patch.points.size() / (2 * kPoints)]);
        kept.back().area = patch.area / kPoints;
    }
    patch.points = std::move(kept);
}

// "Divide each surface into small surface polygons (surface patches)", none longer than `size` metres. Triangles that are smaller
// are joined with those of the same object that face the same way, within cubes of that size.
// [anchor: lecture-patches]
DividedSurfaces divide(const RayScene& rays, double size) {
    DividedSurfaces divided;
    auto& [patches, divisions] = divided;
    std::map<std::tuple<std::uint32_t, std::uint32_t, int, int, int, int>, std::size_t> joined;
    const std::vector<scene::Bounds> bounds = scene::objectBounds(rays.scene());
    divisions.assign(rays.triangles().size(), {});
    for (const Triangle& t : rays.triangles()) {
        const dvec3 ab = t.bWorld - t.aWorld, ac = t.cWorld - t.aWorld, doubleArea = glm::cross(ab, ac);
        const double area = glm::length(doubleArea) / 2;
        if (rays.objectOf(t).emitterOfLight >= 0 || area == 0)
            continue; // that of a light only shows where the light is
        const dvec3 N = (scene::isMirrored(rays.objectOf(t)) ? -0.5 : 0.5) / area * doubleArea;
        const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
        Division& division = divisions[t.number] = {patches.size(), static_cast<int>(std::ceil(longest / size))};
        if (division.m == 1) {
            const dvec3 steep = glm::abs(N), center = t.aWorld + (ab + ac) / 3.0;
            const int axis = steep.x > steep.y && steep.x > steep.z ? 0 : steep.y > steep.z ? 1 : 2;
            const glm::ivec3 cube(glm::floor((center - bounds[t.object].lowerWorld) / size + 0.5));
            const std::tuple key{t.object, t.material, N[axis] < 0 ? -1 - axis : axis, cube.x, cube.y, cube.z};
            division.first = joined.try_emplace(key, patches.size()).first->second;
        }
        const auto count = static_cast<std::size_t>(division.m * division.m);
        patches.resize(std::max(patches.size(), division.first + count));
        const int pieces = division.m == 1 ? 1 : 2 * division.m; // along an edge: four to a patch
        const auto add = [&](double b, double c) {
            Patch& patch = patches[division.first + placeOfPatch(b, c, division.m)];
            patch.points.push_back({t.aWorld + b * ab + c * ac, N, area / (pieces * pieces), &t});
            patch.area += patch.points.back().area;
            patch.material = &rays.scene().materials[t.material];
            patch.diffuse += patch.points.back().area *
                             dvec3(scene::diffuseAt(rays.scene(), rays.objectOf(t), t.inObject, {1 - b - c, b, c}));
        };
        for (int i = 0; i < pieces; ++i)
            for (int j = 0; i + j < pieces; ++j) { // the centres of both halves of a parallelogram
                add((i + 1 / 3.0) / pieces, (j + 1 / 3.0) / pieces);
                if (i + j + 1 < pieces) add((i + 2 / 3.0) / pieces, (j + 2 / 3.0) / pieces);
            }
    }
    for (Patch& patch : patches) {
        patch.diffuse /= patch.area;
        thinOut(patch);
    }
    return divided;
}

} // namespace

DividedSurfaces divideSurfaces(const RayScene& rays, std::size_t most) {
    scene::Bounds bounds;
    for (const scene::Bounds& object : scene::objectBounds(rays.scene()))
        bounds.include(object);
    if (bounds.isEmpty()) return {};
    double size = 1.01 * glm::distance(bounds.lowerWorld, bounds.upperWorld); // nothing is longer
    DividedSurfaces best = divide(rays, size);
    if (best.patches.size() > most)
        throw Error(ExitStatus::overLimit,
                    "lecture-radiosity: scene \"" + rays.scene().name + "\" makes " +
                        std::to_string(best.patches.size()) + " patches at least, more than " + std::to_string(most) +
                        "; choose a larger lecture-radiosity.patches, or a scene of fewer objects");
    while (!best.patches.empty()) {
        size *= 0.8;
        DividedSurfaces finer = divide(rays, size);
        if (finer.patches.size() > most) break;
        best = std::move(finer);
    }
    return best;
}

} // namespace shadowlab::lecture
