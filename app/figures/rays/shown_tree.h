// Which rays of a tree a drawing shows: a tree of glass has dozens of them, and a page has room for a few.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/probe.h"

namespace shadowlab::figures {

struct ShownTree {
    std::vector<int> rays;       ///< places in the probe's tree, rising; shadow rays are not among them
    int leftOut = 0;             ///< rays
    double largestLeftOut = 0;   ///< share of the pixel that one of them carries at most
    std::vector<int> shadowRays; ///< of the light that was asked for, from the surfaces that are shown

    [[nodiscard]] bool shows(int ray) const;
};

// As many as can be distinguished on a slide.
constexpr int kMostEnds = 8, kMostLevels = 6;

/// The rays that carry the largest shares of the pixel, each with all those it comes from.
ShownTree shownTree(const Probe& probe, int mostEnds = kMostEnds, int mostLevels = kMostLevels);

} // namespace shadowlab::figures
