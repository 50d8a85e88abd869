// A chart of a few lines, as SVG; the errors by powers of ten.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace shadowlab {

struct PlotLine {
    std::string name, color;
    std::vector<double> y; ///< one for each place on the x axis
};

struct Plot {
    std::string xLabel, yLabel;
    std::vector<double> x;
    bool xByPowersOfTwo = false;
    std::vector<double> xMarks;
    int firstPower = -2, lastPower = 1; ///< of ten, on the y axis
    std::vector<PlotLine> lines;
};

inline std::string linePlot(const Plot& plot) {
    constexpr double kWidth = 640, kHeight = 400, kLeft = 80, kRight = 150, kTop = 20, kBottom = 55;
    std::string svg;
    const auto add = [&](const char* format, auto... values) {
        char text[400];
        std::snprintf(text, sizeof text, format, values...);
        svg += text;
    };
    const auto scaled = [&](double value) { return plot.xByPowersOfTwo ? std::log2(value) : value; };
    const double firstX = scaled(plot.x.front()), lastX = scaled(plot.x.back());
    const auto x = [&](double value) {
        return kLeft + (scaled(value) - firstX) / (lastX - firstX) * (kWidth - kLeft - kRight);
    };
    const auto y = [&](double value) {
        const double power = std::log10(value);
        return kHeight - kBottom -
               (power - plot.firstPower) / (plot.lastPower - plot.firstPower) * (kHeight - kTop - kBottom);
    };
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\" "
        "font-size=\"13\">\n",
        kWidth, kHeight);
    add("<rect width=\"%g\" height=\"%g\" fill=\"white\"/>\n", kWidth, kHeight);
    for (const double mark : plot.xMarks) {
        add("<path d=\"M%.1f %g V%g\" stroke=\"#ddd\"/>\n", x(mark), kTop, kHeight - kBottom);
        add("<text x=\"%.1f\" y=\"%g\" text-anchor=\"middle\">%.10g</text>\n", x(mark), kHeight - kBottom + 20, mark);
    }
    for (int power = plot.firstPower; power <= plot.lastPower; ++power) {
        const double value = std::pow(10, power);
        add("<path d=\"M%g %.1f H%g\" stroke=\"#ddd\"/>\n", kLeft, y(value), kWidth - kRight);
        add("<text x=\"%g\" y=\"%.1f\" text-anchor=\"end\">%.10g</text>\n", kLeft - 8, y(value) + 4, value);
    }
    add("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\">%s</text>\n", (kLeft + kWidth - kRight) / 2, kHeight - 12,
        plot.xLabel.c_str());
    add("<text transform=\"translate(22 %g) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
        (kTop + kHeight - kBottom) / 2, plot.yLabel.c_str());
    double label = kTop + 14;
    for (const PlotLine& line : plot.lines) {
        svg += "<path fill=\"none\" stroke-width=\"2.5\" stroke=\"" + line.color;
        for (std::size_t i = 0; i < plot.x.size(); ++i)
            add("%s%.1f %.1f", i == 0 ? "\" d=\"M" : " L", x(plot.x[i]), y(line.y[i]));
        add("\"/>\n<text x=\"%g\" y=\"%.1f\" fill=\"%s\">%s</text>\n", kWidth - kRight + 10, label, line.color.c_str(),
            line.name.c_str());
        label += 20;
    }
    return svg + "</svg>\n";
}

} // namespace shadowlab
