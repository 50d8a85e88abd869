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

constexpr double kMostSize = 46;                  ///< em of the equations, where there is room for it
constexpr double kAboveLine = 20, kNoteRow = 34; ///< pixels between a heading and its equation; of the words under its columns
constexpr double kBetweenPieces = 0.25;          ///< em
constexpr double kFill = 0.99;                   ///< of the width: letters are measured in whole pixels
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

/// A part of an equation, and what is written under it: empty for nothing.
struct Piece {
    std::string tex, below;
};
struct Line {
    std::string heading;
    std::vector<Piece> pieces;
};

drawing::Extent measured(const Line& line, double em, const drawing::FormulaFonts& fonts) {
    drawing::Extent whole;
    for (const Piece& piece : line.pieces) {
        const drawing::Extent extent = drawing::Formula(piece.tex).measure(em, fonts);
        whole.width += extent.width + (whole.width > 0 ? kBetweenPieces * em : 0);
        whole.above = std::max(whole.above, extent.above);
        whole.below = std::max(whole.below, extent.below);
    }
    return whole;
}

/// `below`: pixels that the line takes under its foot, where the words begin.
void drawLine(drawing::Drawing& drawing, const Line& line, dvec2 place, double below, double em,
              const drawing::FormulaFonts& fonts) {
    for (const Piece& piece : line.pieces) {
        const drawing::Extent extent = drawing::Formula(piece.tex).draw(drawing, place, em, kInk, fonts);
        if (!piece.below.empty())
            drawing.text(place + dvec2(0.5 * extent.width, below + 1.1 * kText), piece.below,
                         {.size = kText, .anchor = drawing::Anchor::middle, .isBold = true});
        place.x += extent.width + kBetweenPieces * em;
    }
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
                  "E: what a patch emits, and what it reflects of light sources that are no patches. From others: what it "
                  "reflects of all patches that are not written here. W/m\u00b2, " +
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
    const drawing::FormulaFonts fonts = source.fonts();
    const std::vector<Line> lines = {
        {"n equations, n unknown radiosities", {{symbols(), ""}}},
        {"Some of them with the numbers of this scene, and the solution",
         {{matrix(rows), ""},
          {matrix(unknowns), ""},
          {"=", ""},
          {matrix(own), "E"},
          {"+", ""},
          {matrix(others), "from others"},
          {", \\quad " + matrix(unknowns) + " =", ""},
          {matrix(solution), "solution"}}}};
    double needed = 0;
    std::vector<double> sizes;
    for (const Line& line : lines) {
        // As large as its width and its half of the room allow.
        const drawing::Extent wide = measured(line, kMostSize, fonts);
        const double half = 0.5 * room.size.y - kHeading - kAboveLine - kNoteRow;
        sizes.push_back(std::max(kText, kMostSize * std::min({1.0, kFill * room.size.x / wide.width,
                                                              half / (wide.above + wide.below)})));
        const drawing::Extent extent = measured(line, sizes.back(), fonts);
        if (extent.width > room.size.x)
            throw Error(ExitStatus::badInput,
                        "the equations need the whole slide to be read; leave out what stands beside them");
        needed += extent.above + extent.below + kHeading + kAboveLine + kNoteRow;
    }
    const double gap = std::max(0.0, (room.size.y - needed) / 3);
    double y = room.corner.y;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const drawing::Extent extent = measured(lines[i], sizes[i], fonts);
        y += gap / 2;
        drawing.text({room.corner.x, y + kHeading}, lines[i].heading, {.size = kHeading, .isBold = true});
        y += kHeading + kAboveLine + extent.above;
        drawLine(drawing, lines[i], {room.corner.x, y}, extent.below, sizes[i], fonts);
        y += extent.below + kNoteRow + gap / 2;
    }
    return {std::move(drawing),
            "The radiosity equations in matrix form, with some of this scene's numbers and the solution"};
}

} // namespace shadowlab::figures
