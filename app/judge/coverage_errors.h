// How far a technique's visibility is from the true coverage of its pixels (coverage.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "app/judge/coverage.h"

namespace shadowlab::judge {

/// Errors of visibility 0..1 over some pixels; all 0 where there is none.
struct ShareErrors {
    int pixels = 0;
    double rmse = 0, mean = 0, largest = 0; ///< root of the mean square, mean of the amounts, largest amount
};

struct CoverageErrors {
    int points = 0;  ///< of a pixel, that the truth is from
    int samples = 1; ///< on a side of a pixel, that the technique's answer is from
    ShareErrors all; ///< whole pixels, edges and outlines
    ShareErrors edge, outline;
};

/// A technique's answer for each pixel, rows from the top.
struct PixelAnswers {
    std::vector<float> visibility;      ///< 0..1
    std::vector<std::uint8_t> answered; ///< 1 where one of its samples shows a surface turned toward the light
};

/// Means over `samples` x `samples` pixels of a visibility image as many times as wide and as high. `facing`: facingCentres() of
/// that larger picture. What is turned away from the light is left out of the means, as it is of the coverage.
PixelAnswers meansOfSamples(std::span<const std::uint8_t> greyAlpha, std::span<const std::uint8_t> facing, ivec2 size,
                            int samples);

/// Compared are pixels in which both have an answer. A tie (truth.h) is compared as well, because a share does not jump where a
/// shadow's edge passes the centre; but not where all points agree: there the rasteriser shows another surface.
CoverageErrors coverageErrors(const Coverage& coverage, const PixelAnswers& answers, std::span<const std::uint8_t> ties,
                              int samples);

} // namespace shadowlab::judge
