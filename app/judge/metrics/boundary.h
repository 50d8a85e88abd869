// Boundaries of shadows in a picture: where they are, how long, how far one is from another.
//
// The boundary is made of the edges between neighbouring pixels of which one is lit and the other in shadow, on one and
// the same receiver. Where an object ends, or turns away from the light, no shadow ends.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "app/judge/grid.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::judge {

enum class Shade : std::uint8_t { outside, turnedAway, shadowed, lit };

/// The middle of an edge between two pixels, in half pixels from the upper left corner: (2x + 1, 2y + 1) is the centre
/// of pixel (x, y), so one coordinate is even and the other odd.
using BoundaryEdge = ivec2;

/// All edges between 4-neighbours with the same receiver, one lit and the other shadowed.
std::vector<BoundaryEdge> boundaryEdges(const Grid<Shade>& shades, const Grid<std::uint32_t>& receivers);

/// Length of the boundary in pixels. The edges form a staircase, which is longer than the line that it follows: by
/// |cos a| + |sin a| for a line at the angle a, 4/pi on average over all angles. So it is their number times pi/4.
double lengthPx(const std::vector<BoundaryEdge>& edges);

/// Distance in pixels from every pixel's centre to the middle of the nearest edge; infinite without any edge. A pixel
/// beside the boundary is half a pixel away, the next one in a straight line one and a half. Throws trace::Stopped soon
/// after `stop` was asked for.
Grid<float> distanceToBoundary(const std::vector<BoundaryEdge>& edges, ivec2 size, const std::stop_token& stop = {});

/// Distances in pixels between two boundaries: from each edge of one to the nearest of the other, both ways together.
struct Displacement {
    double mean = 0, p95 = 0, max = 0;
};
/// Nothing when one of the two has no edges.
std::optional<Displacement> displacement(const std::vector<BoundaryEdge>& truth,
                                         const std::vector<BoundaryEdge>& technique, ivec2 size);

/// Farther from the boundary, aliasing explains no error: beside it the centres of pixels are 0.5 and 1.5 px away, so
/// that is one pixel of slack.
constexpr double kCorePx = 1.5;

/// Wrong pixels farther from the boundary than aliasing can explain: more than kCorePx, and more than 1.5 texels
/// where `texelPx` says how many pixels a texel of a shadow map covers there (0: unknown). What is left is a wrong
/// algorithm.
int coreErrors(const Grid<std::uint8_t>& wrong, const Grid<float>& distancePx,
               const std::optional<Grid<float>>& texelPx);

} // namespace shadowlab::judge
