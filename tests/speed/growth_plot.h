// A chart of times against sizes, both by powers of ten, as SVG.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace shadowlab {

/// Of one size of mesh, in milliseconds: see the table that silhouette_bench prints.
struct Times {
    double triangles = 0, read = 0, build = 0, creep = 0, plain = 0;
};

inline std::string growthPlot(const std::vector<Times>& growth) {
    constexpr double kWidth = 570, kHeight = 380, kLeft = 80, kRight = 90, kTop = 20, kBottom = 50;
    constexpr double kFirstX = 3, kLastX = 6, kFirstY = -3, kLastY = 2; // powers of ten: triangles, milliseconds
    std::string svg;
    const auto add = [&](const char* format, auto... values) {
        char text[400];
        std::snprintf(text, sizeof(text), format, values...);
        svg += text;
    };
    const auto x = [&](double triangles) {
        return kLeft + (std::log10(triangles) - kFirstX) / (kLastX - kFirstX) * (kWidth - kLeft - kRight);
    };
    const auto y = [&](double ms) {
        return kHeight - kBottom - (std::log10(ms) - kFirstY) / (kLastY - kFirstY) * (kHeight - kTop - kBottom);
    };
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\" "
        "font-size=\"13\">\n",
        kWidth, kHeight);
    add("<rect width=\"%g\" height=\"%g\" fill=\"white\"/>\n", kWidth, kHeight);
    for (double power = kFirstX; power <= kLastX; ++power) {
        const double at = x(std::pow(10, power));
        add("<path d=\"M%.1f %g V%g\" stroke=\"#ddd\"/>\n", at, kTop, kHeight - kBottom);
        add("<text x=\"%.1f\" y=\"%g\" text-anchor=\"middle\">10<tspan dy=\"-5\" font-size=\"9\">%g</tspan></text>\n",
            at, kHeight - kBottom + 20, power);
    }
    for (double power = kFirstY; power <= kLastY; ++power) {
        const double at = y(std::pow(10, power));
        add("<path d=\"M%g %.1f H%g\" stroke=\"#ddd\"/>\n", kLeft, at, kWidth - kRight);
        add("<text x=\"%g\" y=\"%.1f\" text-anchor=\"end\">%g ms</text>\n", kLeft - 8, at + 4, std::pow(10, power));
    }
    add("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\">triangles</text>\n", (kLeft + kWidth - kRight) / 2,
        kHeight - 10);
    struct Line {
        const char *name, *color;
        double Times::*ms;
        double lower; ///< the name, where two lines end in one place
    };
    for (const Line& line : std::array<Line, 4>{{{"plain", "#cc79a7", &Times::plain, 0},
                                                 {"build", "#d55e00", &Times::build, -4},
                                                 {"creep", "#0072b2", &Times::creep, 10},
                                                 {"read", "#555555", &Times::read, 0}}}) {
        svg += "<path fill=\"none\" stroke-width=\"2\" stroke=\"";
        svg += line.color;
        for (std::size_t i = 0; i < growth.size(); ++i)
            add("%s%.1f %.1f", i == 0 ? "\" d=\"M" : " L", x(growth[i].triangles), y(growth[i].*line.ms));
        add("\"/>\n<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\">%s</text>\n", x(growth.back().triangles) + 8,
            y(growth.back().*line.ms) + 4 + line.lower, line.color, line.name);
    }
    return svg + "</svg>\n";
}

} // namespace shadowlab
