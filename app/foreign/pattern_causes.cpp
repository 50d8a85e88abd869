// Mistakes that no rule predicts pixel by pixel, because they follow from where texels or samples happen to lie. They are known by
// their pattern: acne and holes are mixed with right pixels on all sides; the steps of texels go to and fro across a
// boundary; soft edges are neither black nor white.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/foreign/causes.h"
#include "app/picture/verdict_reasons.h"

namespace shadowlab::foreign {

namespace {

using judge::Verdict;

class Patterns {
public:
    explicit Patterns(const Evidence& evidence) : evidence_(evidence), size_(evidence.size()) {}

    /// Are there right and wrong pixels of the same surface on all sides of it? A solid region has sides that are all of one kind.
    [[nodiscard]] bool isDispersed(const Sample& sample) const {
        constexpr int kReach = 6; // pixels: stripes up to as wide
        const auto expected = evidence_.truth.visibility[sample.index];
        const std::uint32_t object = evidence_.truth.objects[sample.index];
        int quarters = 0, mixed = 0;
        for (const ivec2 way : {ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1)}) {
            int right = 0, wrong = 0;
            for (int y = 0; y <= kReach; ++y)
                for (int x = 0; x <= kReach; ++x) {
                    const ivec2 at = sample.pixel + way * ivec2(x, y);
                    if (!contains(at) || at == sample.pixel) continue;
                    const std::size_t i = evidence_.truth.index(at.x, at.y);
                    if (evidence_.truth.objects[i] != object || evidence_.truth.visibility[i] != expected || !evidence_.isJudged(i)) continue;
                    ++(evidence_.isLit(i) == sample.isLit ? wrong : right);
                }
            if (right + wrong < kReach) continue; // a corner of the surface says nothing
            ++quarters;
            mixed += right > 0 && wrong > 0;
        }
        return quarters >= 2 && mixed == quarters;
    }

    /// Near a boundary, with wrong pixels of both kinds about it on the same surface?
    [[nodiscard]] bool isAlternating(const Sample& sample, int reach) const {
        if (sample.boundaryPx > static_cast<float>(reach)) return false;
        int same = 0, other = 0;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const ivec2 at = sample.pixel + ivec2(x, y);
                if (!contains(at)) continue;
                const std::size_t i = evidence_.truth.index(at.x, at.y);
                const Verdict verdict = evidence_.judgement.verdicts[i];
                if (verdict != Verdict::falseLit && verdict != Verdict::falseShadow) continue;
                if (evidence_.truth.objects[i] != evidence_.truth.objects[sample.index]) continue;
                ++((verdict == Verdict::falseLit) == sample.isLit ? same : other);
            }
        // Of texels about as many are wrong to each side; a bias tips the scale, but not to one in seven.
        return other * 6 >= same && same + other >= 3;
    }

    /// Neither black nor white in the picture?
    [[nodiscard]] bool isSoft(const Sample& sample) const { return isSoft(sample.index); }
    [[nodiscard]] bool isSoft(std::size_t pixel) const {
        const int grey = evidence_.found.image.greyAlpha[2 * pixel];
        constexpr int kFromEnds = 25; // a tenth: noise and rounding of pairs stay below
        return grey > kFromEnds && grey < 255 - kFromEnds;
    }

    /// Pixels of the picture that are neither black nor white.
    [[nodiscard]] int softPixels() const {
        int count = 0;
        for (std::size_t i = 0; i < evidence_.truth.visibility.size(); ++i)
            count += evidence_.isJudged(i) && isSoft(i);
        return count;
    }

