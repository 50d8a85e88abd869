// SPDX-License-Identifier: MIT
#include "app/figures/section_sheet.h"

#include <algorithm>
#include <cmath>

#include "app/figures/inks.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "techniques/probed/map_probe.h"
#include "techniques/probed/plane_probe.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

// The eye and the light are drawn where they are, unless one of them is so many times as far away as all else.
constexpr double kFarTimes = 4;
constexpr double kSheetMargin = 46; ///< pixels around what is drawn, for its signs

} // namespace

bool hasSection(const Probe& probe) {
    return probe.section && probe.geometry.size() >= 2 && (probe.find<VolumeProbe>() || probe.find<MapProbe>() || probe.find<PlaneProbe>());
}

void SectionSheet::findPlaces(const Probe& probe) {
    section_ = *probe.section;
    eye_ = section_.of(probe.geometry[0].fromWorld);
    const Probe::Segment& toLight = probe.geometry[1];
    light_.isDirection = toLight.isEndless;
    light_.at = section_.of(toLight.toWorld);
    if (light_.isDirection) light_.at = glm::normalize(section_.ofDirection(toLight.toWorld - toLight.fromWorld));
    for (const scene::Light& light : scene_.lights) {
        const dvec4 at = scene::homogeneousPositionWorld(light);
        const bool same = at.w == 0
                              ? light_.isDirection && glm::length(section_.ofDirection(dvec3(at)) - light_.at) < 1e-9
                              : dvec3(at) == toLight.toWorld;
        if (same && lightName_.empty()) lightName_ = light.name;
    }
}

SectionSheet::SectionSheet(const Probe& probe, const scene::Scene& scene, const drawing::Box& area,
                           std::span<const dvec2> places, double mostScale, bool hasEye)
    : scene_(scene), area_(area) {
    findPlaces(probe);
    // The point is the origin, so lengths are distances from it.
    const double eyeAway = glm::length(eye_), lightAway = light_.isDirection ? 0 : glm::length(light_.at);
    const scene::Bounds things = scene::thingsBounds(scene);
    const double size = things.isEmpty() ? 0 : glm::length(things.upperWorld - things.lowerWorld);
    std::vector<dvec2> all{dvec2(0.0)};
    const bool showsLight = !light_.isDirection && lightAway <= kFarTimes * std::max(size, eyeAway);
    const bool showsEye = hasEye && eyeAway <= kFarTimes * std::max(size, showsLight ? lightAway : 0);
    if (showsEye) all.push_back(eye_);
    if (showsLight) all.push_back(light_.at);
    const double reach = showsEye ? eyeAway : showsLight ? lightAway : size;
    for (const dvec2& place : places)
        if (glm::length(place) <= kFarTimes * reach) all.push_back(place);
    // What stands near by, but not the ground that it stands on.
    scene::Scene near = scene;
    std::erase_if(near.objects, [&](const scene::Object& object) {
        const scene::Bounds box = scene::boundsWorld(object);
        return !object.castsShadow || glm::length(box.upperWorld - box.lowerWorld) > reach;
    });
    for (const dvec2& place : cut(near, {section_.originWorld, section_.rightWorld, section_.upWorld}))
        if (glm::length(place) <= reach) all.push_back(place);
    // Some of a way toward what is far away or nowhere, and behind the point, where the line goes on.
    all.push_back(0.45 * reach * light_.toward(dvec2(0.0)));
    for (const double share : {0.3, -0.2})
        if (hasEye) all.push_back(share * reach * glm::normalize(eye_));
    fit(all, mostScale);
}

SectionSheet::SectionSheet(const Probe& probe, const scene::Scene& scene, const drawing::Box& area, double reach)
    : scene_(scene), area_(area) {
    findPlaces(probe);
    // As wide as that; what the area has less of height is cut off.
    const dvec2 shown = reach * glm::min(dvec2(1.0), area.size / area.size.x);
    fit({-shown, shown});
}

