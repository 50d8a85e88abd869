// "The radiosity equations" in matrix form: as symbols, and some of their rows with the numbers of this scene.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/drawing/formula.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/probed/patch_exchange.h"
#include "techniques/probed/radiosity_equations.h"

namespace shadowlab::figures {

namespace {

constexpr double kSymbols = 32, kNumbers = 32; ///< em
const char* const kInk = "#1a1a1a";
const char* const kNames[] = {"red", "green", "blue"};

std::string joined(const std::vector<std::string>& parts, const char* between) {
    std::string text;
    for (const std::string& part : parts)
        text += (text.empty() ? "" : between) + part;
    return text;
}
std::string matrix(const std::vector<std::string>& rows) {
    return "\\begin{bmatrix} " + joined(rows, " \\\\ ") + " \\end{bmatrix}";
}

std::string symbols() {
    const auto entry = [](const char* i, const char* k) {
        const std::string product = std::string("\\rho_") + i + " F_{" + i + k + "}";
        return std::string(i) == k ? "1 - " + product : "-" + product;
    };
    std::vector<std::string> rows;
    for (const char* i : {"1", "2", "n"}) {
        if (std::string(i) == "n") rows.emplace_back("\\vdots & \\vdots & \\ddots & \\vdots");
        rows.push_back(entry(i, "1") + " & " + entry(i, "2") + " & \\cdots & " + entry(i, "n"));
    }
    const auto column = [](const std::string& letter) {
        return matrix({letter + "_1", letter + "_2", "\\vdots", letter + "_n"});
    };
    return matrix(rows) + " " + column("B") + " = " + column("E");
}

/// "0.0123", "-0.5", "17.2": as many digits as distinguish an entry from its neighbours in the row.
std::string entryText(double value) {
    std::array<char, 64> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                            std::chars_format::fixed, std::abs(value) >= 10 ? 1 : 4);
    if (error != std::errc{}) return "?";
    std::string text(digits.data(), end);
    while (text.ends_with('0'))
        text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string numbered(const char* letter, std::uint32_t i) {
    return std::string(letter) + "_{" + std::to_string(i) + "}";
}

} // namespace

Diagram drawEquations(const FigureSource& source) {
    eyeRayOf(source);
    if (source.technique != "radiosity")
        throw Error(ExitStatus::badInput, std::string(source.technique) + " solves no equations; ask radiosity");
    if (!source.probe.find<RadiosityEquations>())
        throw Error(ExitStatus::badInput, "the patch at the pixel exchanges light with no other; choose another");
    const RadiosityEquations& equations = *source.probe.find<RadiosityEquations>();
    // The colour that is strongest in what the first patch sends: the numbers of the others are like it.
    const dvec3& of = source.probe.find<PatchExchange>()->j.radiosity;
    const int channel = of.r >= of.g && of.r >= of.b ? 0 : of.g >= of.b ? 1 : 2;
    drawing::Drawing drawing(source.size);
    const std::string n = std::to_string(equations.count);
    const drawing::Box room =
        writeFoot(drawing, roomOf(source),
                  "First column on the right: E, what a patch emits, and what it reflects of light sources that are no "
                  "patches. Second: what it reflects of all other patches. W/m\u00b2, " +
                      std::string(kNames[channel]) + "; n = " + n + ".",
                  source.font);
    std::vector<std::string> rows, unknowns, own, others, solution;
    for (std::size_t i = 0; i < equations.patches.size(); ++i) {
        const double rho = equations.reflectance[i][channel];
        std::vector<std::string> entries;
        for (std::size_t k = 0; k < equations.patches.size(); ++k)
            entries.push_back(entryText((i == k ? 1.0 : 0.0) - rho * equations.formFactors[i][k]));
        rows.push_back(joined(entries, " & "));
        unknowns.push_back(numbered("B", equations.patches[i]));
        own.push_back(entryText(equations.emission[i][channel]));
        others.push_back(entryText(rho * equations.fromOthers[i][channel]));
        solution.push_back(entryText(equations.radiosity[i][channel]));
    }
    const drawing::FormulaFonts fonts{source.font, source.font}; // no vectors in bold are in it
    struct Part {
        std::string heading;
        drawing::Formula formula;
        double em;
    };
    Part parts[] = {{"n equations, n unknown radiosities", drawing::Formula(symbols()), kSymbols},
                    {"Some of them with the numbers of this scene, and the solution",
                     drawing::Formula(matrix(rows) + " " + matrix(unknowns) + " = " + matrix(own) + " + " + matrix(others) +
                             " , \\quad " + matrix(unknowns) + " = " + matrix(solution)),
                     kNumbers}};
    double needed = 0;
    for (Part& part : parts) {
        const drawing::Extent wide = part.formula.measure(part.em, fonts);
        part.em = std::max(kText, part.em * std::min(1.0, room.size.x / wide.width));
        const drawing::Extent extent = part.formula.measure(part.em, fonts);
        if (extent.width > room.size.x)
            throw Error(ExitStatus::badInput,
                        "the equations need the whole slide to be read; leave out what stands beside them");
        needed += extent.above + extent.below + kHeading + 20;
    }
    const double gap = std::max(0.0, (room.size.y - needed) / 3);
    double y = room.corner.y;
    for (const Part& part : parts) {
        const drawing::Extent extent = part.formula.measure(part.em, fonts);
        y += gap / 2;
        drawing.text({room.corner.x, y + kHeading}, part.heading, {.size = kHeading, .isBold = true});
        y += kHeading + 20 + extent.above;
        part.formula.draw(drawing, {room.corner.x + 0.5 * (room.size.x - extent.width), y}, part.em, kInk, fonts);
        y += extent.below + gap / 2;
    }
    return {std::move(drawing),
            "The radiosity equations in matrix form, with some of this scene's numbers and the solution"};
}

} // namespace shadowlab::figures
