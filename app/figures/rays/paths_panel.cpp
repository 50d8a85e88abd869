// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/figures/drawing_plane.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

// A surface that is this many times as far from the first one as all nearer ones would leave them no room: its ray is cut.
constexpr double kRayFarTimes = 4;
// In units of the size of what is near: where the eye and the light are drawn if they are farther; how long rays are drawn
// that end nowhere, or far away.
constexpr double kEyeReach = 0.9, kLightReach = 0.8, kRayReach = 0.3;
constexpr double kOfEyeDistance = 0.3;                  ///< that size, where there is no second surface
constexpr double kNormalLength = 46, kSurfaceHalf = 34; ///< pixels

const Probe::Segment& segmentOf(const Probe& probe, int ray) {
    return probe.geometry[static_cast<std::size_t>(probe.tree[static_cast<std::size_t>(ray)].segment)];
}

/// A line as it is drawn; `isCut`: a part of it is left out, at the end or, of the eye's, in the middle.
struct Drawn {
    dvec2 from{0.0}, to{0.0};
    bool isCut = false;
};

/// Places and lines of the panel, in metres of the plane, y upward.
class Paths {
public:
    Paths(const Probe& probe, const ShownTree& shown, const scene::Scene& scene)
        : probe_(probe), scene_(scene), plane_(planeOfIncidence(probe)) {
        for (const int ray : shown.rays)
            if (node(ray).segment >= 0) rays.push_back(ray);
        shadowRays = shown.shadowRays;
        findNear();
        const Probe::Segment& eye = segmentOf(probe, rays.front());
        eyeAt = plane_.of(eye.fromWorld);
        eyeCut = glm::length(eyeAt) > kEyeReach * near_;
        if (eyeCut) eyeAt *= kEyeReach * near_ / glm::length(eyeAt);
        if (!shadowRays.empty()) placeLight(node(shadowRays.front()).light);
    }

    [[nodiscard]] const Probe::Node& node(int ray) const { return probe_.tree[static_cast<std::size_t>(ray)]; }
    [[nodiscard]] const DrawingPlane& plane() const { return plane_; }
    [[nodiscard]] double near() const { return near_; }

    [[nodiscard]] Drawn drawn(int ray) const {
        const Probe::Segment& segment = segmentOf(probe_, ray);
        const dvec2 from = plane_.of(segment.fromWorld), to = plane_.of(segment.toWorld);
        if (node(ray).parent < 0) return {eyeAt, to, eyeCut};
        if (node(ray).light >= 0 && segment.role == Probe::Role::arriving && !segment.isEndless && !lightCut)
            return {from, to, false};
        const bool far = segment.isEndless || glm::length(to) > reach_ || glm::length(to - from) > 1.2 * reach_;
        const double length = glm::length(to - from);
        if (!far || length <= kRayReach * near_) return {from, to, false};
        return {from, from + (to - from) * (kRayReach * near_ / length), true};
    }

    std::vector<int> rays, shadowRays; ///< that were sent
    dvec2 eyeAt{0.0}, lightAt{0.0};
    bool eyeCut = false, lightCut = false, hasLight = false;
    std::string lightName;

private:
    /// How far the surfaces reach that are drawn where they are.
    void findNear() {
        std::vector<double> distances;
        for (const int ray : rays)
            if (!node(ray).surface.empty() && node(ray).parent >= 0)
                distances.push_back(glm::length(plane_.of(segmentOf(probe_, ray).toWorld)));
        std::ranges::sort(distances);
        const Probe::Segment& eye = segmentOf(probe_, rays.front());
        const double least = 1e-3 * glm::length(eye.fromWorld - eye.toWorld); // nearer is the same place
        for (const double distance : distances)
            if (distance > least && (reach_ == 0 || distance <= kRayFarTimes * reach_)) reach_ = distance;
        if (reach_ == 0) reach_ = kOfEyeDistance * glm::length(eye.fromWorld - eye.toWorld);
        reach_ *= 1.001; // the farthest itself is not beyond it
        near_ = reach_;
    }

    void placeLight(int light) {
        const scene::Light& source = scene_.light(light);
        lightName = source.name;
        if (source.type == scene::LightType::directional) {
            lightCut = true;
            return;
        }
        lightAt = plane_.of(source.positionWorld);
        lightCut = glm::length(lightAt) > kLightReach * near_ + reach_;
        hasLight = !lightCut;
    }

