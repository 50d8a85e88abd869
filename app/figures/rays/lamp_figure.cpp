// Shadow rays over the area of a light source: from the point to it, as they lie in space; and on the light itself, which of
// its places are seen.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "app/figures/parallel_view.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/rays_probe.h"

namespace shadowlab::figures {

namespace {

constexpr double kFaceShare = 0.4;        ///< of the height: the light's own face, under its rays
constexpr double kLook = 0.3;             ///< how far from above the plane of the light and N is looked at: sine
constexpr double kLampNormalShare = 0.35; ///< of the way to the light
constexpr int kCirclePieces = 72;

const std::string& arriving() {
    static const std::string color = drawing::colorText(look::kEqualDepth);
    return color;
}
const std::string& blocked() {
    static const std::string color = drawing::colorText(look::kOccluded);
    return color;
}

/// The light's rim, and two axes of its face: of a sphere those of the disc that the point sees.
struct Face {
    dvec3 centreWorld, uWorld, vWorld; ///< half axes
    bool isDisc;
    [[nodiscard]] std::vector<dvec3> rimWorld() const {
        if (!isDisc) return {at({-1, -1}), at({1, -1}), at({1, 1}), at({-1, 1})};
        std::vector<dvec3> rim;
        for (int i = 0; i < kCirclePieces; ++i) {
            const double angle = 2 * M_PI * i / kCirclePieces;
            rim.push_back(at({std::cos(angle), std::sin(angle)}));
        }
        return rim;
    }
    [[nodiscard]] dvec3 at(dvec2 place) const { return centreWorld + place.x * uWorld + place.y * vWorld; }
    /// Where a place of the light is on its face, seen along the line from the point.
    [[nodiscard]] dvec2 of(const dvec3& pointWorld, const dvec3& onLightWorld) const {
        const dvec3 normal = glm::cross(uWorld, vWorld), way = onLightWorld - pointWorld;
        const dvec3 met = pointWorld + way * (glm::dot(centreWorld - pointWorld, normal) / glm::dot(way, normal));
        // The axes of a parallelogram need not be square to each other.
        const double uu = glm::dot(uWorld, uWorld), vv = glm::dot(vWorld, vWorld), uv = glm::dot(uWorld, vWorld);
        const double a = glm::dot(met - centreWorld, uWorld), b = glm::dot(met - centreWorld, vWorld);
        return dvec2(a * vv - b * uv, b * uu - a * uv) / (uu * vv - uv * uv);
    }
};

Face faceOf(const scene::Light& light, const dvec3& pointWorld) {
    if (light.type == scene::LightType::rect)
        return {light.positionWorld, 0.5 * light.edgeUWorld, 0.5 * light.edgeVWorld, false};
    const dvec3 toPoint = pointWorld - light.positionWorld;
    const double away = glm::length(toPoint), share = std::min(light.radius / away, 0.999999);
    const dvec3 unit = toPoint / away;
    const dvec3 u = glm::normalize(glm::cross(unit, std::abs(unit.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    const double radius = light.radius * std::sqrt(1 - share * share);
    return {light.positionWorld + light.radius * share * unit, radius * u, radius * glm::cross(unit, u), true};
}

/// Does the object stand at some shadow ray, and is it no ground or wall, whose lines would cross all the drawing?
bool isNear(const scene::Object& object, const RaysProbe& rays, double away) {
    const scene::Bounds box = scene::boundsWorld(object);
    const dvec3 centre = 0.5 * (box.lowerWorld + box.upperWorld);
    const double radius = 0.5 * glm::length(box.upperWorld - box.lowerWorld);
    if (radius > 0.5 * away) return false;
    return std::ranges::any_of(rays.samples, [&](const RaysProbe::Sample& sample) {
        if (!sample.onLightWorld) return false;
        const dvec3 way = *sample.onLightWorld - sample.toWorld;
        const double t = std::clamp(glm::dot(centre - sample.toWorld, way) / glm::dot(way, way), 0.0, 1.0);
        return glm::length(sample.toWorld + t * way - centre) < radius;
    });
}

void drawSpace(drawing::Drawing& drawing, const drawing::Box& area, const FigureSource& source, const scene::Light& light,
               const Face& face) {
    const RaysProbe& rays = *source.probe.find<RaysProbe>();
    const dvec3 point = source.probe.geometry.front().toWorld, normal = source.probe.tree.front().normalWorld;
    const dvec3 toLight = light.positionWorld - point;
    const double away = glm::length(toLight);
    dvec3 across = glm::cross(toLight, normal);
    if (glm::length(across) < 0.05 * away) across = glm::cross(toLight, dvec3(0.3, 0.1, 1));
    across = glm::normalize(across);
    // From the side on which the camera is.
    if (glm::dot(across, source.view.camera.positionWorld - point) < 0) across = -across;
    const dvec3 upward = glm::normalize(normal);
    ParallelView view(across + kLook * (glm::dot(upward, toLight) > 0 ? -upward : upward), upward);
    std::vector<dvec3> places = face.rimWorld();
    places.push_back(point);
    places.push_back(point + kLampNormalShare * away * normal);
    places.push_back(point - 0.06 * away * normal);
    view.fit(places, {area.corner + dvec2(50, 60), area.size - dvec2(100, 90)});
    drawing::Labels labels(source.fonts(), area);

    for (const scene::Object& object : source.scene.objects)
        if (object.emitterOfLight < 0 && isNear(object, rays, away))
            drawObject(drawing, area, view, object, {"#8c8c8c", 3, false}, &labels);
    std::vector<dvec2> rim;
    for (const dvec3& place : face.rimWorld())
        rim.push_back(view(place));
    drawing.path(rim, true, "#fbf6bd", {"#1a1a1a", 3.5, false}); // a light tint of look::kChosenLight
    for (std::size_t i = 0; i < rim.size(); ++i)
        labels.avoid(rim[i], rim[(i + 1) % rim.size()]);
    for (const bool arrives : {false, true})
        for (const RaysProbe::Sample& sample : rays.samples) {
            if (!sample.onLightWorld || sample.arrives != arrives) continue;
            const dvec2 from = view(point), to = view(point + (sample.shadowEndWorld - sample.toWorld));
            drawing.line(from, to, {arrives ? arriving() : blocked(), 2.5, false});
            labels.avoid(from, to);
            if (arrives) {
                drawing.circle(to, 5, arriving(), {"#1a1a1a", 1.5, false}, "arrives");
                continue;
            }
            drawing.line(to - dvec2(8, 8), to + dvec2(8, 8), {blocked(), 4, false});
            drawing.line(to - dvec2(8, -8), to + dvec2(8, -8), {blocked(), 4, false});
            drawing.circle(to, 2, blocked(), {blocked(), 0, false}, "blocked");
        }
    const dvec2 at = view(point), tip = view(point + kLampNormalShare * away * normal);
    const dvec2 along(36, 0);
    drawing.line(at - along, at + along, {"#8c8c8c", 5, false});
    drawing.arrow(at, tip, {"#4d4d4d", 4, false});
    drawing.circle(at, 8, "#1a1a1a", {"#ffffff", 2, false}, "point");
    labels.avoid(at, tip);
    labels.avoid({at - dvec2(36, 9), dvec2(72, 18)});
    labels.place(drawing, tip, "N", {.size = kHeading, .isBold = true, .isItalic = true}, 10);
    labels.place(drawing, at, "point", {.size = kText, .isBold = true}, 14);
    labels.place(drawing, rim.front(), "Extended Light Source", {.size = kText, .isBold = true}, 16);
    labels.place(drawing, glm::mix(at, view(light.positionWorld), 0.45), "Shadow rays", {kText}, 30);
}

/// The light's face as the point sees it: each sample's place on it.
void drawFace(drawing::Drawing& drawing, const drawing::Box& area, const FigureSource& source, const Face& face) {
    const RaysProbe& rays = *source.probe.find<RaysProbe>();
    const double width = glm::length(face.uWorld), height = glm::length(face.vWorld);
    std::size_t arrives = 0, sent = 0;
    constexpr double kFaceWords = 400; // pixels beside the face
    const drawing::Box room{area.corner + dvec2(0, 1.7 * kText), area.size - dvec2(kFaceWords, 1.7 * kText)};
    const double scale = std::min(room.size.x / (2 * width), room.size.y / (2 * height));
    const dvec2 half = scale * dvec2(width, height), middle = room.corner + dvec2(half.x, half.y);
    drawing.text(area.corner + dvec2(0, kText), "Seen from the point", {.size = kText, .isBold = true});
    if (face.isDisc)
        drawing.circle(middle, half.x, "#fbf6bd", {"#1a1a1a", 3.5, false});
    else
        drawing.rectangle(middle - half, 2.0 * half, "#fbf6bd", {"#1a1a1a", 3.5, false});
    for (const RaysProbe::Sample& sample : rays.samples) {
        if (!sample.onLightWorld) continue;
        ++sent;
        arrives += sample.arrives;
        const dvec2 place = face.of(sample.toWorld, *sample.onLightWorld);
        drawing.circle(middle + half * glm::clamp(place, -1.0, 1.0), 9, sample.arrives ? arriving() : blocked(),
                       {"#1a1a1a", 1.5, false}, sample.arrives ? "seen" : "hidden");
    }
    dvec2 text = middle + dvec2(half.x + 30, -half.y + 1.2 * kText);
    const auto row = [&](const std::string& words, const std::string& color, bool isBold) {
        if (!color.empty()) drawing.circle(text + dvec2(9, -8), 9, color, {"#1a1a1a", 1.5, false});
        drawing.text(text + dvec2(color.empty() ? 0 : 28, 0), words, {.size = kText, .isBold = isBold});
        text.y += 1.3 * kText;
    };
    // Rays are spread evenly over what the point sees: a ray to a far part of the light stands for more of its area than one to a near part.
    row(std::to_string(arrives) + " of " + std::to_string(sent) + " arrive", arriving(), false);
    row(std::to_string(sent - arrives) + (sent - arrives == 1 ? " is blocked" : " are blocked"), blocked(), false);
    row("seen of its area: " + percent(rays.sampledShare().value_or(0)), "", true);
    row((rays.movers.empty() ? std::string("exactly: ") : std::string("exactly, at time 0: ")) +
            percent(rays.exactShare.value_or(0)),
        "", true);
}

} // namespace

Diagram drawLamp(const FigureSource& source) {
    treeOf(source);
    const scene::Light& light = areaLightOf(source);
    const RaysProbe& rays = samplesOf(source);
    if (!rays.sampledShare() || !rays.exactShare)
        throw Error(ExitStatus::badInput, "no shadow rays are spread over light '" + light.name +
                                              "' from there: the surface faces away from it, or "
                                              "ray-traced.soft-shadows is not sampled");
    drawing::Drawing drawing(source.size);
    const drawing::Box room = roomOf(source);
    const double side = kFaceShare * room.size.y;
    const Face face = faceOf(light, source.probe.geometry.front().toWorld);
    drawSpace(drawing, {room.corner, {room.size.x, room.size.y - side - 20}}, source, light, face);
    drawFace(drawing, {room.corner + dvec2(0, room.size.y - side), {room.size.x, side}}, source, face);
    return {std::move(drawing), "Shadow rays from a point to places all over a light source, some of them blocked, and "
                                "the share of the light that is seen"};
}

} // namespace shadowlab::figures
