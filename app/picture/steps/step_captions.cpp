// SPDX-License-Identifier: MIT
#include "app/picture/steps/step_captions.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::picture {

namespace {

// Shares of the picture's height; 1/45 is what is still read from the last row of a lecture hall.
constexpr double kTitleShare = 1.0 / 27, kSmallShare = 1.0 / 40;
constexpr double kSmallestCaption = 10; ///< pixels; below, letters dissolve
constexpr image::Color8 kCaptionGround{16, 16, 18, 255}, kCaptionText{245, 245, 245, 255},
    kAccent{0xE6, 0x9F, 0x00, 255};

} // namespace

StepCaptions::StepCaptions(const TechniqueInfo& info, const std::vector<StageKey>& passes, const scene::Scene& scene,
                           const image::Font& font, ivec2 size)
    : font_(font), smallEm_(std::max(kSmallestCaption, size.y * kSmallShare)),
      em_(std::max(kSmallestCaption, size.y * kTitleShare)), margin_(static_cast<int>(std::lround(em_ / 2))) {
    std::size_t lines = 1;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const StageKey& pass = passes[i];
        std::string which = "Step " + std::to_string(i + 1) + " of " + std::to_string(passes.size());
        if (pass.light != kNoLight && scene.lights.size() > 1) which += ", light " + scene.light(pass.light).name;
        which += "  ·  " + std::string(info.title);
        captions_.push_back(
            {std::move(which), font.wrap(passInfo(info.passes, pass.id).title, em_, size.x - 2 * margin_)});
        lines = std::max(lines, captions_.back().title.size());
    }
    height_ = font.measure("Step", smallEm_).height + static_cast<int>(lines) * font.measure("Step", em_).height +
              2 * margin_;
}

image::Image StepCaptions::below(const image::Image& picture, std::size_t step, const std::string& note) const {
    image::Image whole(picture.width, picture.height + height_, kCaptionGround);
    image::blit(whole, 0, 0, picture);
    const Caption& caption = captions_[step];
    int y = picture.height + margin_;
    y += font_.draw(whole, margin_, y, caption.which + (note.empty() ? "" : "  ·  " + note), smallEm_, kAccent).height;
    for (const std::string& line : caption.title)
        y += font_.draw(whole, margin_, y, line, em_, kCaptionText).height;
    return whole;
}

} // namespace shadowlab::picture
