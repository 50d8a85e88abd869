// SPDX-License-Identifier: MIT
#include "app/report/judge.h"

#include <algorithm>
#include <array>

#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::report {

namespace {

using image::Color8;
using image::Image;
using judge::Verdict;

// Light greys: the two colours of errors stand out, also in print (docs/conventions.md has what they mean).
constexpr Color8 kBackground{255, 255, 255}, kLit{222, 222, 222}, kShadowed{150, 150, 150}, kTurnedAway{120, 120, 120},
    kTie{90, 90, 90}, kFalseLit{230, 159, 0}, kFalseShadow{0, 114, 178}, kStray{204, 121, 167};

Color8 colorOf(Verdict verdict, trace::Visibility visibility) {
    switch (verdict) {
    case Verdict::falseLit: return kFalseLit;
    case Verdict::falseShadow: return kFalseShadow;
    case Verdict::stray: return kStray;
    case Verdict::tie: return kTie;
    case Verdict::background:
    case Verdict::correct: break;
    }
    switch (visibility) {
    case trace::Visibility::noSurface: break;
    case trace::Visibility::turnedAway: return kTurnedAway;
    case trace::Visibility::shadowed: return kShadowed;
    case trace::Visibility::lit: return kLit;
    }
    return kBackground;
}

int factorFor(int from, int to) { return std::max(1, from / to); }

} // namespace

Image reduced(const Image& picture, int width) {
    const int factor = factorFor(picture.width, width);
    Image small(picture.width / factor, picture.height / factor);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            vec3 sum(0);
            for (int k = 0; k < factor * factor; ++k) {
                const Color8 color = picture.at(x * factor + k % factor, y * factor + k / factor);
                sum += vec3(image::linearFromSrgb(color.r), image::linearFromSrgb(color.g),
                            image::linearFromSrgb(color.b));
            }
            sum /= static_cast<float>(factor * factor);
            small.set(x, y, {image::srgbFromLinear(sum.r), image::srgbFromLinear(sum.g), image::srgbFromLinear(sum.b)});
        }
    return small;
}

Image errorMap(const judge::Truth& truth, const judge::Judgement& judgement, int width) {
    const int factor = factorFor(truth.size.x, width);
    Image map(truth.size.x / factor, truth.size.y / factor);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            std::size_t shown = truth.index(x * factor + factor / 2, y * factor + factor / 2);
            for (int k = 0; k < factor * factor; ++k)
                if (const std::size_t pixel = truth.index(x * factor + k % factor, y * factor + k / factor);
                    judge::isWrong(judgement.verdicts[pixel]))
                    shown = pixel;
            map.set(x, y, colorOf(judgement.verdicts[shown], truth.visibility[shown]));
        }
    return map;
}

Judge::Judge(picture::Session& session, const View& view, int light) : session_(session), view_(view), light_(light) {
    // What belongs to the scene is made now, and is no technique's own: buffers, and the facing signs of every light.
    picture::Slot first = picture::Session::makeSlot("unshadowed");
    session_.render(first, view_);
}

Judge::Judged Judge::judge(picture::Slot& slot) {
    Judged judged;
    Errors& errors = judged.errors;
    const std::int64_t before = gl::liveBytes;
    session_.render(slot, view_);
    const std::int64_t target = 12ll * view_.size.x * view_.size.y; // RGBA16F and depth with stencil
    errors.glMegabytes = static_cast<double>(gl::liveBytes - before - target) / (1 << 20);

    const picture::JudgedSlot drawn = picture::judgeSlot(session_, slot, view_, light_);
    const judge::SlotErrors& found = drawn.found.errors;
    const judge::Counts& counts = found.judgement.counts;
    errors.truth = drawn.asked.of;
    errors.pixels = counts.pixels, errors.lit = counts.lit, errors.shadowed = counts.shadowed;
    errors.turnedAway = counts.turnedAway, errors.ties = counts.ties;
    errors.falseLit = counts.falseLit, errors.falseShadow = counts.falseShadow;
    errors.rmse = counts.rmse;
    errors.edgeErrorPx = found.edgeErrorPx;
    errors.core = drawn.found.core;
    errors.converged = drawn.rendered.converged;
    errors.served = picture::servedShare(drawn.rendered);
    for (const Counter& counter : drawn.rendered.result.counters)
        errors.counters.push_back({counter.id, counter.unit, counter.built, counter.of});
    const float exposure = session_.snapshot()->exposure;
    judged.picturePng = image::encodePng(reduced(encoder_.encode(slot.target.color, exposure)));
    judged.errorPng = image::encodePng(errorMap(drawn.truth, found.judgement));
    return judged;
}

} // namespace shadowlab::report
