// "Every polygon is rendered N + 1 times": the passes of a frame, and how many polygons each of them draws.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

constexpr double kPassesBorder = 24, kNumber = 130; ///< pixels; kNumber: of a count at the end of a bar
constexpr double kNamesWidth = 470;                 ///< of the words before the bars
constexpr double kLeastRow = 34, kMostRow = 78;
constexpr const char *kFromEye = "#0072b2", *kOfLight = "#a06000";

std::string nameOf(const Probe::DrawnPass& pass, const scene::Scene& scene) {
    if (pass.light < 0) return "lights off, from the eye";
    const std::string& light = scene.light(pass.light).name;
    return pass.id == "depth" ? "depth map, from light " + light : "light " + light + " added, from the eye";
}

std::string thousands(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3; at -= 3)
        text.insert(at - 3, "\u202f"); // a narrow blank, as ISO 80000 has it
    return text;
}

} // namespace

Diagram drawPassesFigure(const FigureSource& source) {
    const std::vector<Probe::DrawnPass>& passes = source.probe.passes;
    if (source.probe.geometry.empty())
        throw Error(ExitStatus::badInput, "the pixel shows the background; choose another");
    if (passes.empty())
        throw Error(ExitStatus::badInput, std::string(source.technique) +
                                              " does not tell how often it draws; ask shadow-map with one map for each "
                                              "light, in a scene with lights");
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kPassesBorder), source.size - 2 * kPassesBorder};
    const std::size_t lights = source.scene.lights.size();
    constexpr double foot = 4 * 36 + 20;
    const double row =
        std::clamp((area.size.y - kHeading - 24 - foot) / static_cast<double>(passes.size()), kLeastRow, kMostRow);
    const auto rows = std::min(passes.size(), static_cast<std::size_t>((area.size.y - kHeading - 24 - foot) / row));
    std::uint64_t most = 1, all = 0;
    for (const Probe::DrawnPass& pass : passes) {
        most = std::max(most, pass.triangles);
        all += pass.triangles;
    }
    drawing.text(area.corner + dvec2(0, kHeading), "Polygons that each pass of a frame draws",
                 {.size = kHeading, .isBold = true});
    const double left = area.corner.x + std::min(kNamesWidth, 0.45 * area.size.x),
                 widest = area.corner.x + area.size.x - kNumber - left;
    dvec2 at = area.corner + dvec2(0, kHeading + 24);
    for (std::size_t i = 0; i < rows; ++i) {
        const Probe::DrawnPass& pass = passes[i];
        const double width = widest * static_cast<double>(pass.triangles) / static_cast<double>(most);
        const double middle = at.y + 0.5 * row, line = middle + 0.35 * kText;
        drawing.text({area.corner.x, line}, std::to_string(i + 1) + ". " + nameOf(pass, source.scene), {.size = kText});
        drawing.rectangle({left, at.y + 5}, {std::max(width, 1.0), row - 10}, pass.id == "depth" ? kOfLight : kFromEye,
                          {"", 0, false});
        drawing.text({left + width + 12, line}, thousands(pass.triangles), {.size = kText, .isBold = true});
        at.y += row;
    }
    if (rows < passes.size())
        drawing.text(at + dvec2(0, kText), "and " + std::to_string(passes.size() - rows) + " more", {.size = kText});
    at = area.corner + dvec2(0, area.size.y - foot + 40);
    const std::string n = std::to_string(lights);
    drawing.text(at,
                 "N = " + n + (lights == 1 ? " light: " : " lights: ") + std::to_string(passes.size()) +
                     " passes = 2N + 1, " + thousands(all) + " polygons",
                 {.size = kHeading, .isBold = true});
    drawing.text(at + dvec2(0, 40),
                 "The lecture's N + 1 = " + std::to_string(lights + 1) +
                     ": once from each light, once from the eye for all.",
                 {.size = kText});
    drawing.text(at + dvec2(0, 74), "Here each light has a pass of its own from the eye, and what a map covers",
                 {.size = kText});
    drawing.text(at + dvec2(0, 108), "in part is drawn twice: with the map, and without.", {.size = kText});
    return {std::move(drawing),
            "The passes of a frame with " + n + " lights, and how many polygons each of them draws"};
}

} // namespace shadowlab::figures
