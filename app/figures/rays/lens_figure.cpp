// "Out-of-focus effect": the rays of one pixel through the aperture of a lens, in the plane of the camera's axis and the pixel.
// They meet in the object plane, and nowhere else.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/drawing_plane.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/rays_probe.h"

namespace shadowlab::figures {

namespace {

// Where the projection plane is drawn: a share of the way to the object plane. A perspective image is the same at any distance.
constexpr double kProjectionShare = 0.22;
constexpr double kLensHeight = 0.42; ///< of the room's height: what the aperture is drawn as, if that makes it larger
constexpr double kLensBulge = 16;    ///< pixels
constexpr double kBeyondFocus = 1.9; ///< rays that go farther than so many times the focus are cut
constexpr int kLensArcPieces = 20;

/// The plane of the drawing: metres along the camera's axis, and at right angles to it above the ray through the lens's middle.
/// A shear along the heights: planes square to the axis stay what they are, and the middle ray is level.
class LensSheet {
public:
    LensSheet(const FigureSource& source, const RaysProbe& rays, const drawing::Box& room) : focus(rays.focus), area(room) {
        const scene::Camera& camera = source.view.camera;
        const Probe::Segment& eye = source.probe.geometry.front();
        plane.originWorld = camera.positionWorld;
        plane.rightWorld = glm::normalize(camera.targetWorld - camera.positionWorld);
        const dvec3 way = glm::normalize(eye.toWorld - eye.fromWorld);
        const dvec3 up = glm::normalize(camera.upWorld - glm::dot(camera.upWorld, plane.rightWorld) * plane.rightWorld);
        const dvec3 aside = way - glm::dot(way, plane.rightWorld) * plane.rightWorld;
        // A pixel in the middle of the picture lies in any such plane.
        plane.upWorld = glm::length(aside) > 1e-3 ? glm::normalize(aside) : up;
        if (glm::dot(plane.upWorld, up) < 0) plane.upWorld = -plane.upWorld;
        slope = plane.ofDirection(way).y / plane.ofDirection(way).x;
        farthest = focus;
        for (const RaysProbe::Sample& sample : rays.samples)
            farthest = std::max(farthest, std::min(plane.of(sample.toWorld).x, kBeyondFocus * focus));
        farthest *= 1.04;
        metre_ = dvec2(room.size.x / (1.08 * farthest));
        double reach = 0.5 * rays.aperture;
        for (const RaysProbe::Sample& sample : rays.samples) {
            const dvec2 end = cutAt(sample, farthest);
            reach = std::max(reach, std::abs(end.y));
        }
        // As high as there is room for, but no scene is drawn taller than it is by little.
        const double wanted = std::min(kLensHeight * room.size.y / rays.aperture, 0.46 * room.size.y / reach);
        heightTimes = std::max(1.0, wanted / metre_.x);
        metre_.y = heightTimes * metre_.x;
    }
    /// Metres along the axis, and above the middle ray.
    [[nodiscard]] dvec2 sheared(const dvec3& positionWorld) const {
        const dvec2 at = plane.of(positionWorld);
        return {at.x, at.y - slope * at.x};
    }
    [[nodiscard]] dvec2 operator()(dvec2 metres) const {
        return area.corner + dvec2(0.06 * area.size.x, 0.5 * area.size.y) + metre_ * dvec2(metres.x, -metres.y);
    }
    /// Where a sample's ray ends, or has come to at that distance.
    [[nodiscard]] dvec2 cutAt(const RaysProbe::Sample& sample, double along) const {
        const dvec2 from = sheared(sample.fromWorld), to = sheared(sample.toWorld);
        return to.x <= along ? to : glm::mix(from, to, (along - from.x) / (to.x - from.x));
    }

