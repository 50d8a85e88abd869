// "Basic ray-tracing algorithm": from the projection reference point through a pixel's centre, to the first surface.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "app/figures/parallel_view.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

// Where the projection plane is drawn: a share of the depth of the first surface. A perspective image is the same at any
// distance.
constexpr double kPlaneShare = 0.42;
constexpr int kRows = 9;            ///< of cells; more would be too small to distinguish
constexpr double kLens = 150;       ///< pixels: radius of the enlargement
constexpr double kEnlarged = 2.2;   ///< pixels of the picture across it
constexpr double kThingTimes = 0.8; ///< objects wider than so many times the ray's length are ground and walls
// From where it is seen: beside the camera, above it, and a little from behind, so that the pixels face the reader.
constexpr double kBesideScreen = 0.75, kAbove = 0.38, kBehind = 0.55;

class Sheet {
public:
    Sheet(const FigureSource& source, const drawing::Box& room)
        : camera_(source.view.camera), size_(source.view.size),
          forward_(glm::normalize(camera_.targetWorld - camera_.positionWorld)),
          right_(glm::normalize(glm::cross(forward_, camera_.upWorld))),
          view(direction(), glm::cross(right_, forward_)) {
        const Probe::Segment& ray = source.probe.geometry.front();
        eyeWorld = ray.fromWorld;
        hitWorld = ray.toWorld;
        depth = kPlaneShare * glm::dot(hitWorld - eyeWorld, forward_);
        cellPixels = static_cast<double>(size_.y) / kRows;
        const double length = glm::length(hitWorld - eyeWorld);
        std::vector<dvec3> places{eyeWorld, hitWorld, hitWorld + 0.12 * (hitWorld - eyeWorld)};
        for (const dvec3& corner : scene::viewCorners(camera_, static_cast<double>(size_.x) / size_.y, depth))
            places.push_back(corner);
        for (const scene::Object& object : source.scene.objects) {
            const scene::Bounds box = scene::boundsWorld(object);
            const dvec3 middle = 0.5 * (box.lowerWorld + box.upperWorld);
            if (object.emitterOfLight >= 0 || glm::length(box.upperWorld - box.lowerWorld) > kThingTimes * length)
                continue;
            if (glm::length(middle - hitWorld) > 0.6 * length) continue;
            things.push_back(&object);
            for (int i = 0; i < 8; ++i)
                places.push_back(box.corner(i));
        }
        view.fit(places, room);
    }
    /// Where the projection plane has a place of the picture.
    [[nodiscard]] dvec3 onPlane(dvec2 pixel) const {
        const dvec3 way = scene::rayDirectionWorld(camera_, pixel, size_);
        return eyeWorld + way * (depth / glm::dot(way, forward_));
    }

private:
    [[nodiscard]] dvec3 direction() const {
        // From the side on which the rays go to the right of the sheet.
        return kBesideScreen * right_ + kAbove * glm::cross(right_, forward_) - kBehind * forward_;
    }
    scene::Camera camera_;
    ivec2 size_;
    dvec3 forward_, right_;

public:
    ParallelView view;
    dvec3 eyeWorld{0.0}, hitWorld{0.0};
    double depth = 0, cellPixels = 1;
    std::vector<const scene::Object*> things;
};

void drawPlane(drawing::Drawing& drawing, const Sheet& sheet, ivec2 size, drawing::Labels& labels) {
    std::vector<dvec2> rim;
    for (const dvec2 corner : {dvec2(0, 0), dvec2(size.x, 0), dvec2(size.x, size.y), dvec2(0, size.y)})
        rim.push_back(sheet.view(sheet.onPlane(corner)));
    drawing.path(rim, true, "#f4f9fd", {"#1a1a1a", 3, false}); // a pale blue
    std::vector<dvec2> lines;
    for (double x = sheet.cellPixels; x < size.x - 0.5; x += sheet.cellPixels)
        lines.insert(lines.end(), {sheet.view(sheet.onPlane({x, 0})), sheet.view(sheet.onPlane({x, size.y}))});
    for (double y = sheet.cellPixels; y < size.y - 0.5; y += sheet.cellPixels)
        lines.insert(lines.end(), {sheet.view(sheet.onPlane({0, y})), sheet.view(sheet.onPlane({size.x, y}))});
    drawing.segments(lines, {"#9fb9c9", 1.5, false});
    for (std::size_t i = 0; i < 4; ++i)
        labels.avoid(rim[i], rim[(i + 1) % 4]);
}

