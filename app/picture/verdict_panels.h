// Pictures of the truth and of verdicts, each with the key to its colours. No OpenGL, so that
// any thread can draw them. The stages `truth` and `error` are these.
//
// All are as large as the truth; outside the region nothing is drawn.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/judge/verdict.h"
#include "app/picture/figure.h"
#include "app/picture/wrong_marks.h"

namespace shadowlab::picture {

/// Lit, in shadow, turned away, tie: a colour for each, and how many pixels have it. Of a truth about an area, between lit and in
/// shadow: mixed, as much of each as is seen.
Panel truthPanel(const judge::Truth& truth, const Region& region);

/// What is wrong, in colours, and nothing where the technique is right: to be laid over a picture. A wrong pixel that stands alone
/// is drawn as a square of that width (wrong_marks.h); the key counts pixels, and says how they are drawn.
Panel errorOverlay(const judge::Truth& truth, const judge::Judgement& judgement, const Region& region, int markWidth = kOnePixel);

/// The picture without its colours, and on it every pixel that is wrong. Outside the region it stays as it is.
Panel errorPanel(image::Image picture, const judge::Truth& truth, const judge::Judgement& judgement, const Region& region,
                 int markWidth = kOnePixel);

} // namespace shadowlab::picture
