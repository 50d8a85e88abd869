// The scene seen along one of its axes: boxes that lie along them are rectangles, and balls are circles.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/figures/figures.h"
#include "app/figures/parallel_view.h"

namespace shadowlab::figures {

/// The axis from which a ray is seen best from its side: 0 x, 1 y (from above), 2 z.
int axisAcross(const dvec3& rayWorld);

/// Seen along it, from the side on which the camera is; from above with the camera's way upward.
ParallelView viewAlong(int axis, const scene::Camera& camera);

/// The rectangle of the sheet that a box covers.
drawing::Box rectangleOf(const ParallelView& view, const dvec3& lowerWorld, const dvec3& upperWorld);

/// "from the side", "from above", "from the front"
std::string axisWords(int axis);

} // namespace shadowlab::figures
