// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/ray_numbers.h"

#include <array>
#include <cmath>

namespace shadowlab::radiosity {

namespace {

// Square roots of primes: no sum of whole multiples of them is a whole number, so that together they fill the cube of all their dimensions. Those of 2 and
// 3 fill it most evenly, as their continued fractions have the smallest terms, and are for what varies most: where the first reflection goes.
const std::array<dvec2, kMostReflections> kOnwardSteps = {dvec2(std::sqrt(2.0), std::sqrt(3.0)), dvec2(std::sqrt(11.0), std::sqrt(13.0)),
                                                          dvec2(std::sqrt(17.0), std::sqrt(19.0)), dvec2(std::sqrt(23.0), std::sqrt(29.0))};
const std::array<double, kMostReflections> kOnwardWhichSteps = {std::sqrt(31.0), std::sqrt(37.0), std::sqrt(41.0), std::sqrt(43.0)};
const dvec2 kOnLightStep{std::sqrt(5.0), std::sqrt(7.0)};

// Each is shifted by an amount of its own, or the mean over all shifts would not be that over the cube: it was up to a hundredth off. Sums of large whole multiples of
// a sequence's two shifts go with neither of them, nor with each other. They are primes, so that no two have a common part; those of later reflections are so
// many times as large.
constexpr std::array<double, kMostReflections + 1> kLater = {1, 67, 67 * 67, 67 * 67 * 67, 67 * 67 * 67 * 67};
constexpr dvec2 kWhich{1297, 733}, kOnLight{2357, 1033};
constexpr std::array<dvec2, 2> kWhere = {dvec2(1613, 421), dvec2(977, 1889)}, kOnward = {dvec2(601, 2069), dvec2(1427, 839)};

double shifted(double multiple, const dvec2& shift, const dvec2& sum) { return glm::fract(multiple + glm::fract(glm::dot(shift, sum))); }
dvec2 shifted(const dvec2& multiples, const dvec2& shift, const std::array<dvec2, 2>& sums, double times = 1) {
    return {shifted(multiples.x, shift, times * sums[0]), shifted(multiples.y, shift, times * sums[1])};
}

} // namespace

dvec2 RayNumbers::direction() const { return glm::fract(number_ * kDirectionStep + shift_); }
double RayNumbers::which() const { return shifted(kGolden * number_, shift_, kWhich); }
dvec2 RayNumbers::where() const { return shifted(number_ * kDirectionStep, shift_, kWhere); }
dvec2 RayNumbers::onLight() const { return shifted(number_ * kOnLightStep, shift_, {kOnLight, dvec2(kOnLight.y, kOnLight.x)}); }
dvec2 RayNumbers::onward(int reflection) const {
    return shifted(number_ * kOnwardSteps[static_cast<std::size_t>(reflection)], shift_, kOnward, kLater[static_cast<std::size_t>(reflection)]);
}
double RayNumbers::onwardWhich(int reflection) const {
    return shifted(number_ * kOnwardWhichSteps[static_cast<std::size_t>(reflection)], shift_, kLater[static_cast<std::size_t>(reflection) + 1] * kWhich);
}

} // namespace shadowlab::radiosity
