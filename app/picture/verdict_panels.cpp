// SPDX-License-Identifier: MIT
#include "app/picture/verdict_panels.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {

namespace {

using judge::Verdict;
using trace::Visibility;

constexpr float kRim = 0.3f; ///< of the light, on the outlines of objects

// The desaturated picture under errors is lifted to this share of white and up: what is wrong mostly lies in shadow, and
// blue on near-black would be lost on a projector.
constexpr float kErrorGround = 0.3f;

/// A meaning and its colour; how many pixels have it is counted while drawing.
struct Meaning {
    vec3 colorLinear;
    const char* label;
    int pixels = 0;
};

std::vector<KeyEntry> keyOfVerdicts(std::span<const Meaning> meanings) {
    std::vector<KeyEntry> key;
    for (const Meaning& meaning : meanings)
        if (meaning.label)
            key.push_back(
                {meaning.colorLinear, std::string(meaning.label) + ": " + std::to_string(meaning.pixels) + " px"});
    return key;
}

/// Brightness alone, on the lifted ground.
image::Color8 withoutColor(const image::Color8& c) {
    const float luminance = 0.2126f * image::linearFromSrgb(c.r) + 0.7152f * image::linearFromSrgb(c.g) +
                            0.0722f * image::linearFromSrgb(c.b);
    return image::encoded(vec3(glm::mix(kErrorGround, 1.0f, luminance)));
}

template <typename Visit>
void forEachShown(const Region& region, ivec2 size, const Visit& visit) {
    const auto [corner, extent] = judge::shownPart(region, size);
    for (int y = corner.y; y < corner.y + extent.y; ++y)
        for (int x = corner.x; x < corner.x + extent.x; ++x)
            visit(x, y);
}

Panel emptyPanel(ivec2 size) { return {image::Image(size.x, size.y), "", StageKind::swatches, {}}; }

} // namespace

Panel truthPanel(const judge::Truth& truth, const Region& region) {
    const bool area = !truth.shares.empty();
    std::array<Meaning, 5> meanings = {{{look::kLit, area ? "more than half of the light is seen" : "lit"},
                                        {look::kShadowed, area ? "half of it, or less" : "in shadow"},
                                        {look::kTurnedAway, "turned away from the light"},
                                        {look::kTie, "tie"},
                                        {look::kNoSurface, nullptr}}};
    Panel panel = emptyPanel(truth.size);
    forEachShown(region, truth.size, [&](int x, int y) {
        const std::size_t i = truth.index(x, y);
        const Visibility seen = truth.visibility[i];
        Meaning& meaning = meanings[truth.ties[i] && seen != Visibility::noSurface ? 3
                                    : seen == Visibility::lit                      ? 0
                                    : seen == Visibility::shadowed                 ? 1
                                    : seen == Visibility::turnedAway               ? 2
                                                                                   : 4];
        ++meaning.pixels;
        const bool shared = area && !truth.ties[i] && (seen == Visibility::lit || seen == Visibility::shadowed);
        const vec3 color = shared ? glm::mix(look::kShadowed, look::kLit, truth.shares[i]) : meaning.colorLinear;
        // Where one object ends and another begins, a darker line: else lit things would merge with a lit ground.
        const bool rim = (x + 1 < truth.size.x && truth.objects[truth.index(x + 1, y)] != truth.objects[i]) ||
                         (y + 1 < truth.size.y && truth.objects[truth.index(x, y + 1)] != truth.objects[i]);
        panel.picture.set(x, y, image::encoded(color * (rim ? kRim : 1.0f)));
    });
    panel.display.key = keyOfVerdicts(meanings);
    return panel;
}

Panel errorOverlay(const judge::Truth& truth, const judge::Judgement& judgement, const Region& region, int markWidth) {
    std::array<Meaning, 4> meanings = {{{look::kFalseLit, "false lit (should be in shadow)"},
                                        {look::kFalseShadow, "false shadow (should be lit)"},
                                        {look::kTieOnPicture, "tie"},
                                        {look::kStray, nullptr}}};
    Meaning &falseLit = meanings[0], &falseShadow = meanings[1], &tie = meanings[2], &stray = meanings[3];
    std::vector<std::uint8_t> isWrong(judgement.verdicts.size());
    Panel panel = emptyPanel(truth.size);
    forEachShown(region, truth.size, [&](int x, int y) {
        const std::size_t i = truth.index(x, y);
        const Verdict verdict = judgement.verdicts[i];
        falseLit.pixels += verdict == Verdict::falseLit;
        falseShadow.pixels += verdict == Verdict::falseShadow;
        stray.pixels += verdict == Verdict::stray;
        isWrong[i] = verdict == Verdict::falseLit || verdict == Verdict::falseShadow || verdict == Verdict::stray;
        if (verdict != Verdict::tie) return;
        tie.pixels += truth.visibility[i] != Visibility::noSurface;
        panel.picture.set(x, y, image::encoded(tie.colorLinear));
    });
    if (stray.pixels > 0) stray.label = "surface where there is none"; // only named where there is one: hardly ever
    const WrongMarks marks = wrongMarks(isWrong, truth.size, markWidth);
    forEachShown(region, truth.size, [&](int x, int y) {
        const std::int32_t owner = marks.owner[truth.index(x, y)];
        if (owner == WrongMarks::kNone) return;
        const Verdict verdict = judgement.verdicts[static_cast<std::size_t>(owner)];
        const Meaning& meaning = verdict == Verdict::falseLit ? falseLit : verdict == Verdict::falseShadow ? falseShadow : stray;
        panel.picture.set(x, y, image::encoded(meaning.colorLinear));
    });
    panel.display.key = keyOfVerdicts(meanings);
    if (const std::string note = noteOf(marks, markWidth); !note.empty()) panel.display.key.back().label += "\n" + note;
    return panel;
}

Panel errorPanel(image::Image picture, const judge::Truth& truth, const judge::Judgement& judgement, const Region& region,
                 int markWidth) {
    Panel panel = errorOverlay(truth, judgement, region, markWidth);
    forEachShown(region, truth.size, [&](int x, int y) {
        const image::Color8 over = panel.picture.at(x, y);
        picture.set(x, y, over.a ? over : withoutColor(picture.at(x, y)));
    });
    panel.picture = std::move(picture);
    return panel;
}

} // namespace shadowlab::picture