    DrawingPlane plane;
    double focus, slope = 0, farthest = 0, heightTimes = 1;
    drawing::Box area;

private:
    dvec2 metre_{1.0}; ///< pixels, along and across
};

void drawScene(drawing::Drawing& drawing, const LensSheet& sheet, const scene::Scene& scene) {
    std::vector<dvec2> seen;
    const std::vector<dvec2> points = cut(scene, sheet.plane);
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        const auto placed = [&](dvec2 at) { return sheet({at.x, at.y - sheet.slope * at.x}); };
        const dvec2 a = placed(points[i]), b = placed(points[i + 1]);
        if (sheet.area.overlaps({glm::min(a, b) - 1.0, glm::abs(a - b) + 2.0})) seen.insert(seen.end(), {a, b});
    }
    drawing.beginClip(sheet.area.corner, sheet.area.size);
    drawing.segments(seen, {"#b3b3b3", 5, false});
    drawing.endClip();
}

void drawLensShape(drawing::Drawing& drawing, const LensSheet& sheet, double aperture) {
    const dvec2 top = sheet({0, 0.5 * aperture}), bottom = sheet({0, -0.5 * aperture});
    std::vector<dvec2> rim;
    for (const double side : {1.0, -1.0})
        for (int i = 0; i <= kLensArcPieces; ++i) {
            const double t = static_cast<double>(i) / kLensArcPieces, share = side > 0 ? t : 1 - t;
            rim.push_back(glm::mix(top, bottom, share) + dvec2(side * kLensBulge * 4 * share * (1 - share), 0));
        }
    drawing.path(rim, true, "#d6ebf7", {drawing::colorText(look::kDepthFail), 3, false}); // a light tint of that blue
}

/// Below the lens, because all rays begin in it and go to the right: a line that leads to the point from the left crosses none of them.
/// A word a line: so the name stands left of the projection plane.
void nameReferencePoint(drawing::Drawing& drawing, drawing::Labels& labels, const drawing::Box& area, dvec2 eye, double lensEnd,
                        const image::Font& font) {
    double foot = std::min(lensEnd + 1.6 * kText, area.corner.y + area.size.y - 2.8 * kText);
    const dvec2 mark(eye - dvec2(9, 0)), beside(eye.x - 1.5 * kLensBulge, eye.y + kLensBulge), above(beside.x, foot - 1.05 * kText);
    for (const auto& [from, to] : {std::pair(mark, beside), std::pair(beside, above)}) {
        drawing.line(from, to, {"#8c8c8c", 1.5, false});
        labels.avoid(from, to);
    }
    for (const char* word : {"Projection", "Reference", "Point"}) {
        drawing.text({area.corner.x, foot}, word, {.size = kText});
        const dvec2 size = drawing::textSize(font, word, kText);
        labels.avoid({{area.corner.x, foot - size.y}, size + dvec2(0, 6)});
        foot += 1.25 * kText;
    }
}

} // namespace

