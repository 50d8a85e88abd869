// What the figures have in common: what a probe must hold for them, and how they look.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/drawing/labels.h"
#include "app/figures/figures.h"
#include "techniques/probed/rays_probe.h"

namespace shadowlab::figures {

constexpr double kFigureBorder = 24; ///< pixels of a figure's room that stay empty on all sides

/// The room of a figure without its border.
drawing::Box roomOf(const FigureSource& source);

/// What the pixel's ray meets must be a surface: throws Error (badInput) for the background.
const Probe::Segment& eyeRayOf(const FigureSource& source);
/// The tree of a pixel's rays; throws Error (badInput) for the background, and for techniques that have none.
const std::vector<Probe::Node>& treeOf(const FigureSource& source);
/// The samples of a pixel; throws Error (badInput) where there is but one ray, and for techniques that send none.
const RaysProbe& samplesOf(const FigureSource& source);
/// The light that is asked about; throws Error (badInput) if it has no area.
const scene::Light& areaLightOf(const FigureSource& source);

/// "#0072b2": linear light as a picture of the scene shows it.
std::string shownColor(const dvec3& intensity, double exposure);

/// Thin lines of which many lie side by side.
drawing::Stroke thinStroke(const std::string& color);

/// "3 rays", "1 ray"
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// Lines of quiet text at the foot of the room; the room that is left above them.
drawing::Box writeFoot(drawing::Drawing& drawing, const drawing::Box& room, const std::string& text, const image::Font& font);

} // namespace shadowlab::figures
