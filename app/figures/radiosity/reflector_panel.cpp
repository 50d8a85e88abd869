// The lecture's figure of a Lambertian reflector: whatever reaches it, it sends the same intensity in all directions. Seen from
// aslant it is smaller, so that less power goes there: I dA cos phi, whose ends lie on a circle (J. H. Lambert, Photometria, 1760).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "app/drawing/prose.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/patch_exchange.h"

namespace shadowlab::figures {

namespace {

constexpr double kReflectorWidth = 760, kReflectorGap = 40, kNumbersWidth = 1060; ///< pixels
constexpr double kLobeLabel = 30;                ///< em: indices are smaller than their letters
constexpr double kTableRow = 38;                 ///< pixels from one line of numbers to the next
constexpr double kLeastCosine = 0.02;            ///< of a direction that has light enough to be shown
constexpr double kArrowStep = glm::pi<double>() / 12; ///< radians from one arrow to the next
constexpr int kPieces = 90, kAvoidedPieces = 15; ///< of half a circle; so many are one line that labels avoid

/// The direction that is pointed out.
struct Way {
    std::string toward;
    double phi = 0;
};

Way shownWay(const PatchExchange& exchange, const dvec3& eyeWorld) {
    const auto way = [&](const char* toward, const dvec3& toWorld) {
        const dvec3 unit = glm::normalize(toWorld - exchange.j.centreWorld);
        return Way{toward, std::atan2(glm::length(glm::cross(exchange.j.normalWorld, unit)),
                                      glm::dot(exchange.j.normalWorld, unit))};
    };
    if (exchange.k) {
        Way toK = way("k", exchange.k->centreWorld);
        if (std::cos(toK.phi) > kLeastCosine) return toK;
    }
    return way("the eye", eyeWorld);
}

/// The letter between two arrows, beyond the arc, where no line leads to it. In a narrow angle there is no room: it stands beside it.
void nameAngle(drawing::Drawing& drawing, drawing::Labels& labels, dvec2 at, double radius, double phi, const image::Font& font) {
    const drawing::TextStyle letter{.size = kLobeLabel, .anchor = drawing::Anchor::middle};
    const double between = kArrowStep * (std::floor(0.5 * phi / kArrowStep) + 0.5), beyond = radius + kLobeLabel;
    if (between + 0.5 * kArrowStep > phi || beyond * kArrowStep < 1.4 * kLobeLabel) {
        labels.place(drawing, at + radius * dvec2(std::sin(0.5 * phi), -std::cos(0.5 * phi)), "$\\phi$", letter, 6);
        return;
    }
    const dvec2 middle = at + beyond * dvec2(std::sin(between), -std::cos(between));
    drawing::drawProse(drawing, middle + dvec2(0, 0.3 * kLobeLabel), "$\\phi$", letter, {font, font});
    labels.avoid({middle - 0.5 * kLobeLabel, dvec2(kLobeLabel)});
}

void drawLobes(drawing::Drawing& drawing, const drawing::Box& area, const Way& way, const image::Font& font) {
    const double most =
        std::min(area.size.y - 105, 0.46 * area.size.x); // of the length of an arrow: I dA along the normal
    const dvec2 at = area.corner + dvec2(0.5 * area.size.x, area.size.y - 46);
    const auto toward = [](double angle) { return dvec2(std::sin(angle), -std::cos(angle)); };
    drawing::Labels labels(font, area);
    const drawing::Stroke rim{"#1a1a1a", 2.5, false}, thin{"#8c8c8c", 2, false};

    std::vector<dvec2> equal, lobe;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = glm::pi<double>() * (static_cast<double>(i) / kPieces - 0.5);
        equal.push_back(at + most * toward(angle));
        lobe.push_back(at + most * std::cos(angle) * toward(angle));
        if (i == 0 || i % kAvoidedPieces != 0) continue;
        labels.avoid(equal[equal.size() - 1 - kAvoidedPieces], equal.back());
        labels.avoid(lobe[lobe.size() - 1 - kAvoidedPieces], lobe.back());
    }
    drawing.path(lobe, true, "#fdf3dc", rim); // a light tint of look::kPatchJ
    drawing.path(equal, false, "", {"#1a1a1a", 2.5, true});
    for (int i = -5; i <= 5; ++i) {
        const double angle = kArrowStep * i;
        drawing.arrow(at, at + most * std::cos(angle) * toward(angle), thin);
        labels.avoid(at, at + most * std::cos(angle) * toward(angle));
    }
    const dvec2 half(0.42 * area.size.x, 0);
    drawing.line(at - half, at + half, {drawing::colorText(look::kPatchJ), 8, false});
    labels.avoid(at - half, at + half);
    const dvec2 top = at + (most + 16) * toward(0), shown = at + most * std::cos(way.phi) * toward(way.phi);
    drawing.arrow(at, top, {"#1a1a1a", 4, false});
    drawing.arrow(at, shown, {"#0072b2", 6, false});
    labels.avoid(at, shown);
    std::vector<dvec2> arc;
    const double radius = 0.3 * most;
    for (int i = 0; i <= kPieces; ++i)
        arc.push_back(at + radius * toward(way.phi * i / kPieces));
    drawing.path(arc, false, "", rim);