Diagram drawLens(const FigureSource& source) {
    eyeRayOf(source);
    const RaysProbe& rays = samplesOf(source);
    if (rays.aperture <= 0)
        throw Error(ExitStatus::badInput, "a pinhole has no lens to draw; set ray-traced.aperture, for example to 0.1");
    drawing::Drawing drawing(source.size);
    drawing::Box room = roomOf(source);
    // How much larger heights are is known only when the room is.
    const auto words = [&](double times) {
        std::string text = "Heights are measured from the ray through the middle of the lens";
        text += times > 1.05 ? ", and drawn " + fourDigits(times) + " times as large." : ".";
        return text;
    };
    drawing::Drawing unused(source.size);
    const drawing::Box area = writeFoot(unused, room, words(88.88), source.font);
    const LensSheet sheet(source, rays, area);
    writeFoot(drawing, room, words(sheet.heightTimes), source.font);

    drawing::Labels labels(source.fonts(), area);
    drawScene(drawing, sheet, source.scene);
    drawLensShape(drawing, sheet, rays.aperture);
    const double top = area.corner.y + 1.6 * kText, bottom = area.corner.y + area.size.y;
    const auto plane = [&](double along, const char* name, const std::string& color) {
        const double x = sheet({along, 0}).x;
        drawing.line({x, top}, {x, bottom}, {color, 3.5, true});
        labels.avoid({x, top}, {x, bottom});
        const double half = 0.56 * drawing::textSize(source.font, name, kText).x;
        const double middle = std::clamp(x, area.corner.x + half, area.corner.x + area.size.x - half);
        drawing.text({middle, top - 12}, name, {.size = kText, .anchor = drawing::Anchor::middle, .isBold = true});
        labels.avoid({{middle - half, area.corner.y}, {2 * half, 1.6 * kText}});
    };
    plane(kProjectionShare * rays.focus, "Projection Plane", "#4d4d4d");
    plane(rays.focus, "Object Plane", drawing::colorText(look::kEqualDepth));
    for (const RaysProbe::Sample& sample : rays.samples) {
        const dvec2 from = sheet(sheet.sheared(sample.fromWorld)), to = sheet(sheet.cutAt(sample, sheet.farthest));
        drawing.line(from, to, {"#1a1a1a", 2, false});
        labels.avoid(from, to);
        // A ray that ends before the object plane would have met the others there.
        if (sheet.sheared(sample.toWorld).x < rays.focus * 0.999) {
            const dvec2 a = sheet.sheared(sample.fromWorld), b = sheet.sheared(sample.toWorld);
            drawing.line(to, sheet(glm::mix(a, b, (rays.focus - a.x) / (b.x - a.x))), {"#8c8c8c", 1.5, true});
        }
    }
    std::vector<std::string> met;
    for (const RaysProbe::Sample& sample : rays.samples) {
        if (!sample.meets || sheet.sheared(sample.toWorld).x > sheet.farthest) continue;
        drawing.circle(sheet(sheet.sheared(sample.toWorld)), 8,
                       shownColor(sample.intensity, static_cast<double>(source.scene.exposure)), {"#1a1a1a", 2, false},
                       "hit");
        labels.avoid({sheet(sheet.sheared(sample.toWorld)) - 9.0, dvec2(18)});
    }
    const dvec2 eye = sheet({0, 0}), pixel = sheet({kProjectionShare * rays.focus, 0}), focus = sheet({rays.focus, 0});
    drawing.circle(eye, 8, "#ffffff", {"#1a1a1a", 4, false}, "eye");
    drawing.rectangle(pixel - 8.0, dvec2(16), "#1a1a1a", {"#ffffff", 1, false});
    drawing.circle(focus, 7, drawing::colorText(look::kEqualDepth), {"#1a1a1a", 2, false}, "focus");
    for (const dvec2 at : {eye, pixel, focus})
        labels.avoid({at - 10.0, dvec2(20)});
    const dvec2 rim = sheet({0, -0.5 * rays.aperture});
    labels.avoid({{eye.x - kLensBulge, sheet({0, 0.5 * rays.aperture}).y},
                  {2 * kLensBulge, rim.y - sheet({0, 0.5 * rays.aperture}).y}});
    nameReferencePoint(drawing, labels, area, eye, rim.y, source.font);
    labels.place(drawing, sheet({0, 0.5 * rays.aperture}), "Lens, " + fourDigits(rays.aperture) + " m", {.size = kText, .isBold = true}, 12);
    labels.place(drawing, pixel, "pixel", {kText}, 14);
    labels.place(drawing, focus, "all rays meet here", {kText}, 14);
    for (const RaysProbe::Sample& sample : rays.samples)
        if (sample.meets && sheet.sheared(sample.toWorld).x <= sheet.farthest &&
            std::ranges::find(met, sample.object) == met.end()) {
            met.push_back(sample.object);
            labels.place(drawing, sheet(sheet.sheared(sample.toWorld)), sample.object, {.size = kText}, 12);
        }
    return {std::move(drawing), "The rays of a pixel through the aperture of a lens: they meet in the object plane"};
}

} // namespace shadowlab::figures
