// "Soft shadows under an extended light source": the light, an object, and where around it all, a part, or nothing of the light is
// seen, in a plane through the light's centre and the point, square to the point's surface.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "app/figures/rays/light_section.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

constexpr double kScanPixels = 4; ///< between the lines along which borders are found
constexpr double kBand = 14;      ///< pixels: the receiver, coloured by what it sees
constexpr int kAlong = 600;       ///< places that are asked along the receiver
const char *const kUmbra = "#8c8c8c", *const kPenumbra = "#dcdcdc";

/// The plane, with the surface's normal upward and the point as its origin.
DrawingPlane planeOf(const FigureSource& source, const scene::Light& light, const dvec3& pointWorld,
                     const dvec3& normalWorld) {
    dvec3 toLight = light.positionWorld - pointWorld;
    toLight -= glm::dot(toLight, normalWorld) * normalWorld;
    const double away = glm::length(light.positionWorld - pointWorld);
    // Straight below the light any plane will do: the one across the view.
    if (glm::length(toLight) < 1e-3 * away) {
        const scene::Camera& camera = source.view.camera;
        toLight = glm::cross(normalWorld, camera.targetWorld - camera.positionWorld);
        if (glm::length(toLight) == 0) toLight = camera.upWorld;
    }
    DrawingPlane plane{pointWorld, glm::normalize(toLight), normalWorld};
    // As the camera sees it: its right side on the right.
    const dvec3 right =
        glm::cross(source.view.camera.targetWorld - source.view.camera.positionWorld, source.view.camera.upWorld);
    if (glm::dot(plane.rightWorld, right) < 0) plane.rightWorld = -plane.rightWorld;
    return plane;
}

/// What the plane cuts, object by object.
struct CutObject {
    std::string name;
    std::vector<dvec2> segments;
    bool casts, isReceiver;
};

std::vector<CutObject> cutObjects(const FigureSource& source, const DrawingPlane& plane, double away) {
    std::vector<CutObject> objects;
    for (const scene::Object& object : source.scene.objects) {
        if (object.emitterOfLight >= 0) continue;
        scene::Scene alone;
        alone.objects = {object};
        std::vector<dvec2> segments = cut(alone, plane);
        if (segments.empty()) continue;
        // The receiver: cut along the horizontal line through the point.
        bool isReceiver = false;
        for (std::size_t i = 0; i + 1 < segments.size(); i += 2)
            isReceiver =
                isReceiver || (std::abs(segments[i].y) < 1e-5 * away && std::abs(segments[i + 1].y) < 1e-5 * away &&
                               std::min(segments[i].x, segments[i + 1].x) <= 1e-5 * away &&
                               std::max(segments[i].x, segments[i + 1].x) >= -1e-5 * away);
        objects.push_back({object.name, std::move(segments), object.castsShadow, isReceiver});
    }
    return objects;
}

/// A sheet with y upward.
struct PlaneSheet {
    PlaneSheet(dvec2 low, dvec2 high, const drawing::Box& room) {
        const dvec2 extent = high - low;
        scale = std::min(room.size.x / extent.x, room.size.y / extent.y);
        // The receiver at the foot of the room.
        offset = {room.corner.x + 0.5 * room.size.x - 0.5 * scale * (low.x + high.x),
                  room.corner.y + room.size.y - 0.5 * (room.size.y - scale * extent.y) + scale * low.y};
    }
    [[nodiscard]] dvec2 operator()(dvec2 at) const { return offset + scale * dvec2(at.x, -at.y); }
    [[nodiscard]] double metres(double sheetX) const { return (sheetX - offset.x) / scale; }
    double scale;
    dvec2 offset;
};

/// Does it hide some of the light from some place of the receiver, between these two?
bool throwsShadow(const CutObject& object, const scene::Light& light, const DrawingPlane& plane, double left,
                  double right) {
    if (!object.casts || object.isReceiver) return false;
    const SectionOfLight alone(light, plane, object.segments);
    for (int i = 0; i <= kAlong; ++i)
        if (kindAt(alone, {glm::mix(left, right, static_cast<double>(i) / kAlong), 0.0}) != LitArea::Kind::all)
            return true;
    return false;
}

/// Is a place within what these outlines enclose? Then the number of them on either side of it is odd; of a wall, which is a line
/// here, it is so on one side only.
bool isWithin(dvec2 place, const std::vector<dvec2>& outlines) {
    int left = 0, right = 0;
    for (std::size_t i = 0; i + 1 < outlines.size(); i += 2) {
        const dvec2 a = outlines[i], b = outlines[i + 1];
        if ((a.y > place.y) == (b.y > place.y)) continue;
        ++(glm::mix(a.x, b.x, (place.y - a.y) / (b.y - a.y)) > place.x ? right : left);
    }
    return left % 2 == 1 && right % 2 == 1;
}

