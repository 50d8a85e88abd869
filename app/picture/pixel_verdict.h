// The verdict on one pixel in one sentence, and the sums that lead to it.
//
// The command line prints it first, and the window shows it beside the marked pixel: the same words in both.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/probe.h"

namespace shadowlab::picture {

/// Whether the light that is asked about reaches the pixel.
enum class PixelLight { lit, partlyLit, inShadow, turnedAway, unknown };

struct PixelVerdict {
    PixelLight light = PixelLight::unknown; ///< by the technique; by the exact answer where `isOfTechnique` is false
    bool isOfTechnique = false;             ///< the technique decided, and the probe could follow it
    bool isWrong = false;                   ///< the technique decided otherwise than the exact answer
    /// "IN SHADOW: entered 1, left 0", "FALSE LIT: nothing is stored in the texel (d = 1)". The part before the colon is in
    /// capital letters.
    std::string sentence;
    /// What a student works out to get there, a line each: "z-pass, eye to point: n_f - n_b = 1 - 0 = 1". May be empty.
    std::vector<std::string> sums;
};

/// Of a probe that a technique filled for one pixel and one light.
PixelVerdict pixelVerdict(const Probe& probe);

} // namespace shadowlab::picture
