// "Shadow map method": the eye's axes at P_0 and the light's at P_L, the shadow map across the light's frustum, and of the picked
// point w(u,v), d(u,v) and z(u,v). In the plane through eye, light and point.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/drawing/formula.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/inks.h"
#include "app/figures/map/eye_and_light_axes.h"
#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/map_probe.h"

namespace shadowlab::figures {

namespace {

using Cell = MapProbe::Cell;

constexpr double kLinesHeight = 122; ///< pixels; kLinesHeight: of the text under the drawing
constexpr double kAxisLength = 120,
                 kLeastAxis = 0.3; ///< pixels of a whole axis; shorter ones lie too nearly across the paper
constexpr double kBar = 30;        ///< pixels: thickness of the map
constexpr double kMeasureText = 28; ///< of what is compared: larger than other words
constexpr double kBarShare = 0.6, kPictureShare = 0.25; ///< of the way to the nearest thing, or to the point
constexpr double kBeside = 20;                           ///< pixels from a line to what is measured along it
constexpr const char *kEyeColor = ink::kEye, *kLightsColor = ink::kLight, *kStoredColor = ink::kLight,
                     *kComparedColor = ink::kAsked;

/// Depths as greys: near dark, far light, as a depth buffer is shown.
std::string shade(double share) {
    const int level = static_cast<int>(std::lround(40 + 190 * glm::clamp(share, 0.0, 1.0)));
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", level, level, level);
    return text;
}

class Cameras {
public:
    Cameras(const FigureSource& source, const drawing::Box& field)
        : map_(*source.probe.find<MapProbe>()), camera_(source.view.camera), size_(source.view.size), axes_(axesOf(map_)),
          sheet_(source.probe, source.scene, field, places(source.probe)), labels_(source.fonts(), field) {}

    void draw(drawing::Drawing& drawing) {
        drawFrustum(drawing);
        drawFans(drawing);
        sheet_.drawScene(drawing, labels_);
        drawBar(drawing);
        drawLines(drawing);
        drawAxes(drawing);
        drawPlaces(drawing);
    }

private:
    static std::vector<dvec2> places(const Probe& probe) {
        std::vector<dvec2> all;
        if (probe.find<MapProbe>()->blockerWorld) all.push_back(probe.section->of(*probe.find<MapProbe>()->blockerWorld));
        return all;
    }
    [[nodiscard]] dvec2 inPlane(const dvec3& directionWorld) const {
        return sheet_.section().ofDirection(directionWorld);
    }
    /// Directions on the sheet have y downward.
    static dvec2 down(dvec2 direction) { return {direction.x, -direction.y}; }

    /// The eye's frustum, and the picture plane across it.
    void drawFrustum(drawing::Drawing& drawing) {
        const auto wedge = viewWedge(camera_, size_, sheet_.section(), sheet_.eye());
        const dvec2 axis = inPlane(glm::normalize(camera_.targetWorld - camera_.positionWorld));
        const dvec2 eye = sheet_.eye(), toPoint = -glm::normalize(eye);
        const double depth = kPictureShare * glm::length(eye) * glm::dot(toPoint, axis);
        const auto onPicture = [&](dvec2 way) { return eye + way * (depth / glm::dot(way, axis)); };
        drawing.beginClip(sheet_.area().corner, sheet_.area().size);
        for (const dvec2& way : wedge) {
            const dvec2 end = sheet_.border(eye, way);
            drawing.line(sheet_(eye), end, {"#8c8c8c", 2, true});
            labels_.avoid(sheet_(eye), end);
        }
        drawing.endClip();
        picture_ = {sheet_(onPicture(wedge[0])), sheet_(onPicture(wedge[1]))};
        pixel_ = sheet_(onPicture(toPoint));
    }

