// SPDX-License-Identifier: MIT
#include "app/foreign/evidence.h"

#include <algorithm>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::foreign {

namespace {

// Enough for a share to be known to one in a hundred, few enough for a hundred rules to be tried within seconds.
constexpr std::size_t kMostOfAKind = 2500;
constexpr float kNearBoundaryPx = 8;

/// Every n-th of them, so that no more than kMostOfAKind remain; each stands for n pixels.
void takeSome(const std::vector<std::size_t>& pixels, const Evidence& evidence, std::vector<Sample>& samples) {
    const std::size_t count = std::min(pixels.size(), kMostOfAKind);
    const trace::EyeRays rays = evidence.tracer.eyeRays(evidence.camera, evidence.size());
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = pixels[k * pixels.size() / count];
        const std::size_t width = static_cast<std::size_t>(evidence.size().x);
        Sample sample;
        sample.pixel = ivec2(i % width, i / width);
        sample.index = i;
        sample.point = evidence.tracer.eyePoint(rays, dvec2(sample.pixel) + 0.5);
        sample.isLit = evidence.isLit(i);
        sample.shouldBeLit = evidence.truth.share(i) > 0.5;
        sample.weight = static_cast<double>(pixels.size()) / static_cast<double>(count);
        sample.boundaryPx = evidence.boundaryPx.values[i];
        samples.push_back(sample);
    }
}

} // namespace

void chooseSamples(Evidence& evidence) {
    std::vector<std::size_t> wrong, nearby, elsewhere;
    for (std::size_t i = 0; i < evidence.truth.visibility.size(); ++i) {
        if (!evidence.isJudged(i) || evidence.truth.visibility[i] == trace::Visibility::noSurface) continue;
        const bool isWrong = evidence.isLit(i) != (evidence.truth.share(i) > 0.5);
        (isWrong ? wrong : evidence.boundaryPx.values[i] < kNearBoundaryPx ? nearby : elsewhere).push_back(i);
    }
    evidence.samples.clear();
    for (const auto* const pixels : {&wrong, &nearby, &elsewhere})
        takeSome(*pixels, evidence, evidence.samples);
    evidence.wrong = static_cast<double>(wrong.size());
}

Evidence thinned(const Evidence& evidence) {
    constexpr std::size_t kEvery = 3;
    Evidence some = evidence;
    some.samples.clear();
    some.wrong = 0;
    for (std::size_t i = 0; i < evidence.samples.size(); i += kEvery) {
        some.samples.push_back(evidence.samples[i]);
        if (evidence.samples[i].isWrong()) some.wrong += evidence.samples[i].weight;
    }
    // A few wrong samples are all needed.
    constexpr double kFew = 100;
    return some.wrong < kFew ? evidence : some;
}

void forSamples(const Evidence& evidence, const std::function<void(std::size_t sample)>& f) {
    const std::size_t count = evidence.samples.size();
    constexpr std::size_t kPiece = 128;
    trace::parallelFor((count + kPiece - 1) / kPiece, [&](std::size_t piece) {
        const std::size_t end = std::min((piece + 1) * kPiece, count);
        for (std::size_t i = piece * kPiece; i < end; ++i)
            f(i);
    });
}

Predictions predictAll(const Evidence& evidence, const std::function<Prediction(const Sample&)>& rule) {
    Predictions predictions(evidence.samples.size());
    forSamples(evidence, [&](std::size_t i) { predictions[i] = rule(evidence.samples[i]); });
    return predictions;
}

double explained(const Evidence& evidence, const Predictions& predictions, std::span<const std::uint8_t> of) {
    double wrong = 0, mismatches = 0;
    for (std::size_t i = 0; i < predictions.size(); ++i) {
        if (!of.empty() && !of[i]) continue;
        const Sample& sample = evidence.samples[i];
        if (sample.isWrong()) wrong += sample.weight;
        // Where the rule says nothing, the truth stands.
        const bool lit = predictions[i] == Prediction::none ? sample.shouldBeLit : predictions[i] == Prediction::lit;
        if (lit != sample.isLit) mismatches += sample.weight;
    }
    return wrong > 0 ? (wrong - mismatches) / wrong : 0;
}

} // namespace shadowlab::foreign
