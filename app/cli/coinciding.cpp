// SPDX-License-Identifier: MIT
#include "app/cli/coinciding.h"

#include <map>
#include <tuple>

#include "techniques/foundation/scene/query/coincident/coincident_faces.h"

namespace shadowlab::cli {

namespace {

struct Surface {
    std::size_t object, part;
    auto operator<=>(const Surface&) const = default;
};

std::string nameOf(const scene::Scene& scene, const Surface& surface) {
    const scene::Object& object = scene.objects[surface.object];
    if (object.mesh->parts.size() == 1) return object.name;
    return object.name + " (" + scene.materials[object.partMaterials[surface.part]].name + ")";
}

} // namespace

std::vector<Coinciding> coinciding(const scene::Scene& scene) {
    const auto faces = scene::CoincidentFaces::of(scene);
    if (faces->isEmpty()) return {};
    const auto surfaceOf = [&](std::uint32_t number) {
        const scene::CoincidentFaces::Triangle& triangle = faces->triangle(number);
        return Surface{triangle.object, scene::partOf(*scene.objects[triangle.object].mesh, triangle.inObject)};
    };
    struct Found {
        std::uint64_t pairs = 0, firstSeen = 0; ///< of the pairs, those of which the first surface's front is seen
    };
    std::map<std::tuple<Surface, Surface, bool>, Found> found;
    for (const auto& [triangle, other, faceAlike, gap] : faces->pairs()) {
        const Surface own = surfaceOf(triangle), others = surfaceOf(other);
        if (others < own || (others == own && other < triangle)) continue; // each pair stands in both orders
        Found& entry = found[{own, others, faceAlike}];
        ++entry.pairs;
        entry.firstSeen += faces->rank(other, faceAlike) < faces->rank(triangle, true);
    }
    std::vector<Coinciding> result;
    for (const auto& [key, entry] : found) {
        const auto& [first, second, faceAlike] = key;
        const auto isBody = [&](const Surface& surface) {
            return scene::CoincidentFaces::isInner(scene, scene.objects[surface.object], false);
        };
        Coinciding& one = result.emplace_back(nameOf(scene, first), nameOf(scene, second), faceAlike,
                                              !faceAlike && first.object != second.object && (isBody(first) || isBody(second)), entry.pairs);
        if (!faceAlike)
            one.seen = "from each side the one that faces the eye";
        else if (first == second)
            one.seen = "the later face";
        else
            one.seen = entry.firstSeen == entry.pairs ? one.first : entry.firstSeen == 0 ? one.second : "of each two the later face";
    }
    return result;
}

} // namespace shadowlab::cli