    /// How many patches of one kind the wrong pixels form along boundaries: with 8 neighbours.
    [[nodiscard]] int patches(int reach) const {
        judge::Grid<std::uint8_t> seen(size_.x, size_.y);
        int count = 0;
        std::vector<ivec2> open;
        for (int y = 0; y < size_.y; ++y)
            for (int x = 0; x < size_.x; ++x) {
                if (seen.at(x, y) || !isEdgeError({x, y}, reach)) continue;
                ++count;
                open.assign(1, {x, y});
                seen.at(x, y) = 1;
                const Verdict kind = verdictAt({x, y});
                while (!open.empty()) {
                    const ivec2 from = open.back();
                    open.pop_back();
                    for (int k = 0; k < 9; ++k) {
                        const ivec2 at = from + ivec2(k % 3 - 1, k / 3 - 1);
                        if (!contains(at) || seen.at(at.x, at.y) || !isEdgeError(at, reach) || verdictAt(at) != kind) continue;
                        seen.at(at.x, at.y) = 1;
                        open.push_back(at);
                    }
                }
            }
        return count;
    }

private:
    [[nodiscard]] bool contains(ivec2 at) const { return at.x >= 0 && at.y >= 0 && at.x < size_.x && at.y < size_.y; }
    [[nodiscard]] Verdict verdictAt(ivec2 at) const { return evidence_.judgement.verdicts[evidence_.truth.index(at.x, at.y)]; }
    [[nodiscard]] bool isEdgeError(ivec2 at, int reach) const {
        const Verdict verdict = verdictAt(at);
        return (verdict == Verdict::falseLit || verdict == Verdict::falseShadow) && evidence_.boundaryPx.at(at.x, at.y) <= static_cast<float>(reach);
    }

    const Evidence& evidence_;
    ivec2 size_;
};

/// What the picture shows where the pattern is, and the truth elsewhere.
Predictions wherePattern(const Evidence& evidence, const std::function<bool(const Sample&)>& isPattern) {
    return predictAll(evidence, [&](const Sample& sample) { return predicted(sample.isWrong() && isPattern(sample) ? sample.isLit : sample.shouldBeLit); });
}

/// `isOfItsKind`: the wrong pixels that the pattern is looked for among.
void addPattern(const Evidence& evidence, Cause cause, const std::function<bool(const Sample&)>& isOfItsKind, std::vector<Cause>& causes) {
    cause.hasRule = false;
    std::vector<std::uint8_t> ofItsKind;
    for (const Sample& sample : evidence.samples)
        ofItsKind.push_back(sample.isWrong() && isOfItsKind(sample) ? 1 : 0);
    cause.ofItsKind = explained(evidence, cause.predictions, ofItsKind);
    addIfExplains(evidence, std::move(cause), causes);
}

std::string pixelShare(const Evidence& evidence, const Predictions& predictions) {
    return percentText(explained(evidence, predictions)) + " of the wrong pixels";
}

/// How far texels reach across the true boundary: twice what three of four wrong pixels near it do.
int reachOfEdges(const Evidence& evidence) {
    // A texel that covers more is seen as such, and not as a boundary.
    const float kMostPx = static_cast<float>(evidence.size().y) / 15, kLeastPx = 3;
    std::vector<float> distances;
    for (const Sample& sample : evidence.samples)
        if (sample.isWrong() && sample.boundaryPx < kMostPx) distances.push_back(sample.boundaryPx);
    if (distances.empty()) return static_cast<int>(kLeastPx);
    std::ranges::sort(distances);
    return static_cast<int>(std::ceil(std::max(kLeastPx, 2 * distances[distances.size() * 3 / 4])));
}

