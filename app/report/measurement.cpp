// SPDX-License-Identifier: MIT
#include "app/report/measurement.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "app/judge/metrics/flip.h"
#include "app/judge/metrics/frame_times.h"
#include "app/judge/metrics/image_metrics.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::report {

namespace {

using namespace judge;

using SteadyClock = std::chrono::steady_clock;
using trace::Visibility;

/// Is each pixel lit? Turned away and empty pixels are not.
std::vector<std::uint8_t> litMask(const picture::VisibilityImage& visibility) {
    std::vector<std::uint8_t> lit(visibility.greyAlpha.size() / 2);
    for (std::size_t i = 0; i < lit.size(); ++i)
        lit[i] = visibility.greyAlpha[2 * i + 1] == 255 && visibility.greyAlpha[2 * i] > 127 ? 1 : 0;
    return lit;
}
std::vector<std::uint8_t> litMask(const Truth& truth) {
    std::vector<std::uint8_t> lit(truth.visibility.size());
    std::ranges::transform(truth.visibility, lit.begin(), [](Visibility v) { return v == Visibility::lit ? 1 : 0; });
    return lit;
}

// Frames of a turn: enough for caches to be those of the technique, few enough for turns to alternate within a second.
constexpr std::size_t kTurnFrames = 12, kWarmingFrames = 3;

int turnsOf(std::size_t frames) { return static_cast<int>((frames + kTurnFrames - 1) / kTurnFrames); }

} // namespace

Measurement::Measurement(picture::Session& session, std::vector<picture::Slot>& slots, int light, ivec2 size)
    : session_(session), light_(light), size_(size) {
    for (picture::Slot& slot : slots) {
        entries_.push_back({&slot, {}, {}});
        entries_.back().result.technique = slot.info->id;
    }
}

void Measurement::addFrame(const film::Moment& moment) {
    const bool first = moments_.empty();
    session_.setScene(moment.snapshot);
    View view;
    view.camera = moment.camera;
    view.size = size_;
    if (first) session_.prepareTruth(Deadline::max()); // builds the tree
    std::map<TruthOf, Judged> truths;                  // those that a slot is judged by
    std::optional<Shown> reference;
    if (first) reference = referencePicture(view);

    for (Entry& measured : entries_) {
        picture::Slot& slot = *measured.slot;
        const picture::LightTruth asked = session_.truthFor(slot, light_);
        measured.result.truth = asked.of;
        if (!truths.contains(asked.of)) truths.emplace(asked.of, truthOf(view, asked, first));
        const Judged& judged = truths.at(asked.of);
        if (first) measured.result.firstPrepareMs = session_.render(slot, view).prepareMs;

        const picture::RenderedFrame rendered =
            session_.render(slot, view, picture::requestAnswers(*slot.info, light_));
        const picture::Answers answers = picture::readAnswers(*slot.info, rendered, light_);
        measured.flips.addFrame(litOutsideTies(answers.visibility, judged.truth, asked, view), litMask(judged.truth),
                                lengthPx(judged.boundary));
        measured.result.counters = rendered.result.counters;
        if (first) judgeFirst(measured, rendered, answers, judged, *reference);
        if (first && coverageAsked_.points > 0) measured.result.coverage = coverageOf(slot, view, answers, judged);
        onStep_();
    }
    moments_.push_back(moment);
}

int Measurement::turns() const { return turnsOf(moments_.size()); }

int Measurement::steps(int frames) const {
    return static_cast<int>(entries_.size()) * (frames + turnsOf(static_cast<std::size_t>(frames)));
}

void Measurement::timeTurn(int turn) {
    const std::size_t first = kTurnFrames * static_cast<std::size_t>(turn), frames = moments_.size();
    const std::size_t end = std::min(first + kTurnFrames, frames), warming = std::min(kWarmingFrames, frames);
    for (Entry& measured : entries_) {
        for (std::size_t before = warming; before > 0; --before)
            draw(*measured.slot, moments_[(first + frames - before) % frames], false);
        for (std::size_t i = first; i < end; ++i) {
            const SteadyClock::time_point start = SteadyClock::now();
            const picture::RenderedFrame drawn = draw(*measured.slot, moments_[i], false);
            encoder_.finish(picture_, measured.slot->target, drawn.result, moments_[i].snapshot->exposure);
            glFinish();
            measured.result.times.addFrame(elapsedMs(start), drawn.prepareMs);
        }
        for (std::size_t i = first; i < end; ++i)
            measured.result.times.addPasses(draw(*measured.slot, moments_[i], true).result.passMs);
        onStep_();
    }
}

