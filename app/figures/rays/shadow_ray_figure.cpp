// "A point is in the shadow of a light source if it cannot be seen by the light source": the segment that connects both, and the
// objects that it meets, in the plane through eye, light and point.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "app/figures/drawing_plane.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

constexpr double kShadowRayLetter = 30; ///< em of the names at the things, read from the last row
constexpr double kVerdictRow = 66;      ///< pixels of the sentence under the drawing
// Of the segment, from the point: what is nearer is the surface that the point itself lies on; farther is the lamp's housing.
constexpr double kOwnSurface = 1e-3;

struct Meeting {
    double share = 0; ///< of the way from the point to the light
    std::string object;
};

/// Where the segment from the point (the origin) to `end` meets casters in the plane, in the order of the way.
std::vector<Meeting> meetings(const scene::Scene& scene, const DrawingPlane& plane, dvec2 end) {
    std::vector<Meeting> all;
    for (const scene::Object& object : scene.objects) {
        if (!object.castsShadow || object.emitterOfLight >= 0) continue;
        scene::Scene one = scene;
        one.objects = {object};
        const std::vector<dvec2> points = cut(one, plane);
        for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
            const dvec2 a = points[i], along = points[i + 1] - a;
            const double area = end.x * along.y - end.y * along.x;
            if (area == 0) continue;
            const double share = (a.x * along.y - a.y * along.x) / area, within = (a.x * end.y - a.y * end.x) / area;
            if (within < 0 || within >= 1 || share < kOwnSurface || share > 1 - kOwnSurface) continue;
            all.push_back({share, object.name});
        }
    }
    std::ranges::sort(all, {}, &Meeting::share);
    return all;
}

} // namespace

Diagram drawShadowRay(const FigureSource& source) {
    const Probe& probe = source.probe;
    if (probe.geometry.empty()) throw Error(ExitStatus::badInput, "the pixel shows the background; choose another");
    if (!hasSection(probe))
        throw Error(ExitStatus::badInput, std::string(source.technique) +
                                              " has no plane through eye, light and point there; ask shadow-volume-zfail, "
                                              "shadow-map or planar, in a scene with a light");
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kSectionBorder), source.size - 2 * kSectionBorder},
        field{area.corner, area.size - dvec2(0, kVerdictRow)};
    const SectionSheet sheet(probe, source.scene, field, {}, source.mostPixelsPerMetre);
    const PlaneLight& light = sheet.light();
    const LightSection& section = sheet.section();
    const double far = 2 * glm::length(sheet.metres().size); // beyond all that is drawn
    const dvec2 toLight = light.isDirection ? far * light.at : light.at;
    const std::vector<Meeting> met =
        meetings(source.scene, {section.originWorld, section.rightWorld, section.upWorld}, toLight);

    drawing::Labels labels(source.fonts(), field);
    sheet.drawScene(drawing, labels);
    const dvec2 point = sheet(dvec2(0.0));
    const bool lightIsSeen = !light.isDirection && sheet.shows(light.at);
    const dvec2 end = lightIsSeen ? sheet(light.at) : sheet.border(dvec2(0.0), toLight);
    const dvec2 eye = sheet.shows(sheet.eye()) ? sheet(sheet.eye()) : sheet.border(dvec2(0.0), sheet.eye());
    drawing.line(eye, point, {"#8c8c8c", 3, true});
    labels.avoid(eye, point);
    // Free up to what it meets first, as a ray is followed; past it the light is not seen.
    const drawing::Stroke free{drawing::colorText(look::kEqualDepth), 5, false},
        blocked{drawing::colorText(look::kOccluded), 5, false}, hidden{drawing::colorText(look::kOccluded), 3, true};
    labels.avoid(point, end);
    if (met.empty()) {
        drawing.arrow(point, end, free, 0.6);
    } else {
        const dvec2 first = sheet(met.front().share * toLight);
        drawing.line(first, end, hidden);
        drawing.arrow(point, first, blocked);
        drawing.circle(first, 10, blocked.color, {"#ffffff", 2, false}, "blocker");
        labels.avoid({first - 11.0, dvec2(22)});
        labels.place(drawing, first, met.front().object, {.size = kShadowRayLetter, .isBold = true, .color = "#a04000"}, 16);
    }
    drawing.circle(point, 9, "#1a1a1a", {"#ffffff", 2, false}, "point");
    labels.avoid({point - 10.0, dvec2(20)});
    labels.place(drawing, point, "point", {.size = kShadowRayLetter, .isBold = true}, 14);
    if (lightIsSeen) {
        drawing.circle(end, 15, drawing::colorText(look::kChosenLight), {"#1a1a1a", 3, false}, "light");
        labels.avoid({end - 17.0, dvec2(34)});
        labels.place(drawing, end, "light source", {.size = kShadowRayLetter, .isBold = true}, 20);
    } else {
        sheet.drawLight(drawing, labels);
    }
    if (sheet.shows(sheet.eye())) {
        drawing.circle(eye, 11, "#ffffff", {"#1a1a1a", 4, false}, "eye");
        labels.avoid({eye - 13.0, dvec2(26)});
        labels.place(drawing, eye, "view point", {.size = kShadowRayLetter, .isBold = true}, 16);
    } else {
        sheet.drawEye(drawing, labels);
    }
    drawing.rectangle(field.corner, field.size, "none", {"#bfbfbf", 2, false});
    const std::string verdict = met.empty() ? "The segment meets nothing: illuminated"
                                            : "The segment meets the " + met.front().object + ": in shadow";
    const double wide = 1.12 * drawing::textSize(source.font, verdict, kShadowRayLetter).x; // bold letters are that much wider
    drawing.text(area.corner + dvec2(0, field.size.y + 46), verdict,
                 {.size = kShadowRayLetter * std::min(1.0, area.size.x / wide), .isBold = true});
    return {std::move(drawing), "The segment from a point to the light source, and what it meets", sheet.scale()};
}

} // namespace shadowlab::figures
