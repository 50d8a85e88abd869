// The numbers beside the figure of a form factor: what the lecture's formula says of the two centres, and what is true.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "app/drawing/prose.h"
#include "app/figures/panels.h"
#include "techniques/probed/patch_exchange.h"

namespace shadowlab::figures {

namespace {

constexpr double kNumbersRow = 37; ///< pixels from one line of numbers to the next

/// Lines of numbers beside the figure.
class Column {
public:
    Column(drawing::Drawing& drawing, const drawing::Box& area, const image::Font& font) : svg_(drawing), font_(font), area_(area) {}

    void heading(const std::string& text) {
        y_ += y_ > 0 ? kNumbersRow + 16 : kHeading;
        write(0, text, {.size = kHeading, .isBold = true});
    }
    void row(const std::string& name, const std::string& value) {
        y_ += kNumbersRow;
        write(0, name, {.size = kText + 2});
        if (!value.empty()) write(kValues, value, {.size = kText + 2});
    }
    void row(const std::string& name, const dvec3& values, const std::string& unit) {
        row(name, "");
        for (int i = 0; i < 3; ++i)
            write(kValues + kColor * i, fourDigits(values[i]), {.size = kText + 2});
        write(kValues + kColor * 3, unit, {.size = kText + 2});
    }
    /// What the lecture's formula is for small pieces.
    void formula(const std::string& value) {
        y_ += 1.6 * kNumbersRow;
        write(0, "$F_{jk} = \\frac{\\cos\\phi_j \\cos\\phi_k}{\\pi r^2}\\, dA_k$ = " + value, {.size = kText + 4});
        y_ += 0.4 * kNumbersRow;
    }

private:
    static constexpr double kValues = 130,
                            kColor = 170; ///< pixels from the left where values begin, and from one to the next
    void write(double x, const std::string& text, const drawing::TextStyle& style) {
        const drawing::FormulaFonts fonts{font_, font_};
        std::vector<drawing::ProseLine> lines = drawing::wrapProse(text, style.size, area_.size.x - x - style.size, style.isBold, fonts);
        if (lines.size() > 1) lines.front().pieces.push_back({"\u2026", false});
        drawing::drawProse(svg_, area_.corner + dvec2(x, y_), lines.front(), style, fonts);
    }
    drawing::Drawing& svg_;
    const image::Font& font_;
    drawing::Box area_;
    double y_ = 0;
};

} // namespace

void writeFormFactor(drawing::Drawing& drawing, const drawing::Box& area, const PatchExchange& exchange, const image::Font& font) {
    const PatchProbe &j = exchange.j, &k = *exchange.k;
    const dvec3 way = k.centreWorld - j.centreWorld;
    const double r = glm::length(way);
    const double cosJ = std::max(0.0, glm::dot(j.normalWorld, way) / r);
    const double cosK = std::max(0.0, -glm::dot(k.normalWorld, way) / r);
    Column column(drawing, area, font);
    column.heading("Two pieces of surface");
    column.row("j is of", j.object);
    column.row("k is of", k.object);
    column.heading("If all of j and k were at their centres");
    column.formula(fourDigits(cosJ * cosK / (glm::pi<double>() * r * r) * k.area));
    column.heading("In full, with what stands in between");
    column.row("$F_{jk}$", fourDigits(exchange.formFactorJk) + "  of the light of j reaches k");
    column.row("$F_{kj}$", fourDigits(exchange.formFactorKj) + "  of the light of k reaches j");
    column.row("$dA_j F_{jk}$",
               fourDigits(j.area * exchange.formFactorJk) + " m\u00b2 = $dA_k F_{kj}$");
    column.heading("What j gets from k: red, green, blue");
    column.row("$B_k$", k.radiosity, "W/m\u00b2");
    column.row("$F_{jk} B_k$", exchange.formFactorJk * k.radiosity, "W/m\u00b2");
}

} // namespace shadowlab::figures
