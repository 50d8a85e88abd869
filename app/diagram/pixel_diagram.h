// The lecture's drawings of a pixel ray, made from a pixel of a scene: the paths of its rays, their tree, and the vectors
// where the first of them ends.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/image/text.h"
#include "techniques/foundation/scene/scene.h"
#include "techniques/probe.h"

namespace shadowlab::diagram {

/// One SVG document with three panels. The probe must have a tree whose first ray meets a surface. `font` is the one that
/// the document names, DejaVu Sans: labels are placed by its measures. Same input, same bytes.
std::string pixelDiagram(const Probe& probe, const scene::Scene& scene, const image::Font& font);

} // namespace shadowlab::diagram