void SectionSheet::fit(const std::vector<dvec2>& places, double mostScale) {
    dvec2 low(1e300), high(-1e300);
    for (const dvec2& place : places) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const dvec2 extent = glm::max(high - low, dvec2(1e-12));
    const dvec2 room = area_.size - 2 * kSheetMargin;
    scale_ = std::min({room.x / extent.x, room.y / extent.y, mostScale});
    middle_ = 0.5 * (low + high);
    centre_ = area_.corner + 0.5 * area_.size;
    if (!std::isfinite(mostScale)) return;
    // Upward is downward on the sheet.
    const dvec2 spare = room / scale_ - extent;
    middle_ += 0.5 * dvec2(spare.x, -spare.y);
}

drawing::Box SectionSheet::metres() const {
    const dvec2 size = area_.size / scale_;
    return {middle_ - 0.5 * size, size};
}

bool SectionSheet::shows(dvec2 place) const {
    const dvec2 from = (*this)(place)-area_.corner;
    return from.x >= 0 && from.y >= 0 && from.x <= area_.size.x && from.y <= area_.size.y;
}

dvec2 SectionSheet::border(dvec2 from, dvec2 direction) const {
    const dvec2 at = (*this)(from), way = glm::normalize(dvec2(direction.x, -direction.y));
    double stretch = 1e300;
    for (int axis = 0; axis < 2; ++axis) {
        const double wall = area_.corner[axis] + (way[axis] > 0 ? area_.size[axis] : 0);
        if (way[axis] != 0) stretch = std::min(stretch, (wall - at[axis]) / way[axis]);
    }
    return at + std::max(stretch, 0.0) * way;
}

void SectionSheet::drawScene(drawing::Drawing& drawing, drawing::Labels& labels) const {
    const DrawingPlane plane{section_.originWorld, section_.rightWorld, section_.upWorld};
    drawing.beginClip(area_.corner, area_.size);
    for (const bool casts : {false, true}) {
        scene::Scene part = scene_;
        std::erase_if(part.objects, [&](const scene::Object& object) { return object.castsShadow != casts; });
        std::vector<dvec2> points = cut(part, plane), seen;
        for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
            const dvec2 a = (*this)(points[i]), b = (*this)(points[i + 1]);
            if (!area_.overlaps({glm::min(a, b) - 1.0, glm::abs(a - b) + 2.0})) continue;
            seen.insert(seen.end(), {a, b});
            labels.avoid(a, b);
        }
        drawing.segments(seen, {casts ? "#4d4d4d" : "#a6a6a6", 4, false});
    }
    drawing.endClip();
}

void SectionSheet::drawLines(drawing::Drawing& drawing, drawing::Labels& labels, const std::string& lightColor, double arrowAt) const {
    const dvec2 point = (*this)(dvec2(0.0));
    const bool lightIsSeen = !light_.isDirection && shows(light_.at);
    const dvec2 lightEnd = lightIsSeen ? (*this)(light_.at) : border(dvec2(0.0), light_.toward(dvec2(0.0)));
    drawing.arrow(lightEnd, point, {lightColor, 4, false}, arrowAt);
    labels.avoid(lightEnd, point);
    const dvec2 eyeEnd = shows(eye_) ? (*this)(eye_) : border(dvec2(0.0), eye_);
    drawing.line(eyeEnd, point, {"#1a1a1a", 3, false});
    labels.avoid(eyeEnd, point);
    drawPoint(drawing, labels);
    drawEye(drawing, labels);
    drawLight(drawing, labels);
}

void SectionSheet::drawAway(drawing::Drawing& drawing, drawing::Labels& labels, dvec2 direction, const std::string& text,
                            const std::string& color) const {
    const dvec2 tip = border(dvec2(0.0), direction), way = glm::normalize(tip - (*this)(dvec2(0.0)));
    const dvec2 from = tip - 70.0 * way;
    drawing.arrow(from, tip - 4.0 * way, {color, 4, false});
    drawing.breakMark(tip - 50.0 * way, way, {color, 3, false});
    labels.avoid({glm::min(from, tip), glm::abs(tip - from) + 1.0});
    labels.place(drawing, tip - 40.0 * way, text, {kText}, 16);
}

