// The exact outline of a light's shadows in a picture, as a line: where on the visible surfaces they begin.
//
// The boundary between pixels (boundary.h) is a staircase. Here each of its edges is divided with rays, between the two
// centres that see different things, until the place where the shadow begins is found to a small share of a pixel; the
// places of neighbouring edges are joined. It depends on no technique.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/judge/truth.h"

namespace shadowlab::judge {

/// Pixels from the upper left corner: (x + 0.5, y + 0.5) is the centre of pixel (x, y).
struct OutlineSegment {
    dvec2 from{0.0}, to{0.0};
};

/// How far the ends of the segments may be from the true outline, in pixels along a row or a column. Between its ends a
/// segment, which is never longer than a pixel's diagonal, cuts corners.
constexpr double kOutlineErrorPx = 1.0 / 128;

/// `centres` is what the pixels' centres see: truthAtCentres() or exactTruth() of that view. Outlines are where a shadow
/// ends on a surface; where one part of a surface hides another, one of them lit and the other in shadow, none does. What
/// is too thin to hold a pixel's centre has none, and what is a pixel long is left out. Ordered by rows, the same for any
/// number of threads.
std::vector<OutlineSegment> shadowOutline(const trace::SceneTracer& tracer, const scene::Camera& camera,
                                          const Truth& centres, int light);

/// Length of all of them together in pixels.
double lengthPx(const std::vector<OutlineSegment>& outline);

} // namespace shadowlab::judge