    const Probe& probe_;
    const scene::Scene& scene_;
    DrawingPlane plane_;
    double reach_ = 0, near_ = 0;
};

/// From metres of the plane to pixels of the sheet: all that is drawn, as large as fits.
class OnSheet {
public:
    OnSheet(const Paths& paths, const drawing::Box& area) {
        dvec2 low = paths.eyeAt, high = paths.eyeAt;
        const auto include = [&](dvec2 p) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        };
        if (paths.hasLight) include(paths.lightAt);
        for (const std::vector<int>* list : {&paths.rays, &paths.shadowRays})
            for (const int ray : *list) {
                include(paths.drawn(ray).from);
                include(paths.drawn(ray).to);
            }
        const dvec2 extent = glm::max(high - low, dvec2(1e-9));
        scale_ = std::min(area.size.x / extent.x, area.size.y / extent.y);
        middle_ = 0.5 * (low + high);
        centre_ = area.corner + 0.5 * area.size;
    }
    [[nodiscard]] dvec2 operator()(dvec2 p) const { return centre_ + scale_ * dvec2(p.x - middle_.x, middle_.y - p.y); }
    [[nodiscard]] static dvec2 direction(dvec2 d) { return {d.x, -d.y}; }

private:
    double scale_ = 1;
    dvec2 middle_{0.0}, centre_{0.0};
};

void drawSurfaces(drawing::Drawing& drawing, const drawing::Box& area, const Paths& paths, const OnSheet& onSheet,
                  const scene::Scene& scene, drawing::Labels& labels) {
    std::vector<dvec2> points = cut(scene, paths.plane());
    for (dvec2& point : points)
        point = onSheet(point);
    // What lies far away has no use: it would only make the file long.
    std::vector<dvec2> seen;
    const drawing::Box around{area.corner - area.size, 3.0 * area.size};
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        const dvec2 low = glm::min(points[i], points[i + 1]), high = glm::max(points[i], points[i + 1]);
        if (!around.overlaps({low, high - low + 1e-6})) continue;
        seen.insert(seen.end(), {points[i], points[i + 1]});
        labels.avoid(points[i], points[i + 1]);
    }
    drawing.beginClip(area.corner, area.size);
    drawing.segments(seen, {"#8c8c8c", 3.5, false});
    drawing.endClip();
}

/// The hit surface and its normal, also where the surface is not cut by the plane.
void drawHit(drawing::Drawing& drawing, const Paths& paths, const OnSheet& onSheet, int ray, drawing::Labels& labels) {
    const dvec2 at = onSheet(paths.drawn(ray).to);
    const dvec2 normal = OnSheet::direction(paths.plane().ofDirection(paths.node(ray).normalWorld));
    if (const double length = glm::length(normal); length > 0.2) { // else it points out of the paper
        const dvec2 along = dvec2(-normal.y, normal.x) / length;
        drawing.line(at - kSurfaceHalf * along, at + kSurfaceHalf * along, {"#4d4d4d", 5, false});
        drawing.arrow(at, at + kNormalLength * normal, {"#4d4d4d", 2, false});
        labels.avoid(at - kSurfaceHalf * along, at + kSurfaceHalf * along);
        labels.avoid(at, at + kNormalLength * normal);
    }
    drawing.circle(at, 6, "#1a1a1a", {"#ffffff", 1.5, false});
}

void drawRay(drawing::Drawing& drawing, const Paths& paths, const OnSheet& onSheet, int ray, drawing::Labels& labels) {
    const Drawn drawn = paths.drawn(ray);
    const Probe::Role role = paths.node(ray).role;
    const dvec2 from = onSheet(drawn.from), to = onSheet(drawn.to);
    const drawing::Stroke stroke = strokeOf(role);
    labels.avoid(from, to);
    if (glm::length(to - from) < 1) return;
    const bool ends = role == Probe::Role::blocked || !paths.node(ray).surface.empty();
    drawing.arrow(from, to, stroke, drawn.isCut || !ends ? 1.0 : 0.55);
    if (drawn.isCut && ends)
        drawing.breakMark(glm::mix(from, to, paths.node(ray).parent < 0 ? 0.4 : 0.8), to - from, stroke);
    if (role == Probe::Role::blocked) {
        const dvec2 arm(9, 9), other(9, -9);
        drawing.line(to - arm, to + arm, {stroke.color, 4, false});
        drawing.line(to - other, to + other, {stroke.color, 4, false});
    }
}

