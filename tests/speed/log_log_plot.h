// A chart of lines and points, both axes logarithmic, as SVG.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace shadowlab {

struct LogLogLine {
    std::string name; ///< in the legend; empty: not in it
    std::string color;
    std::vector<double> x, y;
    bool isDashed = false;
};

struct LogLogPlot {
    std::string xLabel, yLabel;
    double firstX = 1, lastX = 10;
    std::vector<double> xMarks;         ///< where vertical lines stand, with their numbers
    int firstPower = -2, lastPower = 0; ///< of ten, on the y axis; what is below is cut off
    std::vector<LogLogLine> lines;
    std::string remark; ///< under the legend
};

inline std::string logLogPlot(const LogLogPlot& plot) {
    constexpr double kWidth = 680, kHeight = 400, kLeft = 80, kRight = 190, kTop = 20, kBottom = 55;
    std::string svg;
    const auto add = [&](const char* format, auto... values) {
        char text[400];
        std::snprintf(text, sizeof text, format, values...);
        svg += text;
    };
    const auto x = [&](double value) {
        return kLeft + std::log(value / plot.firstX) / std::log(plot.lastX / plot.firstX) * (kWidth - kLeft - kRight);
    };
    const auto y = [&](double value) {
        const double power = std::max(std::log10(value), static_cast<double>(plot.firstPower));
        return kHeight - kBottom -
               (power - plot.firstPower) / (plot.lastPower - plot.firstPower) * (kHeight - kTop - kBottom);
    };
    const auto power = [&](double atX, double atY, const char* anchor, int exponent) {
        add("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">10<tspan dy=\"-5\" font-size=\"10\">%d</tspan></text>\n",
            atX, atY, anchor, exponent);
    };
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\" "
        "font-size=\"13\">\n",
        kWidth, kHeight);
    add("<rect width=\"%g\" height=\"%g\" fill=\"white\"/>\n", kWidth, kHeight);
    for (const double mark : plot.xMarks) {
        add("<path d=\"M%.1f %g V%g\" stroke=\"#ddd\"/>\n", x(mark), kTop, kHeight - kBottom);
        add("<text x=\"%.1f\" y=\"%g\" text-anchor=\"middle\">%.10g</text>\n", x(mark), kHeight - kBottom + 20, mark);
    }
    for (int exponent = plot.firstPower; exponent <= plot.lastPower; ++exponent) {
        const double at = y(std::pow(10, exponent));
        add("<path d=\"M%g %.1f H%g\" stroke=\"#ddd\"/>\n", kLeft, at, kWidth - kRight);
        power(kLeft - 8, at + 4, "end", exponent);
    }
    add("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\">%s</text>\n", (kLeft + kWidth - kRight) / 2, kHeight - 12,
        plot.xLabel.c_str());
    add("<text transform=\"translate(22 %g) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
        (kTop + kHeight - kBottom) / 2, plot.yLabel.c_str());
    double label = kTop + 14;
    const auto legend = [&](const std::string& text, const std::string& color) {
        add("<text x=\"%g\" y=\"%.1f\" fill=\"%s\">%s</text>\n", kWidth - kRight + 10, label, color.c_str(),
            text.c_str());
        label += 20;
    };
    for (const LogLogLine& line : plot.lines) {
        constexpr std::size_t kMostDots = 12; // of a line of more points they would hide the line
        if (line.x.size() > 1) {
            svg += "<path fill=\"none\" stroke=\"" + line.color +
                   (line.isDashed ? "\" stroke-width=\"1.5\" stroke-dasharray=\"5 4" : "\" stroke-width=\"2.5");
            for (std::size_t i = 0; i < line.x.size(); ++i)
                add("%s%.1f %.1f", i == 0 ? "\" d=\"M" : " L", x(line.x[i]), y(line.y[i]));
            svg += "\"/>\n";
        }
        for (std::size_t i = 0; i < line.x.size() && line.x.size() <= kMostDots; ++i)
            add("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%d\" fill=\"%s\"/>\n", x(line.x[i]), y(line.y[i]),
                line.x.size() == 1 ? 6 : 4, line.color.c_str());
        if (!line.name.empty()) legend(line.name, line.color);
    }
    if (!plot.remark.empty()) legend(plot.remark, "#555");
    return svg + "</svg>\n";
}

} // namespace shadowlab
