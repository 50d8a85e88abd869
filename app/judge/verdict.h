// A technique's visibility image compared with the truth: a verdict per pixel, and their counts.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "app/judge/truth.h"
#include "techniques/technique.h"

namespace shadowlab::judge {

enum class Verdict : std::uint8_t {
    background,  ///< nothing is seen, and nothing was claimed
    correct,     ///< the right side of one half
    falseLit,    ///< lit, but should be dark: a missed shadow, a light leak
    falseShadow, ///< dark, but should be lit: acne
    tie,         ///< the truth changes within the tie radius: no verdict
    stray,       ///< a surface where there is none
};

/// A pixel that counts against the technique: lit or dark where it should be the other, or a surface where there is none.
bool isWrong(Verdict verdict);

struct Counts {
    int pixels = 0; ///< with a surface: lit + shadowed + turnedAway + ties
    int lit = 0, shadowed = 0, turnedAway = 0, ties = 0;
    int falseLit = 0, falseShadow = 0;
    int stray = 0;   ///< pixels with a surface where there is none, outside ties
    double rmse = 0; ///< of visibility 0..1, over lit, shadowed and turned away pixels

    [[nodiscard]] int wrong() const { return falseLit + falseShadow; }
    /// Without lit pixels, or without shadowed ones, a wrong technique could not have been noticed.
    [[nodiscard]] bool provesNothing() const { return lit == 0 || shadowed == 0; }
};

struct Judgement {
    std::vector<Verdict> verdicts; ///< per pixel of the truth, rows from the top; outside the region all background
    Counts counts;
};

/// `greyAlpha` is a visibility image (picture::VisibilityImage): two bytes a pixel. More than half visible is lit. A
/// pixel that the technique left without a surface, where there is one, is wrong whatever the truth: false shadow where
/// it is lit, else false lit. With a region, the image has the region's pixels only, and nothing else is judged or
/// counted.
Judgement judge(const Truth& truth, std::span<const std::uint8_t> greyAlpha, const Region& region = {});

/// The pixels that a region stands for, in a picture of that size: those the picture has, and all of them where the
/// region is empty.
Region shownPart(const Region& region, ivec2 size);

} // namespace shadowlab::judge
