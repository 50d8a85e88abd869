// SPDX-License-Identifier: MIT
#include "app/picture/difference_panel.h"

#include <utility>

#include "app/picture/stage_ref.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {

namespace {

using judge::Verdict;

// The same ground as under errors (verdict_panels): dark things are lifted, so that colours on them are seen.
constexpr float kDarkestGround = 0.3f;

bool isWrong(Verdict verdict) {
    return verdict == Verdict::falseLit || verdict == Verdict::falseShadow || verdict == Verdict::stray;
}

} // namespace

Panel differencePanel(image::Image ground, const std::array<const judge::Judgement*, 2>& judgements,
                      const std::array<std::string, 2>& titles) {
    // Warm: lit where it should be dark. Cold: dark where it should be lit. Light: the first. Deep: the second.
    struct Meaning {
        vec3 color;
        std::string label;
        int pixels = 0;
    };
    std::array<Meaning, 5> meanings = {{{look::kFalseLit, titles[0] + ": false lit"},
                                        {look::kFalseShadow, titles[0] + ": false shadow"},
                                        {look::kFalseLitSecond, titles[1] + ": false lit"},
                                        {look::kFalseShadowSecond, titles[1] + ": false shadow"},
                                        {look::kStray, "both wrong"}}};
    for (int y = 0; y < ground.height; ++y)
        for (int x = 0; x < ground.width; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(ground.width) + static_cast<std::size_t>(x);
            const std::array<Verdict, 2> verdicts = {judgements[0]->verdicts[i], judgements[1]->verdicts[i]};
            const bool first = isWrong(verdicts[0]), second = isWrong(verdicts[1]);
            if (!first && !second) {
                const image::Color8 c = ground.at(x, y);
                const float luminance = 0.2126f * image::linearFromSrgb(c.r) + 0.7152f * image::linearFromSrgb(c.g) +
                                        0.0722f * image::linearFromSrgb(c.b);
                ground.set(x, y, image::encoded(vec3(glm::mix(kDarkestGround, 1.0f, luminance))));
                continue;
            }
            const std::size_t slot = first ? 0 : 1;
            Meaning& meaning = meanings[first && second                          ? 4
                                        : verdicts[slot] == Verdict::falseShadow ? 2 * slot + 1
                                                                                 : 2 * slot];
            ++meaning.pixels;
            ground.set(x, y, image::encoded(meaning.color));
        }
    Panel panel{std::move(ground), "", StageKind::swatches, {}};
    for (const Meaning& meaning : meanings)
        panel.display.key.push_back({meaning.color, meaning.label + ": " + std::to_string(meaning.pixels) + " px"});
    return panel;
}

RenderedDifference renderDifference(Session& session, std::span<Slot> slots, const PictureEncoder& encoder, const View& view,
                                    int light, bool timePasses) {
    RenderedDifference difference;
    std::array<judge::Judgement, 2> judgements;
    for (std::size_t i = 0; i < judgements.size(); ++i) {
        FrameRequest request;
        request.timePasses = timePasses;
        request.stages = {visibilityOf(light)};
        difference.rendered[i] = session.render(slots[i], view, request);
        judgements[i] = judge::judge(session.truth(view, session.truthFor(slots[i], light)),
                                     readVisibility(findStage(difference.rendered[i], visibilityOf(light))).greyAlpha);
    }
    difference.panel =
        differencePanel(encoder.encode(slots[0].target.color, session.snapshot()->exposure), {&judgements[0], &judgements[1]},
                        {std::string(slots[0].info->title), std::string(slots[1].info->title)});
    return difference;
}

} // namespace shadowlab::picture