    const drawing::TextStyle letter{.size = kLobeLabel};
    labels.place(drawing, top, "$\\mathbf{N}_j$", letter, 8);
    labels.place(drawing, shown, "$I\\, dA_j \\cos\\phi$", letter, 12);
    labels.place(drawing, at + most * toward(-0.8), "$I$", letter, 8);
    nameAngle(drawing, labels, at, radius, way.phi, font);
    labels.place(drawing, at - half * 0.9, "$dA_j$", letter, 8);
}

void writeReflectorNumbers(drawing::Drawing& drawing, const drawing::Box& area, const PatchProbe& j, const Way& way,
                           const image::Font& font) {
    struct Row {
        std::string name, meaning;
        dvec3 values;
        std::string unit;
    };
    const dvec3 intensity = j.radiosity / glm::pi<double>();
    const std::vector<Row> rows = {
        {"$E_j$", "emitted", j.emission, "W/m\u00b2"},
        {"$\\rho_j$", "reflected share", j.reflectance, ""},
        {"$B_j$", "radiosity", j.radiosity, "W/m\u00b2"},
        {"$I = B_j / \\pi$", "intensity", intensity, "W/(m\u00b2 sr)"},
        {"$B_j\\, dA_j$", "radiant flux", j.radiosity * j.area, "W"},
        {"$I\\, dA_j \\cos\\phi$", "toward " + way.toward, intensity * j.area * std::cos(way.phi), "W/sr"},
    };
    const drawing::TextStyle style{.size = kText + 2};
    const drawing::FormulaFonts fonts{font, font};
    const double columns[] = {0, 185, 580, 750, 920, 936};
    double y = area.corner.y + kHeading + kTableRow;
    drawing::drawProse(drawing, {area.corner.x, y},
                       "In every direction the same intensity $I$: $B = \\int I \\cos\\phi\\, d\\omega = \\pi I$", {.size = kText + 4}, fonts);
    y += 1.15 * kTableRow;
    drawing::drawProse(drawing, {area.corner.x + columns[1], y}, "$\\phi$ = " + degreesText(way.phi), style, fonts);
    for (int i = 0; i < 3; ++i)
        drawing.text({area.corner.x + columns[2 + i], y},
                     std::array{"red", "green", "blue"}[static_cast<std::size_t>(i)],
                     {.size = kText, .anchor = drawing::Anchor::end, .color = "#4d4d4d"});
    for (const Row& row : rows) {
        y += kTableRow;
        drawing::drawProse(drawing, {area.corner.x + columns[0], y}, row.name, style, fonts);
        drawing.text({area.corner.x + columns[1], y}, row.meaning, style);
        for (int i = 0; i < 3; ++i)
            drawing.text({area.corner.x + columns[2 + i], y}, fourDigits(row.values[i]),
                         {.size = kText + 2, .anchor = drawing::Anchor::end});
        drawing.text({area.corner.x + columns[5], y}, row.unit, style);
    }
}

} // namespace

void drawReflector(drawing::Drawing& drawing, const drawing::Box& area, const PatchExchange& exchange, const dvec3& eyeWorld,
                   const image::Font& font) {
    drawing.text(area.corner + dvec2(0, kHeading), "Radiosity of a Lambertian reflector: surface j",
                 {.size = kHeading, .isBold = true});
    const Way way = shownWay(exchange, eyeWorld);
    const double top = 1.2 * kHeading;
    if (area.size.x < kReflectorWidth + kReflectorGap + kNumbersWidth) { // the numbers below
        const double numbers = kHeading + 8.6 * kTableRow;
        drawLobes(drawing, {area.corner + dvec2(0, top), {area.size.x, area.size.y - top - numbers}}, way, font);
        writeReflectorNumbers(drawing, {area.corner + dvec2(0, area.size.y - numbers), {area.size.x, numbers}},
                              exchange.j, way, font);
        return;
    }
    drawLobes(drawing, {area.corner + dvec2(0, 1.2 * kHeading), {kReflectorWidth, area.size.y - 1.2 * kHeading}}, way,
              font);
    writeReflectorNumbers(drawing,
                          {area.corner + dvec2(kReflectorWidth + kReflectorGap, 0),
                           {area.size.x - kReflectorWidth - kReflectorGap, area.size.y}},
                          exchange.j, way, font);
}

} // namespace shadowlab::figures
