// SPDX-License-Identifier: MIT
#include "app/foreign/diagnosis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/foreign/causes.h"

namespace shadowlab::foreign {

namespace {

// A pattern is seen where a rule predicts: what both explain is rather the rule's.
constexpr double kOfPatterns = 0.8;
// Below, chance and the sum of small things would be named.
constexpr double kLeastScore = 0.25;
// The second is named, too, where it explains nearly as much, or a good part of what the first leaves.
constexpr double kNearlyAsMuch = 0.75, kGoodPart = 0.25;

struct Ranked {
    const Cause* cause;
    NamedCause named;
    double score = 0;
};

double scoreOf(const Ranked& ranked) {
    const Cause& cause = *ranked.cause;
    // The whole picture knows the cause better, the worst region is what the sentence is about. A pattern lies where it lies.
    const double other = cause.isOfPicture ? ranked.named.explained : cause.hasRule ? ranked.named.explainedInRegion : cause.ofItsKind;
    return 0.5 * (ranked.named.explained + other) * cause.likelihood * (cause.hasRule ? 1.0 : kOfPatterns);
}

NamedCause namedCause(const Evidence& evidence, const Cause& cause, const std::vector<std::uint8_t>& region) {
    NamedCause named{cause.id, cause.what, cause.remedy, explained(evidence, cause.predictions), explained(evidence, cause.predictions, region)};
    // So few may lie so by chance, and numbers that are read off them are rough.
    constexpr double kFew = 10;
    const double pixels = named.explained * evidence.wrong;
    if (pixels < kFew) {
        const long count = std::lround(pixels);
        named.what += "; this rests on " + (count == 1 ? "1 pixel" : std::to_string(count) + " pixels") + " only, and is not sure";
    }
    return named;
}

/// Is all of it that faces the light lit, or all of it dark?
bool isOfOneKind(const Evidence& evidence) {
    bool anyLit = false, anyDark = false;
    for (std::size_t i = 0; i < evidence.truth.visibility.size(); ++i) {
        if (!evidence.isJudged(i) || !facesTheLight(evidence.truth.visibility[i])) continue;
        (evidence.isLit(i) ? anyLit : anyDark) = true;
    }
    return !(anyLit && anyDark);
}

std::vector<Ranked> rankedCauses(const Evidence& evidence, const std::vector<Cause>& causes, const std::vector<std::uint8_t>& region) {
    std::vector<Ranked> ranked;
    for (const Cause& cause : causes) {
        Ranked one{&cause, namedCause(evidence, cause, region)};
        one.score = scoreOf(one);
        if (one.score >= kLeastScore && one.named.explained >= kLeastScore) ranked.push_back(std::move(one));
    }
    std::ranges::stable_sort(ranked, std::greater{}, &Ranked::score);
    return ranked;
}

/// Share of all wrong pixels that the second explains where the first does not.
double explainedBeside(const Evidence& evidence, const Cause& first, const Cause& second) {
    std::vector<std::uint8_t> left;
    double weight = 0;
    for (std::size_t i = 0; i < evidence.samples.size(); ++i) {
        const Sample& sample = evidence.samples[i];
        const bool lit = first.predictions[i] == Prediction::none ? sample.shouldBeLit : first.predictions[i] == Prediction::lit;
        left.push_back(lit != sample.isLit ? 1 : 0);
        if (left.back()) weight += sample.weight;
    }
    return weight > 0 ? explained(evidence, second.predictions, left) * weight / evidence.wrong : 0;
}

} // namespace

Diagnosis diagnose(Evidence& evidence) {
    Diagnosis diagnosis;
    chooseSamples(evidence);
    if (evidence.wrong <= 0) return diagnosis;
    diagnosis.region = worstRegion(evidence);
    std::vector<Cause> causes;
    addWholeCauses(evidence, causes);
    // A picture that is all of one kind shows nothing else, whatever would make it so.
    if (!causes.empty() && isOfOneKind(evidence)) {
        diagnosis.causes.push_back(namedCause(evidence, causes.front(), {}));
        // Volumes without their front cap put every surface that faces the light into shadow: of all that makes a picture dark, the one with a rule.
        std::vector<Cause> volumes;
        addVolumeCauses(evidence, volumes);
        constexpr double kAll = 0.999;
        for (const Cause& cause : volumes)
            if (causes.front().id == "all-dark" && cause.id == "missing-front-cap" && explained(evidence, cause.predictions) >= kAll) {
                diagnosis.causes.push_back(namedCause(evidence, cause, {}));
                diagnosis.causes.back().beside = Beside::instead;
                break;
            }
        return diagnosis;
    }
    addPictureCauses(evidence, causes);
    addMovedLightCauses(evidence, causes);
    addLightCauses(evidence, causes);
    addMapCauses(evidence, causes);
    addWindingCauses(evidence, causes);
    addVolumeCauses(evidence, causes);
    addPatternCauses(evidence, causes);
    const std::vector<Ranked> ranked = rankedCauses(evidence, causes, diagnosis.region ? samplesIn(evidence, *diagnosis.region) : std::vector<std::uint8_t>());
    if (ranked.empty()) return diagnosis;
    const Ranked& first = ranked.front();
    diagnosis.causes.push_back(first.named);
    for (const Ranked& one : ranked) {
        if (one.named.id == first.named.id) continue;
        const bool also = explainedBeside(evidence, *first.cause, *one.cause) >= kGoodPart;
        if (!also && one.score < kNearlyAsMuch * first.score) continue;
        diagnosis.causes.push_back(one.named);
        diagnosis.causes.back().beside = also ? Beside::also : Beside::instead;
        break;
    }
    return diagnosis;
}

std::string_view techniqueShowing(std::string_view causeId) {
    constexpr std::array kOfMaps{"acne", "peter-panning", "leak-at-contact", "resolution", "soft-edges", "near-plane-of-light", "range-of-light", "range-of-view", "outside-map"};
    return std::ranges::find(kOfMaps, causeId) != kOfMaps.end() ? "shadow-map" : "shadow-volume-zfail";
}

} // namespace shadowlab::foreign
