// A technique's visibility held against the exact judge, pixel by pixel.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <ostream>

#include "app/session/picture.h"
#include "app/session/session.h"
#include "techniques/foundation/trace/exact_visibility.h"

namespace shadowlab::testing {

/// Counts over all pixels. `falseLit` and `falseShadow` do not include pixels whose truth changes within `tiePx` of the
/// centre; those that would be wrong but for that are counted as `ties`.
struct TruthComparison {
    int compared = 0, lit = 0, shadowed = 0, turnedAway = 0, background = 0;
    int ties = 0, falseLit = 0, falseShadow = 0, coverage = 0;
    [[nodiscard]] int wrong() const { return falseLit + falseShadow + coverage; }
    TruthComparison& operator+=(const TruthComparison& other);
};
std::ostream& operator<<(std::ostream& stream, const TruthComparison& comparison);

/// How far from its centre a pixel's truth may change for the pixel to be excused; the hit is absent on background.
using TieRadius = std::function<double(const std::optional<trace::EyeHit>&)>;

/// Renders the visibility stage through the session, in a fresh slot with settings "param=value", and compares.
/// A pixel is excused when the truth is another one anywhere on circles of radius up to the tie radius around its
/// centre.
TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light,
                                 const TieRadius& tieRadiusPx);
TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light, double tieRadiusPx);

/// The visibility image alone.
session::VisibilityImage renderVisibility(const scene::Snapshot& snapshot, const std::string& technique,
                                          const std::vector<std::string>& settings, ivec2 size, int light);

/// Two steps of the rasteriser's subpixel grid (GL_SUBPIXEL_BITS is 8 on Mesa's software renderers), and no less than
/// 1/64: nearer to an edge of the truth than this, no rasteriser promises on which side a pixel's centre falls.
inline constexpr double kTiePx = 1.0 / 64.0;

} // namespace shadowlab::testing