/// The eye, and the projection plane with the pixel before it.
void drawEye(drawing::Drawing& drawing, const Paths& paths, const OnSheet& onSheet, const scene::Camera& camera,
             drawing::Labels& labels) {
    const dvec2 eye = onSheet(paths.eyeAt), first = onSheet(paths.drawn(paths.rays.front()).to);
    drawing.circle(eye, 9, "#ffffff", {"#1a1a1a", 4, false});
    const dvec2 pixel = glm::mix(eye, first, 0.2);
    const dvec2 axis = OnSheet::direction(paths.plane().ofDirection(camera.targetWorld - camera.positionWorld));
    if (glm::length(axis) == 0) return;
    const dvec2 along = dvec2(-axis.y, axis.x) / glm::length(axis);
    drawing.line(pixel - 70.0 * along, pixel + 70.0 * along, {"#4d4d4d", 3, false});
    drawing.rectangle(pixel - 7.0, dvec2(14), "#1a1a1a", {"#ffffff", 1, false});
    labels.avoid(pixel - 70.0 * along, pixel + 70.0 * along);
    labels.avoid({eye - 10.0, dvec2(20)});
    labels.avoid({pixel - 8.0, dvec2(16)});
    labels.place(drawing, eye, "eye (projection reference point)", {kText}, 14);
    labels.place(drawing, pixel, "pixel", {kText}, 14);
    labels.place(drawing, pixel + (along.y > 0 ? 66.0 : -66.0) * along, "projection plane", {kText}, 12);
}

void drawLight(drawing::Drawing& drawing, const Paths& paths, const OnSheet& onSheet, drawing::Labels& labels) {
    if (paths.shadowRays.empty()) return;
    if (!paths.hasLight) {
        const Drawn first = paths.drawn(paths.shadowRays.front());
        labels.place(drawing, onSheet(first.to), "to the light " + paths.lightName, {kText}, 12);
        return;
    }
    const dvec2 at = onSheet(paths.lightAt);
    drawing.circle(at, 13, drawing::colorText(look::kChosenLight), {"#1a1a1a", 3, false});
    labels.avoid({at - 14.0, dvec2(28)});
    labels.place(drawing, at, "light " + paths.lightName, {kText}, 18);
}

} // namespace

void drawPaths(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const ShownTree& shown, const scene::Scene& scene,
               const image::Font& font) {
    drawing.text(area.corner + dvec2(0, kHeading), "Paths of pixel rays", {.size = kHeading, .isBold = true});
    const drawing::Box field{area.corner + dvec2(0, kHeading + 12), area.size - dvec2(0, kHeading + 12 + kText + 12)};
    drawing.text(area.corner + dvec2(0, area.size.y - 8), "in the plane of incidence at S1; // : a part is left out",
                 {.size = kText, .color = "#4d4d4d"});
    const Paths paths(probe, shown, scene);
    // Room for labels beyond the outermost lines.
    const OnSheet onSheet(paths, {field.corner + dvec2(70, 60), field.size - dvec2(140, 110)});
    drawing::Labels labels(font, field);
    drawSurfaces(drawing, field, paths, onSheet, scene, labels);
    for (const int ray : paths.shadowRays)
        drawRay(drawing, paths, onSheet, ray, labels);
    for (const int ray : paths.rays)
        drawRay(drawing, paths, onSheet, ray, labels);
    for (const int ray : paths.rays)
        if (!paths.node(ray).surface.empty() && !(paths.node(ray).parent >= 0 && paths.drawn(ray).isCut)) {
            drawHit(drawing, paths, onSheet, ray, labels);
            labels.avoid({onSheet(paths.drawn(ray).to) - 7.0, dvec2(14)});
        }
    drawEye(drawing, paths, onSheet, scene.camera, labels);
    drawLight(drawing, paths, onSheet, labels);
    for (const int ray : paths.rays) {
        const Drawn drawn = paths.drawn(ray);
        const Probe::Node& node = paths.node(ray);
        if (!node.surface.empty())
            labels.place(drawing, onSheet(drawn.to), node.surface, {.size = kText, .isBold = true},
                         drawn.isCut ? 6 : 10);
        if (!node.sign.empty())
            labels.place(drawing, onSheet(glm::mix(drawn.from, drawn.to, 0.5)), node.sign,
                         {.size = kText, .color = "#1a1a1a"}, 6);
    }
}

} // namespace shadowlab::figures
