// How wrong one point is: its visibility compared with the truth, and two small pictures of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/picture/judged_slot.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/report/results.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::report {

/// Width in pixels of the pictures behind each point: a page of some hundred points stays below what a browser opens at once.
constexpr int kPictureWidth = 320;

/// A whole number of pixels to one, so that the smaller picture is at least that wide. Mean in linear light.
image::Image reduced(const image::Image& picture, int width = kPictureWidth);

/// Where a technique is right and wrong, a colour for each pixel; reduced like the picture, but a wrong pixel keeps its colour
/// however many right ones it shares its place with.
image::Image errorMap(const judge::Truth& truth, const judge::Judgement& judgement, int width = kPictureWidth);

/// Judges the points of one view of one light. Needs a current GL context.
class Judge {
public:
    /// The session shows the scene, and lives as long as the judge.
    Judge(picture::Session& session, const View& view, int light);

    struct Judged {
        Errors errors;
        std::vector<std::uint8_t> picturePng, errorPng;
    };
    /// Draws the slot, which is new: what it holds afterwards is counted as its own.
    Judged judge(picture::Slot& slot);

private:
    picture::Session& session_;
    const View& view_;
    int light_;
    picture::PictureEncoder encoder_;
};

} // namespace shadowlab::report
