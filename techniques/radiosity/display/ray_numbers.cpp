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

dvec2 turned(const dvec2& shift) { return {shift.y, shift.x}; }

} // namespace

dvec2 RayNumbers::direction() const { return glm::fract(number_ * kDirectionStep + shift_); }
double RayNumbers::which() const { return glm::fract(kGolden * number_ + shift_.x + shift_.y); }
// The place on it may go with the direction of the ray, which it has nothing to do with.
dvec2 RayNumbers::where() const { return glm::fract(number_ * kDirectionStep + turned(shift_)); }
dvec2 RayNumbers::onLight() const { return glm::fract(number_ * kOnLightStep + turned(shift_)); }
dvec2 RayNumbers::onward(int reflection) const { return glm::fract(number_ * kOnwardSteps[static_cast<std::size_t>(reflection)] + shift_); }
double RayNumbers::onwardWhich(int reflection) const { return glm::fract(number_ * kOnwardWhichSteps[static_cast<std::size_t>(reflection)] + shift_.x + shift_.y); }

} // namespace shadowlab::radiosity