    /// The light's rays through some texels, each up to what it meets; and the borders of its frustum.
    void drawFans(drawing::Drawing& drawing) {
        drawing.beginClip(sheet_.area().corner, sheet_.area().size);
        for (const Cell& cell : map_.across)
            if (!cell.isEmpty)
                drawing.line(sheet_(cell.rays[0]), sheet_(0.5 * (cell.stored[0] + cell.stored[1])),
                             {"#ecd08a", 1.5, false});
        if (!map_.across.empty()) {
            const Cell &first = map_.across.front(), &last = map_.across.back();
            for (const auto& [from, to] :
                 {std::pair(first.rays[0], first.compared[0]), std::pair(last.rays[1], last.compared[1])}) {
                const dvec2 end = sheet_.border(from, to - from);
                drawing.line(sheet_(from), end, {ink::kLight, 2, true});
                labels_.avoid(sheet_(from), end);
            }
        }
        drawing.endClip();
    }

    /// The map as a bar, from texel to texel as dark as what is stored there is near.
    void drawBar(drawing::Drawing& drawing) {
        if (map_.across.empty()) return;
        const dvec2 axis = inPlane(axes_.depthWorld);
        const auto way = [&](const Cell& cell) {
            return glm::normalize(0.5 * (cell.compared[0] + cell.compared[1]) - 0.5 * (cell.rays[0] + cell.rays[1]));
        };
        const auto depthOf = [&](const Cell& cell) {
            return glm::dot(0.5 * (cell.stored[0] + cell.stored[1]) - 0.5 * (cell.rays[0] + cell.rays[1]), axis);
        };
        double nearest = 1e300, farthest = -1e300;
        for (const Cell& cell : map_.across) {
            if (cell.isEmpty) continue;
            nearest = std::min(nearest, depthOf(cell));
            farthest = std::max(farthest, depthOf(cell));
        }
        if (nearest > farthest) nearest = farthest = glm::dot(-map_.across.front().rays[0], axis);
        const double at = kBarShare * nearest;
        const auto place = [&](const Cell& cell) {
            const dvec2 from = 0.5 * (cell.rays[0] + cell.rays[1]);
            return sheet_(from + way(cell) * (at / glm::dot(way(cell), axis)));
        };
        const dvec2 thick = kBar * glm::normalize(down(axis));
        std::vector<dvec2> middles;
        for (const Cell& cell : map_.across)
            middles.push_back(place(cell));
        for (std::size_t i = 0; i < middles.size(); ++i) {
            const dvec2 from = i > 0 ? 0.5 * (middles[i - 1] + middles[i]) : middles[i],
                        to = i + 1 < middles.size() ? 0.5 * (middles[i] + middles[i + 1]) : middles[i];
            const Cell& cell = map_.across[i];
            const std::string color =
                cell.isEmpty ? "#ffffff" : shade((depthOf(cell) - nearest) / std::max(farthest - nearest, 1e-9));
            drawing.path(std::array{from, to, to - thick, from - thick}, true, color, {color, 1, false});
        }
        bar_ = {middles.front(), middles.back()};
        barDepth_ = at;
        drawing.path(std::array{bar_[0], bar_[1], bar_[1] - thick, bar_[0] - thick}, true, "none",
                     {"#1a1a1a", 2.5, false});
        labels_.avoid(bar_[0], bar_[1]);
        labels_.avoid(bar_[0] - thick, bar_[1] - thick);
        labels_.place(drawing, bar_[0].x > bar_[1].x ? bar_[0] : bar_[1], "shadow map",
                      {.size = kMeasureText, .isBold = true, .color = kStoredColor}, 14);
    }

    /// Beside a line, as an engineer measures it.
    void measure(drawing::Drawing& drawing, dvec2 from, dvec2 to, double side, const std::string& text,
                 const std::string& color) {
        const dvec2 along = glm::normalize(to - from), across = side * kBeside * dvec2(-along.y, along.x);
        const dvec2 a = from + across, b = to + across;
        drawing.line(a, b, {color, 3.5, false});
        for (const dvec2& end : {a, b})
            drawing.line(end - 0.4 * across, end + 0.4 * across, {color, 3.5, false});
        labels_.avoid(a, b);
        labels_.place(drawing, glm::mix(a, b, 0.55) + 0.6 * across, text,
                      {.size = kMeasureText, .isBold = true, .color = color}, 12);
    }