void SectionSheet::drawEye(drawing::Drawing& drawing, drawing::Labels& labels) const {
    if (!shows(eye_)) {
        drawAway(drawing, labels, eye_, "eye, " + fourDigits(glm::length(eye_)) + " m away", "#1a1a1a");
        return;
    }
    const dvec2 at = (*this)(eye_);
    drawing.circle(at, 10, "#ffffff", {"#1a1a1a", 4, false}, "eye");
    labels.avoid({at - 12.0, dvec2(24)});
    labels.place(drawing, at, "eye", {.size = kText, .isBold = true}, 14);
}

void SectionSheet::drawLight(drawing::Drawing& drawing, drawing::Labels& labels) const {
    // Of a single light the name tells nothing.
    const std::string name = lightName_.empty() || scene_.lights.size() == 1 ? "light source" : "light " + lightName_;
    if (light_.isDirection || !shows(light_.at)) {
        const std::string away = light_.isDirection ? "to the " + name + ", at infinity"
                                                    : name + ", " + fourDigits(glm::length(light_.at)) + " m away";
        drawAway(drawing, labels, light_.toward(dvec2(0.0)), away, ink::kLight);
        return;
    }
    const dvec2 at = (*this)(light_.at);
    drawing.circle(at, 13, drawing::colorText(look::kChosenLight), {"#1a1a1a", 3, false}, "light");
    labels.avoid({at - 15.0, dvec2(30)});
    labels.place(drawing, at, name, {.size = kText, .isBold = true}, 18);
}

void SectionSheet::drawPoint(drawing::Drawing& drawing, drawing::Labels& labels, const std::string& name) const {
    const dvec2 at = (*this)(dvec2(0.0));
    drawing.circle(at, 8, "#1a1a1a", {"#ffffff", 2, false}, "point");
    labels.avoid({at - 9.0, dvec2(18)});
    labels.place(drawing, at, name, {.size = kText, .isBold = true}, 12);
}

void drawLegend(drawing::Drawing& drawing, const drawing::Box& area, std::span<const LegendEntry> entries, const image::Font& font) {
    constexpr double kSign = 40, kGap = 12, kBetween = 34;
    dvec2 at = area.corner + dvec2(0, kText);
    for (const LegendEntry& entry : entries) {
        const double width = kSign + kGap + drawing::textSize(font, entry.text, kText).x;
        if (at.x + width > area.corner.x + area.size.x && at.x > area.corner.x) at = {area.corner.x, at.y + kSheetRow};
        const dvec2 middle = at + dvec2(0.5 * kSign, -0.35 * kText);
        switch (entry.kind) {
        case LegendEntry::Kind::filled:
            drawing.rectangle(middle - dvec2(0.5 * kSign, 11), {kSign, 22}, entry.color, {"#8c8c8c", 1.5, false});
            break;
        case LegendEntry::Kind::dot: drawing.circle(middle, 9, entry.color, {"#ffffff", 1.5, false}); break;
        case LegendEntry::Kind::line:
        case LegendEntry::Kind::dashed:
            drawing.line(middle - dvec2(0.5 * kSign, 0), middle + dvec2(0.5 * kSign, 0),
                         {entry.color, 4.5, entry.kind == LegendEntry::Kind::dashed});
        }
        drawing.text(at + dvec2(kSign + kGap, 0), entry.text, {.size = kText});
        at.x += width + kBetween;
    }
}

double TextColumn::lineHeight() const { return kSheetRow * em_ / kText; }

void TextColumn::heading(const std::string& text) {
    y_ += y_ > 0 ? lineHeight() + 14 : kHeading;
    svg_.text(area_.corner + dvec2(0, y_), text, {.size = kHeading, .isBold = true});
    y_ += 6;
}

bool TextColumn::hasRoom(int lines) const { return y_ + lines * lineHeight() <= area_.size.y; }

bool TextColumn::row(const std::string& text, const std::string& color) {
    const std::vector<std::string> lines = font_.wrap(text, em_, static_cast<int>(area_.size.x));
    if (!hasRoom(static_cast<int>(lines.size()))) return false;
    for (const std::string& line : lines) {
        y_ += lineHeight();
        svg_.text(area_.corner + dvec2(0, y_), line, {.size = em_, .color = color});
    }
    return true;
}

} // namespace shadowlab::figures
