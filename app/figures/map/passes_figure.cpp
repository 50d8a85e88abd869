// "Every polygon is rendered N + 1 times": once from each light, once from the eye, and how many polygons each of them draws. The program
// itself draws the eye's picture in a pass for each light, so that each can be looked at; what that adds stands below, paler.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/drawing/prose.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/inks.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

constexpr double kPassesBorder = 24, kNumber = 130; ///< pixels; kNumber: of a count at the end of a bar
constexpr double kNamesWidth = 470;                 ///< of the words before the bars
constexpr double kLeastRow = 34, kMostRow = 140;
constexpr double kWidePasses = 1200; ///< from which width on there is room for larger type
constexpr const char* kFromEye = "#4d4d4d"; ///< a lighter ink::kEye: of a large area

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
    const std::string n = std::to_string(lights);
    // The lecture's renderings: the maps in the order of the lights, then the eye's picture, whose first pass draws all that is seen.
    std::vector<const Probe::DrawnPass*> renderings;
    for (const Probe::DrawnPass& pass : passes)
        if (pass.id == "depth") renderings.push_back(&pass);
    renderings.push_back(&passes.front());
    std::uint64_t most = 1, all = 0;
    for (const Probe::DrawnPass& pass : passes) {
        most = std::max(most, pass.triangles);
        all += pass.triangles;
    }
    const bool isAll = renderings.size() == lights + 1; // else a light has several maps, or none
    const drawing::FormulaFonts fonts{source.font, source.bold};
    drawing::drawProse(drawing, area.corner + dvec2(0, kHeading),
                       "$N = " + n + "$" + (lights == 1 ? " light: " : " lights: ") +
                           (isAll ? "$N + 1 = " + std::to_string(renderings.size()) + "$" : std::to_string(renderings.size())) + " renderings",
                       {.size = kHeading, .isBold = true}, fonts);
    const double type = area.size.x > kWidePasses ? kText + 4 : kText, line = 1.4 * type;
    const double below = 4 * line + 16; // of the lines below the bars
    const double row = std::clamp((area.size.y - kHeading - 24 - below) / static_cast<double>(renderings.size()), kLeastRow, kMostRow);
    const auto rows = std::min(renderings.size(), static_cast<std::size_t>((area.size.y - kHeading - 24 - below) / row));
    const double left = area.corner.x + std::min(kNamesWidth, 0.45 * area.size.x), widest = area.corner.x + area.size.x - kNumber - left;
    dvec2 at = area.corner + dvec2(0, kHeading + 24);
    for (std::size_t i = 0; i < rows; ++i) {
        const Probe::DrawnPass& pass = *renderings[i];
        const bool isMap = pass.id == "depth";
        const double width = widest * static_cast<double>(pass.triangles) / static_cast<double>(most);
        const double foot = at.y + 0.5 * row + 0.35 * type;
        drawing.text({area.corner.x, foot},
                     std::to_string(i + 1) + (isMap ? ". from light " + source.scene.light(pass.light).name + ": depth map"
                                                    : ". from the eye: the image"),
                     {.size = type});
        drawing.rectangle({left, at.y + 8}, {std::max(width, 1.0), row - 16}, isMap ? ink::kLight : kFromEye, {"", 0, false});
        drawing.text({left + width + 12, foot}, thousands(pass.triangles), {.size = type, .isBold = true});
        at.y += row;
    }
    if (rows < renderings.size())
        drawing.text(at + dvec2(0, kText), "and " + std::to_string(renderings.size() - rows) + " more", {.size = kText});
    const std::size_t added = passes.size() - renderings.size();
    at.y = std::min(at.y + line, area.corner.y + area.size.y - below + line);
    for (const drawing::ProseLine& words : drawing::wrapProse(
             "This program adds the lights one by one, so that each can be looked at: the image takes a pass with all lights off and " +
                 std::to_string(added) + " more, one for each light. That is " + std::to_string(passes.size()) + " passes" +
                 (passes.size() == 2 * lights + 1 ? ", $2N + 1$" : "") + ", and " + thousands(all) +
                 " polygons. A pass that adds a light draws what its map covers in part twice, inside and outside of it.",
             type, area.size.x, false, fonts)) {
        at.y += line;
        drawing::drawProse(drawing, at, words, {.size = type, .color = "#4d4d4d"}, fonts);
    }
    return {std::move(drawing), "The renderings of a frame with " + n + " lights, and how many polygons each of them draws"};
}

} // namespace shadowlab::figures
