// The lectures' drawings of a pixel, made from a pixel of a scene. Where rays are followed: their paths, their tree, and the
// vectors where the first of them ends. Where patches send each other light: the angles of a form factor, and the directions
// that a Lambertian reflector sends its light in.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/drawing/drawing.h"
#include "techniques/foundation/image/text.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/probe.h"

namespace shadowlab::figures {

/// Has the probe a tree or patches? Else there is nothing to draw.
bool canDraw(const Probe& probe);

struct Diagram {
    drawing::Drawing drawing;
    std::string title;         ///< what it is, for who cannot see it
    double pixelsPerMetre = 0; ///< of its scale, where it has one that neighbours can share: FigureSource::mostPixelsPerMetre
    [[nodiscard]] std::string document() const { return drawing.document(title); }
};

/// A sheet is as wide as a slide, and drawings of the plane through eye, light and point are as high as one.
constexpr double kSheetWidth = 1920, kSectionHeight = 1080;
/// The least width of a sheet of the probe: in a narrow room type is larger on a narrow sheet. Only that of a shadow map without a filter
/// can be narrower than 1920.
double leastWidth(const Probe& probe);

/// One sheet of panels, those that the probe has something for: canDraw() must hold, and the first ray of a tree meet a
/// surface. `font` is DejaVu Sans, which the document names: labels are placed by its measures. Same input, same
/// bytes. `sectionWidth`: from leastWidth() to 1920.
Diagram pixelDiagram(const Probe& probe, const scene::Scene& scene, const image::Font& font,
                     double sectionHeight = kSectionHeight, double sectionWidth = kSheetWidth);

} // namespace shadowlab::figures
