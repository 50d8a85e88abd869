// "Jittering": the pixel with its subpixels, where the ray of each passes, and the mean of what they bring.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "techniques/probed/rays_probe.h"

namespace shadowlab::figures {

namespace {

constexpr double kColumn = 290, kColumnGap = 36, kSwatch = 120; ///< pixels
constexpr double kLeastArrow = 10;                              ///< shorter ones would be nothing but a head
constexpr std::size_t kMostArrows = 64;                         ///< more subpixels are too small for them

const drawing::Stroke kEdge{"#1a1a1a", 4, false}, kInner{"#8c8c8c", 2, false}, kWay{"#1a1a1a", 2.5, false};

void drawSample(drawing::Drawing& drawing, const RaysProbe::Sample& sample, dvec2 corner, double side, double radius,
                bool hasArrow, double exposure) {
    const dvec2 at = corner + side * sample.place;
    if (sample.subpixel && hasArrow) {
        const dvec2 centre = corner + side * 0.5 * ((*sample.subpixel)[0] + (*sample.subpixel)[1]), way = at - centre;
        drawing.line(centre - dvec2(6, 0), centre + dvec2(6, 0), {"#1a1a1a", 2, false});
        drawing.line(centre - dvec2(0, 6), centre + dvec2(0, 6), {"#1a1a1a", 2, false});
        const double length = glm::length(way);
        if (length > kLeastArrow + radius) drawing.arrow(centre, at - radius / length * way, kWay);
    }
    drawing.circle(at, radius, shownColor(sample.intensity, exposure), {"#1a1a1a", 3, false}, "sample");
}

void drawSwatch(drawing::Drawing& drawing, dvec2 corner, const dvec3& intensity, double exposure, const std::string& first,
                const std::string& second, const char* name) {
    drawing.rectangle(corner, dvec2(kSwatch), shownColor(intensity, exposure), {"#1a1a1a", 3, false});
    const dvec2 text = corner + dvec2(0, kSwatch + 1.3 * kText);
    drawing.text(text, first, {.size = kText, .isBold = true});
    drawing.text(text + dvec2(0, 1.25 * kText), second, {.size = kText});
    drawing.text(text + dvec2(0, 2.5 * kText), name + colorNumbers(intensity), {.size = kText});
}

} // namespace

Diagram drawJitter(const FigureSource& source) {
    const RaysProbe& rays = samplesOf(source);
    drawing::Drawing drawing(source.size);
    const bool hasSubpixels = rays.samples.front().subpixel.has_value();
    const bool hasArrows = hasSubpixels && rays.samples.size() <= kMostArrows;
    std::string foot = hasArrows      ? "Cross: centre of a subpixel. Arrow: its displacement. "
                       : hasSubpixels ? "One ray through each subpixel. "
                                      : "This pattern has no subpixels. ";
    foot += "Disc: where the subpixel ray passes, in the colour that it brings.";
    if (rays.count > static_cast<int>(rays.samples.size()))
        foot +=
            " Shown are the first " + std::to_string(rays.samples.size()) + " of " + std::to_string(rays.count) + ".";
    const drawing::Box room = writeFoot(drawing, roomOf(source), foot, source.font);

    const double heading = 1.9 * kText;
    const double side = std::min(room.size.x - kColumn - kColumnGap, room.size.y - heading);
    const dvec2 corner = room.corner + dvec2(0.5 * (room.size.x - side - kColumnGap - kColumn),
                                             heading + 0.5 * (room.size.y - heading - side));
    drawing.text(corner - dvec2(0, 0.9 * kText),
                 "One pixel, divided into " +
                     (hasSubpixels ? counted(static_cast<std::size_t>(rays.count), "subpixel", "subpixels")
                                   : std::string("nothing")),
                 {.size = kText, .isBold = true});
    const double exposure = static_cast<double>(source.scene.exposure);
    for (const RaysProbe::Sample& sample : rays.samples)
        if (sample.subpixel)
            drawing.rectangle(corner + side * (*sample.subpixel)[0],
                              side * ((*sample.subpixel)[1] - (*sample.subpixel)[0]), "#ffffff", kInner);
    drawing.rectangle(corner, dvec2(side), "", kEdge);
    const double radius = std::clamp(0.09 * side / std::sqrt(static_cast<double>(rays.samples.size())), 5.0, 22.0);
    for (const RaysProbe::Sample& sample : rays.samples)
        drawSample(drawing, sample, corner, side, radius, hasArrows, exposure);

    const dvec2 column = corner + dvec2(side + kColumnGap, 0);
    drawSwatch(drawing, column, rays.mean(), exposure, "pixel intensity",
               "mean of " + counted(rays.samples.size(), "ray", "rays"), "I = ");
    if (!source.probe.tree.empty())
        drawSwatch(drawing, column + dvec2(0, kSwatch + 5.5 * kText), source.probe.tree.front().intensity, exposure,
                   "for comparison", "one ray, pixel centre", "I = ");
    return {std::move(drawing),
            "A pixel with its subpixels, the place in each that a ray passes through, and the mean of "
            "what the rays bring"};
}

} // namespace shadowlab::figures
