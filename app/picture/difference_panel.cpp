// SPDX-License-Identifier: MIT
#include "app/picture/difference_panel.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "app/picture/stage_ref.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {

namespace {

using judge::Verdict;

// The same ground as under errors (verdict_panels): dark things are lifted, so that colours on them are seen.
constexpr float kDarkestGround = 0.3f;

} // namespace

Panel differencePanel(image::Image ground, const std::array<const judge::Judgement*, 2>& judgements,
                      const std::array<std::string, 2>& titles, int markWidth) {
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
    const auto meaningAt = [&](std::size_t pixel) -> Meaning& {
        const std::array<Verdict, 2> verdicts = {judgements[0]->verdicts[pixel], judgements[1]->verdicts[pixel]};
        const std::size_t slot = judge::isWrong(verdicts[0]) ? 0 : 1;
        if (slot == 0 && judge::isWrong(verdicts[1])) return meanings[4];
        return meanings[verdicts[slot] == Verdict::falseShadow ? 2 * slot + 1 : 2 * slot];
    };
    std::vector<std::uint8_t> isMarked(judgements[0]->verdicts.size());
    for (std::size_t i = 0; i < isMarked.size(); ++i) {
        isMarked[i] = judge::isWrong(judgements[0]->verdicts[i]) || judge::isWrong(judgements[1]->verdicts[i]);
        if (isMarked[i]) ++meaningAt(i).pixels;
    }
    const WrongMarks marks = wrongMarks(isMarked, {ground.width, ground.height}, markWidth);
    for (int y = 0; y < ground.height; ++y)
        for (int x = 0; x < ground.width; ++x) {
            const std::int32_t owner =
                marks.owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(ground.width) + static_cast<std::size_t>(x)];
            if (owner != WrongMarks::kNone) {
                ground.set(x, y, image::encoded(meaningAt(static_cast<std::size_t>(owner)).color));
                continue;
            }
            const image::Color8 c = ground.at(x, y);
            const float luminance = 0.2126f * image::linearFromSrgb(c.r) + 0.7152f * image::linearFromSrgb(c.g) +
                                    0.0722f * image::linearFromSrgb(c.b);
            ground.set(x, y, image::encoded(vec3(glm::mix(kDarkestGround, 1.0f, luminance))));
        }
    Panel panel{std::move(ground), "", StageKind::swatches, {}};
    for (const Meaning& meaning : meanings)
        panel.display.key.push_back({meaning.color, meaning.label + ": " + std::to_string(meaning.pixels) + " px"});
    if (const std::string note = noteOf(marks, markWidth); !note.empty()) panel.display.key.back().label += "\n" + note;
    return panel;
}

RenderedDifference renderDifference(Session& session, std::span<Slot> slots, const PictureEncoder& encoder, const View& view,
                                    int light, int markWidth, bool timePasses) {
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
                        {std::string(slots[0].info->title), std::string(slots[1].info->title)}, markWidth);
    return difference;
}

} // namespace shadowlab::picture