/// `reach`: reachOfEdges().
void addSoftEdges(const Evidence& evidence, const Patterns& patterns, int reach, std::vector<Cause>& causes) {
    const double length = judge::lengthPx(evidence.boundary);
    // Antialiasing shares a pixel and its neighbour; what is wider is a filter over texels that are larger than pixels.
    constexpr double kOfAntialiasing = 2.1;
    const double widthPx = length > 0 ? patterns.softPixels() / length : 0;
    const bool wide = widthPx > kOfAntialiasing;
    Cause soft{wide ? "resolution" : "soft-edges", "", wide ? "use a map of more texels, or a narrower filter; a light without area has no penumbra" : "take one sample a pixel, at its centre, without antialiasing", {}};
    const auto isNear = [&](const Sample& s) { return wide ? s.boundaryPx <= static_cast<float>(reach) : s.boundaryPx <= judge::kCorePx; };
    soft.predictions = wherePattern(evidence, [&](const Sample& s) { return isNear(s) && patterns.isSoft(s); });
    soft.what = "edges are soft over " + picture::fixed(widthPx, 1) + " pixels: " + pixelShare(evidence, soft.predictions) + " are neither lit nor dark, but between";
    if (wide) soft.what += ", as of a filter over texels that cover several pixels";
    addPattern(evidence, std::move(soft), isNear, causes);
}

/// Of a light with an area: which side of one half a pixel is on is decided by samples.
void addHalfSeen(const Evidence& evidence, std::vector<Cause>& causes) {
    constexpr double kAboutHalf = 0.1; // of the light
    const auto isHalf = [&](const Sample& s) { return std::abs(evidence.truth.share(s.index) - 0.5) < kAboutHalf; };
    Cause cause{"penumbra-noise", "", "take more samples of the light for each pixel", {}};
    cause.predictions = wherePattern(evidence, isHalf);
    cause.what = "penumbras are uncertain: " + pixelShare(evidence, cause.predictions) + " see about half of the light, and samples or rounding decide";
    addPattern(evidence, std::move(cause), isHalf, causes);
}

} // namespace

void addPatternCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    const Patterns patterns(evidence);
    const auto isDarkened = [](const Sample& s) { return !s.isLit && s.boundaryPx > judge::kCorePx; };
    const auto isLightened = [](const Sample& s) { return s.isLit && s.boundaryPx > judge::kCorePx; };
    Cause acne{"acne", "", "raise the depth bias, let it grow with the slope and the texel, or leave out the surface that a shadow ray starts on", {}};
    acne.predictions = wherePattern(evidence, [&](const Sample& s) { return isDarkened(s) && patterns.isDispersed(s); });
    acne.what = "surfaces shadow themselves in a pattern: " + pixelShare(evidence, acne.predictions) +
                " are false shadow that is mixed with light on all sides, with no caster before them";
    addPattern(evidence, std::move(acne), isDarkened, causes);

    Cause holes{"holes", "", "look for cracks between volumes or triangles, noise of too few samples, or counts that overflow", {}};
    holes.predictions = wherePattern(evidence, [&](const Sample& s) { return isLightened(s) && patterns.isDispersed(s); });
    holes.what = "shadows have holes: " + pixelShare(evidence, holes.predictions) + " are lit in the midst of shadow, dispersed";
    addPattern(evidence, std::move(holes), isLightened, causes);

    const int reach = reachOfEdges(evidence), count = patterns.patches(reach);
    const auto isAtEdge = [reach](const Sample& s) { return s.boundaryPx <= static_cast<float>(reach); };
    constexpr int kFewest = 8; // fewer are no pattern
    Cause texels{"resolution", "", "use a map of more texels, or fit it more closely to what is seen", {}};
    texels.predictions = wherePattern(evidence, [&](const Sample& s) { return count >= kFewest && isAtEdge(s) && patterns.isAlternating(s, 2 * reach); });
    const double length = judge::lengthPx(evidence.boundary);
    texels.what = "the boundary goes to and fro in steps: " + pixelShare(evidence, texels.predictions) +
                  " are false light and false shadow in turn along it, in " + std::to_string(count) + " patches, one for each " +
                  picture::fixed(count > 0 ? 2 * length / count : 0, 1) + " pixels of boundary and side: texels of a shadow map are too coarse";
    addPattern(evidence, std::move(texels), isAtEdge, causes);

    if (evidence.truth.shares.empty())
        addSoftEdges(evidence, patterns, reach, causes);
    else
        addHalfSeen(evidence, causes);
}

} // namespace shadowlab::foreign
