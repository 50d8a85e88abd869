// "Gloss" and "Translucency": the rays that a rough surface sends on, around the ideal direction, in the plane of incidence.
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

constexpr double kLobeLetter = 34;   ///< em of a vector's letter
constexpr double kIncoming = 0.92;   ///< of the length of a ray: the others begin where it ends
constexpr double kIdeal = 1.2;       ///< the ideal ray ends beyond those around it, so that its head is seen
constexpr double kNormalShare = 0.8; ///< of the same

struct Lobe {
    const char *letter, *name, *material;
    double degrees;
    std::string color;
    std::vector<dvec3> raysWorld;
};

const dvec3& vectorOf(const FigureSource& source, const char* letter) {
    for (const Probe::Vector& vector : source.probe.vectors)
        if (vector.label == letter) return vector.directionWorld;
    throw Error(ExitStatus::badInput, std::string("the surface at the pixel sends no ") +
                                          (letter[0] == 'R' ? "reflection" : "refraction") + " rays; choose another");
}

Diagram drawLobe(const FigureSource& source, const Lobe& lobe) {
    const dvec3 idealWorld = vectorOf(source, lobe.letter), u = vectorOf(source, "u");
    if (lobe.degrees <= 0)
        throw Error(ExitStatus::badInput, std::string("the surface at the pixel spreads no rays; choose one whose "
                                                      "material has ") +
                                              lobe.material);
    drawing::Drawing drawing(source.size);
    const drawing::Box room = writeFoot(drawing, roomOf(source),
                               "S1: " + source.probe.tree.front().object + ". Thin: the " +
                                   std::to_string(lobe.raysWorld.size()) + " rays of this pixel, in the plane of u and N. At " +
                                   fourDigits(lobe.degrees) + "\u00b0 from " + lobe.letter +
                                   " they are half as dense as around it.",
                               source.font);
    const DrawingPlane plane = planeWithNormalUp(source.probe);
    const auto toward = [&](const dvec3& directionWorld) {
        const dvec2 flat = plane.ofDirection(directionWorld);
        return dvec2(flat.x, -flat.y);
    };
    // As large as all ends allow, in units of a ray's length.
    std::vector<dvec2> ends{-kIncoming * toward(u), kIdeal * toward(idealWorld), dvec2(0, -kNormalShare),
                            dvec2(0, 0.12)};
    for (const dvec3& ray : lobe.raysWorld)
        ends.push_back(toward(ray));
    dvec2 low(0.0), high(0.0);
    for (const dvec2& end : ends) {
        low = glm::min(low, end);
        high = glm::max(high, end);
    }
    const dvec2 margin(90, 56);
    const double unit =
        std::min((room.size.x - 2 * margin.x) / (high.x - low.x), (room.size.y - 2 * margin.y) / (high.y - low.y));
    const dvec2 at = room.corner + 0.5 * room.size - 0.5 * unit * (low + high);

    drawing::Labels labels(source.fonts(), room);
    const dvec2 half(0.46 * room.size.x, 0);
    const double left = std::max(room.corner.x + 20, at.x - half.x),
                 right = std::min(room.corner.x + room.size.x - 20, at.x + half.x);
    drawing.line({left, at.y}, {right, at.y}, {"#8c8c8c", 6, false});
    labels.avoid({left, at.y}, {right, at.y});
    for (const dvec3& ray : lobe.raysWorld) {
        drawing.arrow(at, at + unit * toward(ray), thinStroke(lobe.color));
        labels.avoid(at, at + unit * toward(ray));
    }
    const auto vector = [&](const dvec2& from, const dvec2& to, const drawing::Stroke& stroke) {
        drawing.arrow(from, to, stroke);
        labels.avoid(from, to);
    };
    vector(at, at - dvec2(0, kNormalShare * unit), {"#4d4d4d", 4, false});
    vector(at - kIncoming * unit * toward(u), at, {"#1a1a1a", 5, false});
    vector(at, at + kIdeal * unit * toward(idealWorld), {lobe.color, 5, false});
    drawing.circle(at, 8, "#1a1a1a", {"#ffffff", 2, false}, "surface");
    labels.avoid({at - 9.0, dvec2(18)});
    const drawing::TextStyle letter{.size = kLobeLetter, .isBold = true, .isItalic = true};
    labels.place(drawing, at - dvec2(0, kNormalShare * unit), "N", letter, 10);
    labels.place(drawing, at + kIdeal * unit * toward(idealWorld), lobe.letter, letter, 12);
    labels.place(drawing, at - 0.25 * kIncoming * unit * toward(u), "u", letter, 12);
    labels.place(drawing, at - 0.62 * kIncoming * unit * toward(u), "incoming ray", {kText}, 12);
    labels.place(drawing, at + 0.5 * unit * toward(idealWorld), lobe.name, {kText}, 26);
    labels.place(drawing, at, "S1", {.size = kText, .isBold = true}, 12);
    return {std::move(drawing), std::string(lobe.name) + " around the ideal direction " + lobe.letter};
}

/// Of the samples that meet the surface that the pixel's middle shows.
std::vector<dvec3> sentOn(const FigureSource& source, std::optional<dvec3> RaysProbe::Sample::*way) {
    std::vector<dvec3> rays;
    for (const RaysProbe::Sample& sample : source.probe.find<RaysProbe>()->samples)
        if (sample.object == source.probe.tree.front().object && (sample.*way)) rays.push_back(*(sample.*way));
    return rays;
}

} // namespace

Diagram drawGloss(const FigureSource& source) {
    treeOf(source);
    const RaysProbe& rays = samplesOf(source);
    return drawLobe(source, {"R", "reflected rays", "glossDegrees", rays.glossDegrees, drawing::colorText(look::kReflectionRay),
                             sentOn(source, &RaysProbe::Sample::reflectedWorld)});
}

Diagram drawTranslucency(const FigureSource& source) {
    treeOf(source);
    const RaysProbe& rays = samplesOf(source);
    return drawLobe(source, {"T", "refracted rays", "translucencyDegrees", rays.translucencyDegrees,
                             drawing::colorText(look::kRefractionRay), sentOn(source, &RaysProbe::Sample::refractedWorld)});
}

} // namespace shadowlab::figures
