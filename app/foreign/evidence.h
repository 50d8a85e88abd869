// What causes of errors are tried on: a sample of the pixels that a foreign picture gets wrong and of those that it gets right.
//
// A cause is a rule that says of each pixel what the picture would show if that were its mistake. It is held against the picture:
// of the wrong pixels it explains those that it predicts, less the right ones that it predicts wrongly.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/foreign/calibration_reading.h"
#include "app/foreign/found_visibility.h"
#include "app/judge/grid.h"
#include "app/judge/slot_errors.h"
#include "app/judge/verdict.h"

namespace shadowlab::foreign {

struct Sample {
    ivec2 pixel{0};
    std::size_t index = 0;       ///< of the pixel, rows from the top
    trace::SurfacePoint point;   ///< that its centre sees: always a surface
    bool isLit = false;          ///< in the picture
    bool shouldBeLit = false;
    double weight = 1;           ///< pixels that it stands for
    float boundaryPx = 0;        ///< to the nearest true boundary
    [[nodiscard]] bool isWrong() const { return isLit != shouldBeLit; }
};

enum class Prediction : std::uint8_t { dark, lit, none };
inline Prediction predicted(bool lit) { return lit ? Prediction::lit : Prediction::dark; }

/// All that is known of the picture. What it refers to must outlive it.
struct Evidence {
    const trace::SceneTracer& tracer;
    const scene::Camera& camera;
    const judge::Truth& truth;
    const FoundVisibility& found;
    const judge::Judgement& judgement;
    const std::vector<judge::BoundaryEdge>& boundary; ///< trueBoundary() of the truth
    const judge::Grid<float>& boundaryPx;             ///< distanceToBoundary() of it
    int light = 0;
    std::optional<Orientation> reference{}; ///< how the reference of a pair lies, by its shading; none: no pair, or it does not tell
    std::vector<Sample> samples{};
    double wrong = 0; ///< weight of all wrong samples

    [[nodiscard]] const scene::Light& source() const { return tracer.scene().light(light); }
    [[nodiscard]] ivec2 size() const { return truth.size; }
    [[nodiscard]] bool isJudged(std::size_t pixel) const { return truth.ties[pixel] == 0 && found.isJudged[pixel] != 0; }
    [[nodiscard]] bool isLit(std::size_t pixel) const { return found.image.greyAlpha[2 * pixel] > 127; }
};

/// Chooses the samples: no more than some thousands of each kind, evenly over the picture, the right ones denser near wrong ones and
/// near boundaries.
void chooseSamples(Evidence& evidence);

/// The same with every third sample, for searches that ask all of them a hundred times.
Evidence thinned(const Evidence& evidence);

using Predictions = std::vector<Prediction>; ///< one for each sample

/// What the picture shows where another view would see the background: a visibility image is black there, and both pictures of a pair show
/// the same, whatever that was taken for.
inline Prediction ofBackground(const Evidence& evidence, const Sample& sample) {
    if (evidence.found.isSame.empty()) return Prediction::dark;
    return predicted(evidence.found.isSame[sample.index] == 0 || sample.isLit);
}

/// Calls f with the index of each sample, on all cores; of two calls none may write what the other reads.
void forSamples(const Evidence& evidence, const std::function<void(std::size_t sample)>& f);

/// Predictions for all samples, found on all cores.
Predictions predictAll(const Evidence& evidence, const std::function<Prediction(const Sample&)>& rule);

/// Share of the wrong samples that the predictions explain, less the right ones that they make wrong: at most 1. `of`: only these
/// samples count; empty: all.
double explained(const Evidence& evidence, const Predictions& predictions, std::span<const std::uint8_t> of = {});

/// What a picture may suffer from.
struct Cause {
    std::string id;          ///< "acne"
    std::string what;        ///< what it looks like, with its numbers, as a sentence without its end
    std::string remedy;
    Predictions predictions; ///< of a cause without a rule: what the picture shows where it may be the cause, else the truth
    bool isOfPicture = false; ///< of all of it, so that no region counts for more
    bool hasRule = true;     ///< it predicts each pixel; else it knows a pattern only, and counts for less
    double ofItsKind = 0;    ///< of a pattern: what it explains of the wrong pixels that it is looked for among
    double likelihood = 1;   ///< of two that predict the same, the likelier one first
};

} // namespace shadowlab::foreign
