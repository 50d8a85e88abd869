// SPDX-License-Identifier: MIT
#include "techniques/technique.h"

#include <array>
#include <charconv>

#include "techniques/exact_judge.h"
#include "techniques/probed/seen_point.h"

namespace shadowlab {

std::string probeText(double number) {
    std::array<char, 32> text{};
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), number + 0.0, std::chars_format::general, 6); // no "-0"
    return error == std::errc{} ? std::string(text.data(), end) : "?";
}

Probe::Fact probeFact(std::string label, double number, std::string unit) {
    return {std::move(label), probeText(number), std::move(unit), {number}};
}

Probe::Fact probeFact(std::string label, const dvec3& vector, std::string unit) {
    return {std::move(label),
            probeText(vector.x) + ", " + probeText(vector.y) + ", " + probeText(vector.z),
            std::move(unit),
            {vector.x, vector.y, vector.z}};
}

Probe::Fact probeCount(std::string label, std::uint64_t count, std::string unit) {
    return {std::move(label), std::to_string(count), std::move(unit), {static_cast<double>(count)}};
}

// What holds for every technique: which surface the pixel shows and what is exactly true of it.
Probe Technique::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe;
    const auto exact = exactJudge(snapshot);
    const auto hit = exact->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    probe.facts.push_back({"pixel",
                           std::to_string(pixel.x) + ", " + std::to_string(pixel.y),
                           "",
                           {static_cast<double>(pixel.x), static_cast<double>(pixel.y)}});
    if (!hit) {
        probe.add(SeenPoint{});
        probe.facts.push_back({"surface", "none (background)", ""});
        return probe;
    }
    const scene::Object& object = snapshot->objects[hit->object];
    SeenPoint& seen = probe.add(SeenPoint{object.name, object.receivesShadow});
    probe.facts.push_back({"surface", object.name, ""});
    probe.facts.push_back(probeCount("triangle", hit->triangle));
    probe.facts.push_back(probeFact("distance from the eye", hit->distance, "m"));
    probe.geometry.push_back({"eye ray", view.camera.positionWorld, hit->positionWorld, Probe::Role::eye});
    if (light >= 0 && light < static_cast<int>(snapshot->lights.size())) {
        const auto truth = exact->visibility(*hit, view.camera, light);
        seen.light = light;
        seen.lightName = snapshot->light(light).name;
        seen.truth = truth;
        probe.facts.push_back({"truth",
                               truth == trace::Visibility::lit        ? "lit"
                               : truth == trace::Visibility::shadowed ? "in shadow"
                                                                      : "turned away",
                               ""});
        const dvec4 lightWorld = scene::homogeneousPositionWorld(snapshot->light(light));
        // A directional light is nowhere: its ray is shown as long as the eye's.
        const dvec3 end = lightWorld.w > 0 ? dvec3(lightWorld) : hit->positionWorld + hit->distance * dvec3(lightWorld);
        probe.geometry.push_back({"shadow ray", hit->positionWorld, end,
                                  truth == trace::Visibility::lit ? Probe::Role::arriving : Probe::Role::blocked,
                                  lightWorld.w == 0});
        probe.section =
            lightSection(view.camera.positionWorld, hit->positionWorld, lightWorld, hit->geometricNormalWorld);
    }
    return probe;
}

} // namespace shadowlab
