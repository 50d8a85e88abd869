// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/refinement.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::radiosity {

namespace {

using Reason = Refinement::Reason;

/// The error of a patch's radiosity, in the mean over its area, W/m^2, and its cause: the larger of two estimates.
struct Wrong {
    double mean = 0;
    Reason reason = Reason::gradient;
};

/// The error by a gradient. Of the difference between two centres of patches of equal size, half lies between the one centre and
/// the common edge; and if the values at two ends of a patch are a above and a below its mean, the mean deviation is a / 2.
double byGradient(const std::vector<Patch>& patches, const PatchBorders& borders, std::span<const dvec3> radiosity,
                  std::size_t number) {
    const double size = std::sqrt(patches[number].area);
    double most = 0;
    for (const std::uint32_t next : borders.neighbours(number)) {
        const double sizeOfNext = std::sqrt(patches[next].area);
        const double difference = std::abs(luminance(radiosity[next]) - luminance(radiosity[number]));
        most = std::max(most, 0.5 * difference * size / (size + sizeOfNext));
    }
    return most;
}

/// The error by a shadow edge. If a share s of the patch receives u and the rest nothing, the mean is s u and the mean deviation
/// is 2 s (1 - s) u.
double byShadow(const DirectLight& light, std::span<const dvec3> reflectance, std::size_t number) {
    const double share = light.visible[number];
    return share > 0 && share < 1 ? 2 * (1 - share) * luminance(reflectance[number] * light.irradiance[number]) : 0;
}

/// Rounds to six digits, so that numbers that differ by rounding errors become equal.
double rounded(double number) {
    int exponent = 0;
    const double fraction = std::frexp(number, &exponent);
    return std::ldexp(std::round(std::ldexp(fraction, 20)), exponent - 20);
}

// A neighbour this many times larger than a patch that is cut must be cut too. A neighbour of the same level has an area of 1/2
// to 2 times the patch's, one of the level before four times: the limit lies in the middle, because areas are rounded.
constexpr double kTooLarge = 2.8;

/// The patch, and all that have to be cut with it.
void addWithLarger(std::uint32_t number, const std::vector<Patch>& patches, const PatchBorders& borders,
                   std::vector<std::uint32_t>& cuts) {
    std::vector<std::uint32_t> waiting{number};
    while (!waiting.empty()) {
        const std::uint32_t here = waiting.back();
        waiting.pop_back();
        cuts.push_back(here);
        for (const std::uint32_t next : borders.neighbours(here))
            if (patches[next].area > kTooLarge * patches[here].area) waiting.push_back(next);
    }
}

/// The larger of the two estimates.
Wrong wrongOf(const std::vector<Patch>& patches, const PatchBorders& borders, std::span<const dvec3> radiosity,
              std::span<const dvec3> reflectance, std::span<const DirectLight> lights, double gradientWeight, std::uint32_t number) {
    Wrong wrong{gradientWeight * byGradient(patches, borders, radiosity, number), Reason::gradient};
    for (const DirectLight& light : lights)
        if (const double shadow = byShadow(light, reflectance, number); shadow > wrong.mean) wrong = {shadow, Reason::shadow};
    return wrong;
}

} // namespace

std::vector<double> errorsOfPatches(const std::vector<Patch>& patches, const PatchBorders& borders, std::span<const dvec3> radiosity,
                                    std::span<const dvec3> reflectance, std::span<const DirectLight> lights) {
    std::vector<double> errors;
    for (std::uint32_t i = 0; i < patches.size(); ++i)
        errors.push_back(wrongOf(patches, borders, radiosity, reflectance, lights, 1, i).mean);
    return errors;
}

std::vector<Refinement> patchesToRefine(const std::vector<Patch>& patches, const PatchBorders& borders,
                                        std::span<const dvec3> radiosity, std::span<const dvec3> reflectance,
                                        std::span<const DirectLight> lights, const RefinementLimits& limits) {
    double power = 0, area = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        power += patches[i].area * luminance(radiosity[i]);
        area += patches[i].area;
    }
    struct Candidate {
        double power; ///< the error in W, rounded
        std::uint32_t patch;
    };
    std::vector<Candidate> candidates;
    std::vector<Reason> reasons(patches.size(), Reason::balance);
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        const Wrong wrong = wrongOf(patches, borders, radiosity, reflectance, lights, limits.gradientWeight, i);
        if (patches[i].area < limits.smallestArea || !(wrong.mean * area > limits.smallestError * power)) continue;
        candidates.push_back({rounded(wrong.mean * patches[i].area), i});
        reasons[i] = wrong.reason;
    }
    std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::power);

    std::vector<Refinement> chosen;
    std::vector<std::uint8_t> isCut(patches.size(), 0);
    std::size_t count = patches.size();
    for (auto first = candidates.begin(), end = first; first != candidates.end(); first = end) {
        end = std::find_if(first, candidates.end(), [&](const Candidate& c) { return c.power != first->power; });
        std::vector<std::uint32_t> cuts;
        for (auto one = first; one != end; ++one)
            addWithLarger(one->patch, patches, borders, cuts);
        std::ranges::sort(cuts);
        const auto repeated = std::ranges::unique(cuts);
        cuts.erase(repeated.begin(), repeated.end());
        std::erase_if(cuts, [&](std::uint32_t number) { return isCut[number] != 0; });
        std::size_t after = count;
        for (const std::uint32_t number : cuts)
            after += dividedPatch(patches[number]).size() - 1;
        if (after > limits.mostPatches) break;
        count = after;
        for (const std::uint32_t number : cuts) {
            isCut[number] = 1;
            chosen.push_back({number, reasons[number]});
        }
    }
    std::ranges::sort(chosen, {}, &Refinement::patch);
    return chosen;
}

Refined refined(const std::vector<Patch>& patches, std::span<const Refinement> refinements,
                std::span<const std::uint8_t> level) {
    Refined result;
    auto next = refinements.begin();
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        const bool isCut = next != refinements.end() && next->patch == i;
        const std::uint8_t before = level.empty() ? std::uint8_t{0} : level[i];
        const auto add = [&](const Patch& patch, std::uint32_t from, int deeper) {
            result.patches.push_back(patch);
            result.from.push_back(from);
            result.parent.push_back(i);
            result.level.push_back(static_cast<std::uint8_t>(before + deeper));
        };
        if (!isCut) {
            add(patches[i], i, 0);
            continue;
        }
        ++next;
        for (const Polygon& piece : dividedPatch(patches[i]))
            add(pieceOf(patches[i], piece), Refined::kNew, 1);
    }
    return result;
}

} // namespace shadowlab::radiosity
