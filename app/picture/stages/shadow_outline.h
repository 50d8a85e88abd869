// The stage `shadow-outline`: where the light's shadows really end, as a line over a technique's own picture. No OpenGL.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/judge/outline.h"
#include "app/picture/figure.h"

namespace shadowlab::picture {

/// The finished picture, and on it the outline, about 1/360 of the height wide, with a dark rim: it is seen on lit and on
/// dark ground. It is drawn within the region only, and the legend gives its length there.
Panel shadowOutlinePanel(image::Image picture, const std::vector<judge::OutlineSegment>& outline,
                         const std::string& light, const Region& region);

} // namespace shadowlab::picture
