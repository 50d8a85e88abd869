// SPDX-License-Identifier: MIT
#include "techniques/technique.h"

#include "techniques/foundation/trace/exact_visibility.h"

namespace shadowlab {

// What holds for every technique: which surface the pixel shows and what is exactly true of it.
Probe Technique::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe;
    const trace::ExactVisibility exact(snapshot);
    const auto hit = exact.eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    probe.facts.push_back({"pixel", std::to_string(pixel.x) + ", " + std::to_string(pixel.y), ""});
    if (!hit) {
        probe.facts.push_back({"surface", "none (background)", ""});
        return probe;
    }
    probe.facts.push_back({"surface", snapshot->objects[hit->object].name, ""});
    probe.facts.push_back({"triangle", std::to_string(hit->triangle), ""});
    probe.facts.push_back({"distance from the eye", std::to_string(hit->distance), "m"});
    probe.geometry.push_back({"eye ray", view.camera.positionWorld, hit->positionWorld});
    if (light >= 0 && light < static_cast<int>(snapshot->lights.size())) {
        const auto truth = exact.visibility(*hit, view.camera, light);
        probe.facts.push_back({"truth",
                               truth == trace::Visibility::lit        ? "lit"
                               : truth == trace::Visibility::shadowed ? "in shadow"
                                                                      : "turned away",
                               ""});
        const dvec4 lightWorld = scene::homogeneousPositionWorld(snapshot->lights[static_cast<std::size_t>(light)]);
        // A directional light is nowhere: its ray is shown as long as the eye's.
        const dvec3 end = lightWorld.w > 0 ? dvec3(lightWorld) : hit->positionWorld + hit->distance * dvec3(lightWorld);
        probe.geometry.push_back({"shadow ray", hit->positionWorld, end});
    }
    return probe;
}

} // namespace shadowlab