/// Where an area of that kind is widest, objects left out: a place for its name, which is twice `half` metres large.
struct Middle {
    dvec2 at{0.0};
    double width = 0; ///< metres; 0: there is none
};
Middle middleOf(const std::vector<LitArea>& areas, LitArea::Kind kind, const std::vector<CutObject>& objects,
                dvec2 half) {
    constexpr int kAsked = 40; // places of each line
    Middle best;
    const auto isFree = [&](dvec2 at) {
        return std::ranges::none_of(objects, [&](const CutObject& object) { return isWithin(at, object.segments); });
    };
    for (const LitArea& area : areas) {
        if (area.kind != kind) continue;
        for (std::size_t i = 0; i < area.outline.size() / 2; ++i) {
            const dvec2 left = area.outline[i], right = area.outline[area.outline.size() - 1 - i];
            if (left.y < 2 * half.y) continue;
            double begin = 0;
            for (int k = 0; k <= kAsked; ++k) {
                const double share = static_cast<double>(k) / kAsked;
                if (!isFree(glm::mix(left, right, share))) {
                    begin = share;
                } else if (const double width = (share - begin) * (right.x - left.x); width > best.width) {
                    const dvec2 at = glm::mix(left, right, 0.5 * (begin + share)), other(half.x, -half.y);
                    if (isFree(at + half) && isFree(at - half) && isFree(at + other) && isFree(at - other))
                        best = {at, width};
                }
            }
        }
    }
    return best;
}

} // namespace

