// SPDX-License-Identifier: MIT
#include "app/picture/outside/outside_choice.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "techniques/foundation/base/error.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::picture {

namespace {

constexpr std::string_view kAllVolumes = "all";

/// Rays through the eye's picture: a shadow that none of them meets takes less than a thousandth of it.
constexpr int kRaysAcross = 48, kRaysDown = 27;

} // namespace

OutsideChoice outsideChoiceOf(const std::string& volumes, bool nearClipPyramid, const scene::Scene& scene,
                              const std::string& asked) {
    OutsideChoice choice;
    choice.nearClipPyramid = nearClipPyramid;
    choice.allVolumes = volumes == kAllVolumes;
    if (volumes.empty() || choice.allVolumes) return choice;
    const auto found = std::ranges::find(scene.objects, volumes, &scene::Object::name);
    if (found == scene.objects.end()) {
        std::string names;
        for (const scene::Object& object : scene.objects)
            names += (names.empty() ? "" : ", ") + object.name;
        throw Error(ExitStatus::usage, asked + ": the scene has no object '" + volumes + "'; write all, or one of: " + names);
    }
    choice.caster = static_cast<std::size_t>(found - scene.objects.begin());
    return choice;
}

std::string volumesText(const OutsideChoice& choice, const scene::Scene& scene) {
    if (choice.allVolumes) return std::string(kAllVolumes);
    return choice.caster && *choice.caster < scene.objects.size() ? scene.objects[*choice.caster].name : "";
}

bool hasShapesOf(const std::vector<SceneShape>& shapes, std::size_t object) {
    return std::ranges::any_of(shapes, [&](const SceneShape& shape) { return shape.object == object; });
}

std::optional<std::size_t> casterAbove(const Probe& probe) {
    const auto* volumes = probe.find<VolumeProbe>();
    if (!volumes) return {};
    const auto found = std::ranges::find_if(volumes->casters, &VolumeProbe::Caster::holdsThePoint);
    if (found == volumes->casters.end()) return {};
    return found->object;
}

std::optional<std::size_t> mostSeenCaster(const trace::SceneTracer& tracer, const View& eye, int light,
                                          const std::vector<SceneShape>& shapes) {
    std::map<std::size_t, int> shadowed; // rays that end in the shadow of each object
    for (const SceneShape& shape : shapes)
        if (shape.object) shadowed.try_emplace(*shape.object, 0);
    if (shadowed.empty()) return {};
    const trace::EyeRays rays = tracer.eyeRays(eye.camera, eye.size);
    for (int y = 0; y < kRaysDown && shadowed.size() > 1; ++y)
        for (int x = 0; x < kRaysAcross; ++x) {
            const dvec2 pixel = (dvec2(x, y) + 0.5) / dvec2(kRaysAcross, kRaysDown) * dvec2(eye.size);
            const trace::SurfacePoint point = tracer.eyePoint(rays, pixel);
            if (!point || !tracer.facesLight(point, light) || !tracer.objectOf(point).receivesShadow) continue;
            const std::uint32_t blocker = tracer.blocker(point, light);
            if (blocker == trace::kNoPrimitive) continue;
            const std::size_t caster = tracer.world().objects[blocker];
            // A shadow on the object itself says little: its volume has hardly begun there.
            if (caster == tracer.world().objects[point.primitive]) continue;
            if (const auto found = shadowed.find(caster); found != shadowed.end()) ++found->second;
        }
    return std::ranges::max_element(shadowed, {}, [](const auto& entry) { return entry.second; })->first;
}

std::vector<SceneShape> chosenShapes(const std::vector<SceneShape>& shapes, const OutsideChoice& choice,
                                     std::optional<std::size_t> caster) {
    std::vector<SceneShape> chosen;
    for (const SceneShape& shape : shapes) {
        if (shape.onRequest && !choice.nearClipPyramid) continue;
        if (shape.object && !choice.allVolumes && shape.object != caster) continue;
        const bool goesOn = !chosen.empty() && shape.object && chosen.back().object && chosen.back().label == shape.label &&
                            chosen.back().kind == shape.kind;
        if (goesOn)
            chosen.back().pointsWorld.insert(chosen.back().pointsWorld.end(), shape.pointsWorld.begin(), shape.pointsWorld.end());
        else
            chosen.push_back(shape);
    }
    return chosen;
}

} // namespace shadowlab::picture
