// The region of a picture where most is wrong.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/foreign/evidence.h"

namespace shadowlab::foreign {

struct Region {
    ivec2 corner{0}, size{0};   ///< the box around it
    int pixels = 0;             ///< that are wrong
    int falseLit = 0, falseShadow = 0;
    int core = 0;               ///< farther than a pixel and a half from any true boundary
    ivec2 firstWrong{0};        ///< in reading order: of its core errors, if there are any
    std::string object;         ///< on which most of them lie
};

/// Wrong pixels no more than three apart belong together, so that dispersed ones are one region. Of all regions that with most core
/// errors, and of those alike the one with most wrong pixels. Nothing where none is wrong.
std::optional<Region> worstRegion(const Evidence& evidence);

/// Of each sample of the evidence, 1 if it lies in the region's box.
std::vector<std::uint8_t> samplesIn(const Evidence& evidence, const Region& region);

} // namespace shadowlab::foreign
