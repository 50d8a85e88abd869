// How wrong a technique's picture of visibility is: by pixels, by the length of the shadows' boundary, and away from it.
// No OpenGL: `measure` computes it once for a picture, the window on a thread of its own as often as it can.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "app/judge/metrics/boundary.h"
#include "app/judge/verdict.h"

namespace shadowlab::judge {

struct SlotErrors {
    Judgement judgement;
    std::optional<double> edgeErrorPx; ///< none: the truth has no boundary there
};

/// Where the truth has the boundary of its shadows: made once, for all techniques that are compared with it.
std::vector<BoundaryEdge> trueBoundary(const Truth& truth);

/// Length in pixels of what lies in the region. An edge belongs to the pixel on its right or below it, so that the parts
/// of a picture add up to the whole.
double lengthPx(const std::vector<BoundaryEdge>& edges, const Region& region, ivec2 size);

/// `greyAlpha` has the pixels of the region, as for judge(); `boundary` is that of the whole truth. The edge error is the
/// number of wrong pixels in the region for each pixel of boundary in it.
SlotErrors slotErrors(const Truth& truth, const std::vector<BoundaryEdge>& boundary,
                      std::span<const std::uint8_t> greyAlpha, const Region& region = {});

/// Wrong pixels that are no aliasing: see coreErrors() in boundary.h. All three have the size of the truth.
int coreErrors(const Truth& truth, const Judgement& judgement, const Grid<float>& distancePx,
               const std::optional<Grid<float>>& texelPx);

/// How far the technique's boundary is from the true one, over a whole picture. The technique's answers are cut at one
/// half, and ties are as the truth has them: otherwise a single pixel that cannot be judged would count as a
/// boundary of its own, far from any other.
std::optional<Displacement> displacement(const Truth& truth, const std::vector<BoundaryEdge>& boundary,
                                         std::span<const std::uint8_t> greyAlpha);

} // namespace shadowlab::judge
