// SPDX-License-Identifier: MIT
#include "techniques/radiosity/equations/problem.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/radiosity/equations/gather.h"

namespace shadowlab::radiosity {

namespace {

/// From here on rounding decides the error bound, residual / (1 - q).
constexpr double kMostReflected = 1 - 1e-9;

std::string patchName(std::size_t i) { return "patch " + std::to_string(i); }

bool isFromZeroTo(double most, double value) { return value >= 0 && value <= most; } // NaN is not

std::optional<std::string> wrongNumber(const Problem& problem) {
    constexpr double kMost = 1e150; // squares and products of two such numbers stay finite
    for (std::size_t i = 0; i < problem.areas.size(); ++i) {
        if (!(problem.areas[i] > 0) || !isFromZeroTo(kMost, problem.areas[i]))
            return patchName(i) + " has an area of " + std::to_string(problem.areas[i]) +
                   " m^2; leave such patches out";
        for (int c = 0; c < 3; ++c) {
            if (!isFromZeroTo(kMost, problem.emission[i][c]))
                return patchName(i) + " emits " + std::to_string(problem.emission[i][c]) +
                       " W/m^2; give a finite number of at least 0";
            if (!isFromZeroTo(1, problem.reflectance[i][c]))
                return patchName(i) + " has a reflectance of " + std::to_string(problem.reflectance[i][c]) +
                       "; give a number from 0 to 1";
        }
        for (const double exchangeArea : problem.exchange.row(i))
            if (!isFromZeroTo(kMost, exchangeArea))
                return patchName(i) +
                       " has a form factor that is negative or no number, which rounding makes of sizes too far apart; "
                       "bring those of the objects nearer together, or choose more patches";
    }
    return std::nullopt;
}

bool reflectsEverything(const Problem& problem, int colour) {
    return std::ranges::all_of(problem.reflectance, [&](const dvec3& rho) { return rho[colour] >= kMostReflected; });
}

std::optional<std::string> wrongInput(const Problem& problem) {
    const std::size_t size = problem.exchange.size();
    if (size == 0) return "there are no patches; give the scene a surface";
    if (problem.areas.size() != size || problem.emission.size() != size || problem.reflectance.size() != size)
        return "there are form factors of " + std::to_string(size) + " patches, but " +
               std::to_string(problem.areas.size()) + " areas, " + std::to_string(problem.emission.size()) +
               " emissions and " + std::to_string(problem.reflectance.size()) +
               " reflectances; give one of each for each";
    return wrongNumber(problem);
}

std::optional<std::string> endlessLight(const Problem& problem, const dvec3& q) {
    constexpr std::array<const char*, 3> kColours = {"red", "green", "blue"};
    for (int c = 0; c < 3; ++c) {
        const bool isEmitted = std::ranges::any_of(problem.emission, [&](const dvec3& e) { return e[c] > 0; });
        if (!isEmitted || q[c] < kMostReflected) continue;
        const std::string light = std::string(kColours[c]) + " light";
        if (reflectsEverything(problem, c))
            return "all surfaces of a closed room reflect everything, so " + light +
                   " never dies out and there is no solution; give one surface a reflectance below 1, or open the room";
        return "a surface sends on all " + light +
               " that it gets (reflectance x row sum of form factors is 1 or more), so no error has a bound; "
               "give every surface a reflectance below 1, or scale the row sums to 1";
    }
    return std::nullopt;
}

} // namespace

ReflectionBounds reflectionBounds(const Problem& problem) {
    const std::vector<dvec3> ones(problem.areas.size(), dvec3(1));
    const std::vector<dvec3> sums = gathered(problem.exchange, problem.areas, ones);
    const std::vector<dvec3> seen = gathered(problem.exchange, problem.areas, problem.reflectance);
    ReflectionBounds bounds;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        bounds.ofLargest = glm::max(bounds.ofLargest, problem.reflectance[i] * sums[i]);
        bounds.ofPower = glm::max(bounds.ofPower, seen[i]);
    }
    // All summands are positive, so rounding is relative to the sum; a factor of two also covers the rounding of this product.
    const double rounding = 1 + 2 * gatherRounding(sums.size());
    bounds.ofLargest *= rounding;
    bounds.ofPower *= rounding;
    return bounds;
}

std::optional<std::string> refusal(const Problem& problem) {
    if (const auto wrong = wrongInput(problem)) return wrong;
    return endlessLight(problem, reflectionBounds(problem).ofLargest);
}

ReflectionBounds boundsOfSolvable(const Problem& problem) {
    auto why = wrongInput(problem);
    ReflectionBounds bounds;
    if (!why) {
        bounds = reflectionBounds(problem);
        why = endlessLight(problem, bounds.ofLargest);
    }
    if (why) throw Error(ExitStatus::badInput, "radiosity: " + *why);
    return bounds;
}

} // namespace shadowlab::radiosity