Diagram drawPenumbra(const FigureSource& source) {
    const dvec3 pointWorld = eyeRayOf(source).toWorld;
    if (source.probe.tree.empty())
        throw Error(ExitStatus::badInput, std::string(source.technique) + " tells no normal; ask ray-traced");
    const scene::Light& light = areaLightOf(source);
    const DrawingPlane plane = planeOf(source, light, pointWorld, source.probe.tree.front().normalWorld);
    const dvec2 lightAt = plane.of(light.positionWorld);
    if (lightAt.y <= 0)
        throw Error(ExitStatus::badInput,
                    "the surface at the pixel faces away from light '" + light.name + "'; choose another");
    const double away = glm::length(lightAt);
    const std::vector<CutObject> objects = cutObjects(source, plane, away);
    std::vector<dvec2> occluders;
    for (const CutObject& object : objects)
        if (object.casts && !object.isReceiver)
            occluders.insert(occluders.end(), object.segments.begin(), object.segments.end());
    const SectionOfLight section(light, plane, occluders);

    // What is shown: the light, the point, the shadow that it lies in or near, and what throws it.
    const auto ends = section.seenFrom(dvec2(0.0));
    dvec2 low(0.0), high(0.0);
    const auto include = [&](dvec2 at) {
        low = glm::min(low, at);
        high = glm::max(high, at);
    };
    include(ends[0]);
    include(ends[1]);
    const double aside = 0.3 * away, right = std::max(0.0, lightAt.x) + aside, left = std::min(0.0, lightAt.x) - aside;
    bool hasShadow = false;
    for (int i = 0; i <= kAlong; ++i) {
        const double x = glm::mix(left, right, static_cast<double>(i) / kAlong);
        if (kindAt(section, {x, 0.0}) == LitArea::Kind::all) continue;
        include({x, 0});
        hasShadow = true;
    }
    if (!hasShadow)
        throw Error(ExitStatus::badInput,
                    "nothing throws a shadow in the plane through the light and the point; choose a "
                    "pixel in or beside a shadow");
    const double margin = 0.04 * (high.x - low.x);
    low -= dvec2(margin, 0);
    high += dvec2(margin, 0);

    drawing::Drawing drawing(source.size);
    const drawing::Box area = writeFoot(drawing, roomOf(source),
                               "In the plane through the light's centre and the point, square to the surface. On the "
                               "receiver: all (green), a part (yellow), nothing (orange) of the light is seen.",
                               source.font);
    const PlaneSheet sheet(low, high, {area.corner + dvec2(20, 64), area.size - dvec2(40, 64 + 60)});
    const dvec2 floor = sheet(dvec2(0.0));
    const double top = area.corner.y + 1.6 * kText;
    const drawing::Box within{
        {sheet.metres(area.corner.x), 0},
        {area.size.x / sheet.scale, std::min((floor.y - top) / sheet.scale, std::max(ends[0].y, ends[1].y))}};
    const std::vector<LitArea> areas = shadowAreas(section, within, kScanPixels / sheet.scale);
    drawing::Labels labels(source.fonts(), area);
    drawing.beginClip(area.corner, area.size);
    for (const LitArea& one : areas) {
        std::vector<dvec2> outline;
        for (const dvec2& at : one.outline)
            outline.push_back(sheet(at));
        const char* color = one.kind == LitArea::Kind::none ? kUmbra : kPenumbra;
        drawing.path(outline, true, color, {color, 0.5, false});
    }
    // The receiver, coloured.
    const double from = within.corner.x, to = from + within.size.x;
    double begin = from;
    LitArea::Kind kind = kindAt(section, {from, 0.0});
    for (int i = 1; i <= 4 * kAlong; ++i) {
        const double x = glm::mix(from, to, i / (4.0 * kAlong));
        const LitArea::Kind next = kindAt(section, {x, 0.0});
        if (next == kind && i < 4 * kAlong) continue;
        const vec3& color = kind == LitArea::Kind::all    ? look::kEqualDepth
                            : kind == LitArea::Kind::part ? look::kPartlySeen
                                                          : look::kOccluded;
        drawing.rectangle(sheet({begin, 0}), {sheet.scale * (x - begin), kBand}, drawing::colorText(color),
                          {drawing::colorText(color), 0, false});
        begin = x;
        kind = next;
    }
    for (const CutObject& object : objects) {
        if (object.isReceiver) continue;
        std::vector<dvec2> seen;
        for (std::size_t i = 0; i + 1 < object.segments.size(); i += 2) {
            const dvec2 a = sheet(object.segments[i]), b = sheet(object.segments[i + 1]);
            if (!area.overlaps({glm::min(a, b) - 1.0, glm::abs(a - b) + 2.0})) continue;
            seen.insert(seen.end(), {a, b});
            labels.avoid(a, b);
        }
        drawing.segments(seen, {object.casts ? "#1a1a1a" : "#a6a6a6", 4.5, false});
    }
    drawing.endClip();
    drawing.line({area.corner.x, floor.y}, {area.corner.x + area.size.x, floor.y}, {"#1a1a1a", 3, false});
    labels.avoid({{area.corner.x, floor.y - 2}, {area.size.x, kBand + 4}});

    const std::string sees = "point: sees " + percent(section.share(dvec2(0, 1e-9 * away))) + " of the light's section";
    const double half = 0.5 * drawing::textSize(source.font, sees, kText).x;
    drawing.text(
        {std::clamp(floor.x, area.corner.x + half, area.corner.x + area.size.x - half), floor.y + kBand + 1.3 * kText},
        sees, {.size = kText, .anchor = drawing::Anchor::middle});
    labels.avoid({{area.corner.x, floor.y + kBand}, {area.size.x, 1.6 * kText}});
    // The light.
    const dvec2 a = sheet(ends[0]), b = sheet(ends[1]);
    if (light.type == scene::LightType::sphere)
        drawing.circle(sheet(lightAt), sheet.scale * light.radius, drawing::colorText(look::kChosenLight), {"#1a1a1a", 3, false},
                       "light");
    else {
        drawing.line(a, b, {"#1a1a1a", 16, false});
        drawing.line(a, b, {drawing::colorText(look::kChosenLight), 10, false});
    }
    labels.avoid({glm::min(a, b) - 10.0, glm::abs(a - b) + 20.0});
    for (const dvec2& end : {a, b}) {
        drawing.line(end, floor, {"#1a1a1a", 1.5, true});
    }
    drawing.circle(floor, 8, "#1a1a1a", {"#ffffff", 2, false}, "point");
    labels.avoid({floor - 9.0, dvec2(18)});
    const drawing::TextStyle bold{.size = kText, .isBold = true};
    const auto name = [&](LitArea::Kind kind, const char* word) {
        const dvec2 size(1.12 * drawing::textSize(source.font, word, kText).x, kText);
        const Middle middle = middleOf(areas, kind, objects, 0.55 * size / sheet.scale);
        if (middle.width == 0) return;
        const dvec2 at = sheet(middle.at);
        const drawing::Box box{at - 0.5 * size, size};
        if (middle.width * sheet.scale < size.x + 12 || box.corner.x < area.corner.x) {
            labels.place(drawing, at, word, bold, 2);
            return;
        }
        drawing.text(at + dvec2(0, 0.36 * kText), word, {.size = kText, .anchor = drawing::Anchor::middle, .isBold = true});
        labels.avoid(box);
    };
    name(LitArea::Kind::none, "Umbra");
    name(LitArea::Kind::part, "Penumbra");
    // Names of areas may lie on these lines, for they are narrow; others need not.
    for (const dvec2& end : {a, b})
        labels.avoid(end, floor);
    labels.place(drawing, sheet(lightAt), "Extended Light Source", bold, 18);
    for (const CutObject& object : objects) {
        if (!throwsShadow(object, light, plane, left, right)) continue;
        dvec2 middle(0.0);
        for (const dvec2& at : object.segments)
            middle += at / static_cast<double>(object.segments.size());
        if (area.overlaps({sheet(middle) - 40.0, dvec2(80)}))
            labels.place(drawing, sheet(middle), "Object: " + object.name, {.size = kText}, 4);
    }
    return {std::move(drawing), "An extended light source, an object, and its umbra and penumbra in a plane"};
}

} // namespace shadowlab::figures
