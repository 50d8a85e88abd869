// FLIP: how much of a difference does a viewer see when two pictures alternate in one place?
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator for Alternating
// Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2) (HPG), 2020. Two pipelines meet
// at the end: one compares colours after the eye's own blur, the other edges and points; where a feature differs, a
// difference of colour is seen more.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/judge/grid.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::judge {

/// What the paper takes as typical: a monitor 0.7 m wide with 3840 pixels, seen from 0.7 m.
constexpr double kPixelsPerDegree = 67.0;

struct Flip {
    Grid<float> map; ///< 0: no difference is seen, 1: as large as any
    double mean = 0;
};

/// Of two pictures of one size; their bytes are sRGB, their alpha is ignored. Symmetric.
Flip flip(const image::Image& reference, const image::Image& test, double pixelsPerDegree = kPixelsPerDegree);

} // namespace shadowlab::judge
