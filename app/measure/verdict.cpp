// SPDX-License-Identifier: MIT
#include "app/measure/verdict.h"

#include <cmath>

namespace shadowlab::measure {

namespace {

using trace::Visibility;

Verdict verdictOf(Visibility truth, bool covered, bool lit) {
    if (truth == Visibility::noSurface) return covered ? Verdict::stray : Verdict::background;
    const bool shouldBeLit = truth == Visibility::lit;
    if (covered && lit == shouldBeLit) return Verdict::correct;
    return shouldBeLit ? Verdict::falseShadow : Verdict::falseLit;
}

} // namespace

Judgement judge(const Truth& truth, std::span<const std::uint8_t> greyAlpha) {
    Judgement judgement;
    Counts& counts = judgement.counts;
    double squares = 0;
    judgement.verdicts.reserve(truth.visibility.size());
    for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
        const Visibility expected = truth.visibility[i];
        const std::uint8_t grey = greyAlpha[2 * i];
        const bool covered = greyAlpha[2 * i + 1] == 255;
        const bool surface = expected != Visibility::noSurface, tie = truth.ties[i] != 0;
        const Verdict verdict = tie ? Verdict::tie : verdictOf(expected, covered, grey > 127);
        judgement.verdicts.push_back(verdict);
        counts.pixels += surface;
        counts.stray += verdict == Verdict::stray;
        counts.falseLit += verdict == Verdict::falseLit;
        counts.falseShadow += verdict == Verdict::falseShadow;
        if (!surface) continue;
        if (tie) {
            ++counts.ties;
            continue;
        }
        counts.lit += expected == Visibility::lit;
        counts.shadowed += expected == Visibility::shadowed;
        counts.turnedAway += expected == Visibility::turnedAway;
        const double error = grey / 255.0 - (expected == Visibility::lit ? 1.0 : 0.0);
        squares += error * error;
    }
    const int judged = counts.lit + counts.shadowed + counts.turnedAway;
    counts.rmse = judged > 0 ? std::sqrt(squares / judged) : 0.0;
    return judgement;
}

} // namespace shadowlab::measure
