// "Direct projection" of a point that lies on no receiver plane: the technique draws no shadow there. Drawn is what there is: the
// point, eye and light, the scene, and the planes that do receive, as the plane through eye, light and point cuts them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/plane_probe.h"

namespace shadowlab::figures {

namespace {

constexpr const char* kPlane = "#0072b2";
constexpr std::size_t kNamedPlanes = 6; ///< more names would fill the drawing

/// Each plane N.P + D = 0 as a dashed line, with the name of what it belongs to.
void drawPlanes(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, const Probe& probe) {
    const double reach = 2 * glm::length(sheet.metres().size);
    struct Named {
        dvec2 at;
        std::string text;
    };
    std::vector<Named> names;
    drawing.beginClip(sheet.area().corner, sheet.area().size);
    for (const PlaneProbe::Other& other : probe.find<PlaneProbe>()->others) {
        const dvec2 gradient = sheet.section().ofDirection(dvec3(other.planeWorld));
        const double atPoint = glm::dot(other.planeWorld, dvec4(sheet.section().originWorld, 1.0));
        const double length = glm::length(gradient);
        if (length < 1e-9) continue; // it lies in the drawing's plane, or beside it
        const dvec2 foot = -atPoint / (length * length) * gradient, along(gradient.y / length, -gradient.x / length);
        const dvec2 from = sheet(foot - reach * along), to = sheet(foot + reach * along);
        drawing.line(from, to, {kPlane, 3, true});
        labels.avoid(from, to);
        // Named where it is nearest to the middle, if that is seen.
        const dvec2 middle = sheet.metres().corner + 0.5 * sheet.metres().size;
        const dvec2 nearest = foot + glm::dot(middle - foot, along) * along;
        if (sheet.shows(nearest)) names.push_back({sheet(nearest), "plane of " + other.object});
    }
    drawing.endClip();
    for (std::size_t i = 0; i < std::min(names.size(), kNamedPlanes); ++i)
        labels.place(drawing, names[i].at, names[i].text, {.size = kText, .color = kPlane}, 8);
}

} // namespace

void drawNoPlane(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
                 const image::Font& font) {
    constexpr double kNumbers = 610, kLegend = 44;
    drawing.text(area.corner + dvec2(0, kHeading), "Direct projection in the plane through eye, light and point",
                 {.size = kHeading, .isBold = true});
    const drawing::Box field{area.corner + dvec2(0, kHeading + 18),
                    area.size - dvec2(kNumbers + 30, kHeading + 18 + kLegend + 14)};
    const SectionSheet sheet(probe, scene, field, std::vector<dvec2>{});
    drawing::Labels labels(font, field);
    sheet.drawScene(drawing, labels);
    const bool arrives = probe.geometry[1].role == Probe::Role::arriving;
    sheet.drawLines(drawing, labels, drawing::colorText(arrives ? look::kEqualDepth : look::kOccluded), 0.5);
    drawPlanes(drawing, labels, sheet, probe);
    drawing.rectangle(field.corner, field.size, "none", {"#bfbfbf", 2, false});

    TextColumn column(drawing, {area.corner + dvec2(area.size.x - kNumbers, 0), {kNumbers, area.size.y - kLegend - 20}},
                      font);
    column.heading("No receiver plane here");
    column.row("The point lies on none of the planes that receive, so nothing is projected onto it: the technique "
               "draws no shadow there.");
    column.heading("Planes that receive");
    if (probe.find<PlaneProbe>()->others.empty()) column.row("none in view");
    const auto shown = [](double value) { return fourDigits(std::round(value * 1e6) / 1e6); }; // floats have no more
    std::size_t left = probe.find<PlaneProbe>()->others.size();
    for (const PlaneProbe::Other& other : probe.find<PlaneProbe>()->others) {
        const dvec4& p = other.planeWorld;
        if (!column.hasRoom(9)) {
            column.row("and " + std::to_string(left) + " more");
            break;
        }
        --left;
        column.row(other.object + ": N = (" + shown(p.x) + ", " + shown(p.y) + ", " + shown(p.z) +
                       "), D = " + shown(p.w) + " m",
                   kPlane);
    }
    column.heading("This technique");
    for (const Probe::Fact& fact : probe.facts)
        if (fact.label == "decision" || fact.label == "truth" || fact.label == "error")
            column.row(fact.label + ": " + fact.value, fact.label == "error" ? "#a04000" : "#1a1a1a");
    using enum LegendEntry::Kind;
    const LegendEntry legend[] = {{dashed, kPlane, "planes that receive, and where they would go on"},
                                  {line, drawing::colorText(look::kOccluded), "light that does not arrive"},
                                  {line, drawing::colorText(look::kEqualDepth), "light that does"},
                                  {line, "#4d4d4d", "caster"}};
    drawLegend(drawing, {area.corner + dvec2(0, area.size.y - kLegend), {area.size.x, kLegend}}, legend, font);
}

} // namespace shadowlab::figures