/// The pixel with its neighbours, and its centre, enlarged.
void drawEnlarged(drawing::Drawing& drawing, dvec2 middle, dvec2 from, drawing::Labels& labels) {
    drawing.line(from, middle + kLens * glm::normalize(from - middle), {"#8c8c8c", 2, false});
    labels.avoid(from, middle);
    const double cell = 2 * kLens / kEnlarged;
    drawing.circle(middle, kLens, "#ffffff", {"#1a1a1a", 3, false});
    const double half = 0.5 * cell, reach = std::sqrt(kLens * kLens - half * half);
    for (const double at : {-half, half}) {
        drawing.line(middle + dvec2(at, -reach), middle + dvec2(at, reach), {"#9fb9c9", 2, false});
        drawing.line(middle + dvec2(-reach, at), middle + dvec2(reach, at), {"#9fb9c9", 2, false});
    }
    drawing.rectangle(middle - half, dvec2(cell), "#d6ebf7", {"#1a1a1a", 3, false});
    drawing.circle(middle, 8, "#1a1a1a", {"#ffffff", 2, false}, "pixel centre");
    labels.avoid({middle - kLens - 6.0, dvec2(2 * kLens + 12)});
    drawing.text(middle + dvec2(0, -16), "Pixel",
                 {.size = kText, .anchor = drawing::Anchor::middle, .isBold = true, .hasRim = false});
    drawing.text(middle + dvec2(0, 34), "Centre",
                 {.size = kText, .anchor = drawing::Anchor::middle, .isBold = true, .hasRim = false});
}

} // namespace

Diagram drawPixelRay(const FigureSource& source) {
    eyeRayOf(source);
    drawing::Drawing drawing(source.size);
    const ivec2 size = source.view.size;
    const auto each = static_cast<int>(std::lround(static_cast<double>(size.y) / kRows));
    const drawing::Box area = writeFoot(drawing, roomOf(source),
                               "The picture has " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                                   " pixels. A square of the plane stands for " + std::to_string(each) + " x " +
                                   std::to_string(each) + " of them; the circle shows single ones.",
                               source.font);
    const Sheet sheet(source, {area.corner + dvec2(60, 60), area.size - dvec2(120, 110)});
    drawing::Labels labels(source.fonts(), area);
    for (const scene::Object* thing : sheet.things)
        drawObject(drawing, area, sheet.view, *thing, {"#8c8c8c", 3, false}, &labels);
    drawPlane(drawing, sheet, size, labels);
    const dvec2 pixel = dvec2(source.view.picked.value_or(size / 2)) + 0.5;
    const dvec2 eye = sheet.view(sheet.eyeWorld), hit = sheet.view(sheet.hitWorld),
                through = sheet.view(sheet.onPlane(pixel));
    // The cell of the plane that the pixel lies in.
    const dvec2 cell = glm::floor(pixel / sheet.cellPixels) * sheet.cellPixels;
    std::vector<dvec2> square;
    for (const dvec2 corner : {dvec2(0, 0), dvec2(1, 0), dvec2(1, 1), dvec2(0, 1)})
        square.push_back(sheet.view(sheet.onPlane(glm::min(cell + sheet.cellPixels * corner, dvec2(size)))));
    drawing.path(square, true, "#d6ebf7", {"#1a1a1a", 2, false});
    drawing.arrow(eye, hit, strokeOf(Probe::Role::eye), 0.7);
    labels.avoid(eye, hit);
    drawing.circle(eye, 11, "#ffffff", {"#1a1a1a", 4, false}, "eye");
    drawing.circle(through, 6, "#1a1a1a", {"#ffffff", 1.5, false}, "through");
    drawing.circle(hit, 9, drawing::colorText(look::kOccluded), {"#1a1a1a", 2.5, false}, "surface");
    for (const dvec2 at : {eye, through, hit})
        labels.avoid({at - 12.0, dvec2(24)});
    // The enlargement stands in the corner that is farthest from all that is drawn: below the ray's first part, or above it.
    const dvec2 low(area.corner.x + kLens + 12, area.corner.y + area.size.y - kLens - 12);
    const dvec2 high(low.x, area.corner.y + kLens + 12);
    const auto room = [&](dvec2 corner) {
        return std::min(
            {glm::length(corner - eye), glm::length(corner - through), glm::length(corner - 0.5 * (eye + through))});
    };
    drawEnlarged(drawing, room(low) > room(high) ? low : high, through, labels);
    const drawing::TextStyle bold{.size = kHeading, .isBold = true};
    labels.place(drawing, eye, "Projection Reference Point", bold, 16);
    labels.place(drawing, glm::mix(through, hit, 0.4), "Pixel Ray", bold, 12);
    labels.place(drawing, sheet.view(sheet.onPlane({size.x, 0})), "Projection Plane", bold, 14);
    const std::string object = source.probe.tree.empty() ? "" : ": " + source.probe.tree.front().object;
    labels.place(drawing, hit, "first surface" + object, {.size = kHeading}, 16);
    return {std::move(drawing), "A pixel ray from the projection reference point through the centre of a pixel of the "
                                "projection plane to the first surface"};
}

} // namespace shadowlab::figures