Measurement::Judged Measurement::truthOf(const View& view, const picture::LightTruth& light, bool first) {
    const SteadyClock::time_point start = SteadyClock::now();
    Truth truth = first ? session_.truth(view, light) : session_.truthAtCentres(view, light);
    if (first) truthMs_ += elapsedMs(start);
    std::vector<BoundaryEdge> boundary = trueBoundary(truth);
    Coverage coverage;
    if (first && coverageAsked_.points > 0) {
        const SteadyClock::time_point begun = SteadyClock::now();
        coverage = trueCoverage(session_.tracer(), view.camera, size_, light_, coverageAsked_.points, light.of);
        coverageMs_ += elapsedMs(begun);
    }
    return {std::move(truth), std::move(boundary), std::move(coverage)};
}

/// The technique's lit pixels, ties as the truth has them: what no rasteriser promises is no flicker. Only pixels that
/// differ have to be tested for ties.
std::vector<std::uint8_t> Measurement::litOutsideTies(const picture::VisibilityImage& visibility, const Truth& truth,
                                                      const picture::LightTruth& light, const View& view) {
    std::vector<std::uint8_t> lit = litMask(visibility);
    const std::vector<std::uint8_t> exact = litMask(truth);
    std::vector<ivec2> differing;
    for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x)
            if (lit[truth.index(x, y)] != exact[truth.index(x, y)]) differing.emplace_back(x, y);
    const std::vector<std::uint8_t> ties = session_.tiesAmong(view, light, differing);
    for (std::size_t i = 0; i < differing.size(); ++i)
        if (ties[i]) lit[truth.index(differing[i].x, differing[i].y)] ^= 1;
    return lit;
}

void Measurement::judgeFirst(Entry& measured, const picture::RenderedFrame& rendered, const picture::Answers& answers,
                             const Judged& judged, const Shown& reference) {
    TechniqueErrors& result = measured.result;
    const judge::Truth& truth = judged.truth;
    const std::vector<BoundaryEdge>& boundary = judged.boundary;
    const picture::AnswerErrors found = picture::judgeAnswers(answers, truth, boundary);
    result.counts = found.errors.judgement.counts;
    result.edgeErrorPx = found.errors.edgeErrorPx;
    result.coreErrors = found.core;
    result.boundaryPx = displacement(truth, boundary, answers.visibility.greyAlpha);
    result.converged = rendered.converged;
    result.served = picture::servedShare(rendered);

    const Shown picture = shown(*measured.slot);
    result.picture = {psnr(picture.linear, reference.linear), ssim(picture.encoded, reference.encoded),
                      flip(picture.encoded, reference.encoded).mean};
}

/// `answers`: at the pixels' centres. Where more samples were asked for, the slot is drawn once more in as many; afterwards its
/// target has that picture's size.
CoverageErrors Measurement::coverageOf(picture::Slot& slot, const View& view, const picture::Answers& answers,
                                       const Judged& judged) {
    const int samples = coverageAsked_.samples;
    View larger = view;
    larger.size = samples * size_;
    if (facingSamples_.empty()) facingSamples_ = facingCentres(session_.tracer(), larger.camera, larger.size, light_);
    const auto errorsOf = [&](const picture::Answers& ofSamples) {
        const PixelAnswers means = meansOfSamples(ofSamples.visibility.greyAlpha, facingSamples_, size_, samples);
        return coverageErrors(judged.coverage, means, judged.truth.ties, samples);
    };
    if (samples == 1) return errorsOf(answers);
    const picture::RenderedFrame drawn = session_.render(slot, larger, picture::requestAnswers(*slot.info, light_));
    return errorsOf(picture::readAnswers(*slot.info, drawn, light_));
}

/// The picture in a slot's target: linear light as it is shown, that is exposed and clamped, and the encoded bytes.
Measurement::Shown Measurement::shown(const picture::Slot& slot) const {
    const float exposure = session_.snapshot()->exposure;
    Shown picture{{}, encoder_.encode(slot.target.color, exposure)};
    for (const vec4& texel : gl::readTexels(slot.target.color))
        for (int channel = 0; channel < 3; ++channel)
            picture.linear.push_back(std::clamp(exposure * texel[channel], 0.0f, 1.0f));
    return picture;
}

Measurement::Shown Measurement::referencePicture(const View& view) {
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    session_.render(slot, view);
    return shown(slot);
}

std::vector<TechniqueErrors> Measurement::results() const {
    std::vector<TechniqueErrors> results;
    for (const Entry& measured : entries_) {
        results.push_back(measured.result);
        results.back().excessFlipRate = measured.flips.rate();
    }
    return results;
}

} // namespace shadowlab::report