    void drawLines(drawing::Drawing& drawing) {
        const dvec2 point = sheet_(dvec2(0.0));
        const dvec2 eye = sheet_.shows(sheet_.eye()) ? sheet_(sheet_.eye()) : sheet_.border(dvec2(0.0), sheet_.eye());
        const PlaneLight& light = sheet_.light();
        const bool lightIsSeen = !light.isDirection && sheet_.shows(light.at);
        const dvec2 from = lightIsSeen ? sheet_(light.at) : sheet_.border(dvec2(0.0), light.toward(dvec2(0.0)));
        const bool isLit = map_.compared <= map_.stored;
        drawing.line(from, point, {drawing::colorText(isLit ? look::kEqualDepth : look::kOccluded), 4, false});
        drawing.line(eye, point, {kEyeColor, 4, false});
        labels_.avoid(from, point);
        labels_.avoid(eye, point);
        drawing.line(picture_[0], picture_[1], {kEyeColor, 7, false});
        labels_.avoid(picture_[0], picture_[1]);
        if (barDepth_ > 0 && !light.isDirection) { // the texel that the point falls into
            const dvec2 way = -glm::normalize(light.at), axis = inPlane(axes_.depthWorld);
            const dvec2 texel =
                sheet_(light.at + way * (barDepth_ / glm::dot(way, axis))) - 0.5 * kBar * glm::normalize(down(axis));
            drawing.rectangle(texel - 9.0, dvec2(18), "none", {kStoredColor, 4, false});
        }
        drawing.rectangle(pixel_ - 9.0, dvec2(18), "#ffffff", {kEyeColor, 3.5, false});
        labels_.avoid({pixel_ - 10.0, dvec2(20)});
        // Which side of the light's line is away from the eye?
        const dvec2 ray = point - from;
        const double turn = ray.x * (eye.y - from.y) - ray.y * (eye.x - from.x), side = turn > 0 ? -1 : 1;
        const dvec2 start = light.isDirection || !lightIsSeen ? from : sheet_(light.at);
        measure(drawing, start, point, side, "$z(u,v) = $" + fourDigits(map_.pointMetres) + " m", kComparedColor);
        if (map_.blockerWorld) {
            const dvec2 blocker = sheet_(sheet_.section().of(*map_.blockerWorld));
            const dvec2 unit = glm::normalize(point - start);
            const dvec2 end = start + glm::dot(blocker - start, unit) * unit;
            measure(drawing, start, end, -side, "$d(u,v) = $" + fourDigits(map_.firstMetres) + " m", kStoredColor);
            drawing.circle(end, 8, kStoredColor, {"#ffffff", 2, false}, "blocker");
        }
        labels_.place(drawing, glm::mix(eye, point, 0.55), "$w(u,v) = $" + fourDigits(glm::length(sheet_.eye())) + " m",
                      {.size = kMeasureText, .isBold = true}, 12);
        labels_.place(drawing, picture_[0].y < picture_[1].y ? picture_[0] : picture_[1], "image $A$",
                      {.size = kMeasureText, .isBold = true}, 12);
    }

    /// z, and of the other two the one that lies less across the paper.
    void drawAxesAt(drawing::Drawing& drawing, dvec2 from, const dvec3& z, const dvec3& x, const dvec3& y,
                    const std::string& index, const std::string& color) {
        const bool isX = glm::length(inPlane(x)) >= glm::length(inPlane(y));
        drawing::TextStyle style{.size = drawing::kLetter, .isBold = true, .color = color};
        for (const auto& [axis, letter] : {std::pair(z, "z"), std::pair(isX ? x : y, isX ? "x" : "y")}) {
            const dvec2 way = down(inPlane(axis));
            if (glm::length(way) < kLeastAxis) continue;
            const dvec2 tip = from + kAxisLength * way;
            drawing.arrow(from, tip, {color, 5, false});
            labels_.avoid(from, tip);
            labels_.place(drawing, tip, drawing::LabelText{letter, index, ""}, style, 8);
        }
    }

