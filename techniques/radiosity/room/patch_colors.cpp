// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/patch_colors.h"

#include <algorithm>

#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"

namespace shadowlab::radiosity {

PatchColors::PatchColors(const scene::Scene& scene) : scene_(std::make_shared<const scene::Scene>(scene)) {
    for (const scene::Object& object : scene_->objects)
        ownColors_.push_back(scene::hasOwnColors(*scene_, object));
    if (std::ranges::find(ownColors_, true) != ownColors_.end())
        tracer_.advance(scene_, std::chrono::steady_clock::time_point::max());
}

dvec3 PatchColors::mean(const Patch& patch, const dvec3& originWorld, std::uint32_t object, double reach, const dvec3& otherwise) const {
    // Each triangle of the fan is cut into m x m of equal area; their centres stand for them.
    constexpr int m = 4;
    const dvec3 moved = originWorld - tracer_.world().originWorld, a = patch.polygon[0];
    dvec3 sum(0.0);
    double area = 0;
    for (std::size_t corner = 2; corner < patch.polygon.count(); ++corner) {
        const dvec3 ab = patch.polygon[corner - 1] - a, ac = patch.polygon[corner] - a;
        const double piece = glm::length(glm::cross(ab, ac)) / (2 * m * m);
        const auto add = [&](double b, double c) {
            sum += piece * at(moved + a + b / m * ab + c / m * ac, patch.normal, object, reach, otherwise);
            area += piece;
        };
        for (int i = 0; i < m; ++i)
            for (int j = 0; i + j < m; ++j) {
                add(i + 1 / 3.0, j + 1 / 3.0);
                if (i + j + 1 < m) add(i + 2 / 3.0, j + 2 / 3.0);
            }
    }
    return area > 0 ? sum / area : otherwise;
}

dvec3 PatchColors::at(const dvec3& centred, const dvec3& normal, std::uint32_t object, double reach, const dvec3& otherwise) const {
    // Of this object alone: something may lie on it, or in its plane.
    const trace::Ray ray{.originCentred = centred + reach * normal, .directionCentred = -normal, .farthest = 2 * reach};
    const trace::RayHit hit = tracer_.bvh().closest(
        ray, [&](std::uint32_t primitive) { return tracer_.world().objects[primitive] == object; },
        [](std::uint32_t, const dvec3&) { return false; });
    if (!hit) return otherwise;
    return dvec3(scene::diffuseAt(*scene_, scene_->objects[object], tracer_.world().triangleInMesh(hit.primitive), hit.barycentric));
}

} // namespace shadowlab::radiosity