    void drawAxes(drawing::Drawing& drawing) {
        const dmat4 viewFromWorld = scene::viewFromWorld(camera_);
        const dmat3 worldAxes = glm::transpose(dmat3(viewFromWorld)); // columns: right, up, backward
        if (sheet_.shows(sheet_.eye()))
            drawAxesAt(drawing, sheet_(sheet_.eye()), -worldAxes[2], worldAxes[0], worldAxes[1], "v", kEyeColor);
        if (!sheet_.light().isDirection && sheet_.shows(sheet_.light().at))
            drawAxesAt(drawing, sheet_(sheet_.light().at), axes_.depthWorld, axes_.acrossWorld, axes_.upWorld, "L",
                       kLightsColor);
    }

    void drawPlaces(drawing::Drawing& drawing) {
        const drawing::TextStyle letter{.size = drawing::kLetter, .isBold = true};
        const bool isLit = map_.compared <= map_.stored;
        const dvec2 point = sheet_(dvec2(0.0));
        drawing.circle(point, 9, "#1a1a1a", {"#ffffff", 2, false}, "point");
        labels_.avoid({point - 10.0, dvec2(20)});
        labels_.place(drawing, point, isLit ? "lit" : "shadowed", {.size = kMeasureText, .isBold = true}, 14);
        if (sheet_.shows(sheet_.eye())) {
            const dvec2 eye = sheet_(sheet_.eye());
            drawing.circle(eye, 11, "#ffffff", {"#1a1a1a", 4, false}, "eye");
            labels_.avoid({eye - 12.0, dvec2(24)});
            labels_.place(drawing, eye, "$\\mathbf{P}_0$ eye", letter, 14);
        } else {
            sheet_.drawEye(drawing, labels_);
        }
        if (!sheet_.light().isDirection && sheet_.shows(sheet_.light().at)) {
            const dvec2 light = sheet_(sheet_.light().at);
            drawing.circle(light, 13, drawing::colorText(look::kChosenLight), {"#1a1a1a", 3, false}, "light");
            labels_.avoid({light - 15.0, dvec2(30)});
            labels_.place(drawing, light, "$\\mathbf{P}_L$ light", letter, 18);
        } else {
            sheet_.drawLight(drawing, labels_);
        }
    }

    const MapProbe& map_;
    const scene::Camera& camera_;
    ivec2 size_;
    MapAxes axes_;
    SectionSheet sheet_;
    drawing::Labels labels_;
    std::array<dvec2, 2> picture_{}, bar_{};
    dvec2 pixel_{0.0};
    double barDepth_ = 0; ///< metres from the light to the bar, along z_L
};

} // namespace

Diagram drawCamerasFigure(const FigureSource& source) {
    const Probe& probe = source.probe;
    if (probe.geometry.empty()) throw Error(ExitStatus::badInput, "the pixel shows the background; choose another");
    if (!probe.find<MapProbe>() || !hasSection(probe))
        throw Error(ExitStatus::badInput, std::string(source.technique) +
                                              " asks no shadow map there; ask shadow-map, about a pixel in its light");
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kSectionBorder), source.size - 2 * kSectionBorder},
        field{area.corner, area.size - dvec2(0, kLinesHeight)};
    Cameras(source, field).draw(drawing);
    drawing.rectangle(field.corner, field.size, "none", {"#bfbfbf", 2, false});

    const MapProbe& map = *probe.find<MapProbe>();
    const bool isLit = map.compared <= map.stored;
    const dvec2 foot = area.corner + dvec2(0, field.size.y + 44);
    const drawing::FormulaFonts fonts = source.fonts();
    const drawing::Extent extent =
        drawing::Formula(isLit ? "d(u,v) \\ge z(u,v)" : "d(u,v) < z(u,v)").draw(drawing, foot, 36, "#1a1a1a", fonts);
    drawing.text(foot + dvec2(extent.width + 24, 0), isLit ? ": the point is lit" : ": the point is shadowed",
                 {.size = 36, .isBold = true});
    double y = foot.y;
    for (const std::string& line : source.font.wrap("Map: near dark, far light, white nothing. d and z are counted "
                                                    "along the light's z axis; both z axes point into the scene.",
                                                    kText, static_cast<int>(area.size.x)))
        drawing.text({foot.x, y += 34}, line, {.size = kText, .color = "#4d4d4d"});
    return {std::move(drawing),
            "The eye and the light source with their axes, the shadow map between the light and the "
            "scene, and the two depths of a point"};
}

} // namespace shadowlab::figures
