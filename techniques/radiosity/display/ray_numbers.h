// What a gather ray chooses by: numbers in the unit interval, each spread evenly over the rays of a point.
//
// Along a ray several things are chosen: its direction, a place on a light, the directions in which it goes on. Each of these must be spread
// evenly, and none may go with another: were one reflection's direction a function of the one before, paths would all bend alike. So the
// numbers of a ray are multiples of its own number by different irrational steps, without their whole parts (R. D. Richtmyer, "The Evaluation
// of Definite Integrals, and a Quasi-Monte-Carlo Method Based on the Properties of Algebraic Numbers", Los Alamos 1951).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "techniques/foundation/math/types.h"

namespace shadowlab::radiosity {

/// The golden ratio less one: its multiples fill the unit interval evenly.
inline constexpr double kGolden = 0.6180339887498949;

/// A ray goes on so many times at most. Where it would go on then, as in a narrow gap, so much has been reflected that the patch's mean does for
/// the rest.
inline constexpr int kMostReflections = 4;

/// The steps of the sequence for directions: powers of 1 / p, where p^3 = p + 1, whose multiples fill the unit square more evenly than those of
/// other steps (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
inline constexpr double kPlastic = 1.3247179572447460;
inline constexpr dvec2 kDirectionStep{1 / kPlastic, 1 / (kPlastic * kPlastic)};

/// Of one ray. `shift`, in the unit square, tells one sequence from another.
class RayNumbers {
public:
    RayNumbers(std::size_t ray, const dvec2& shift) : number_(static_cast<double>(ray) + 0.5), shift_(shift) {}
    [[nodiscard]] dvec2 direction() const;
    [[nodiscard]] double which() const;              ///< which patch or opening
    [[nodiscard]] dvec2 where() const;               ///< the place on it
    [[nodiscard]] dvec2 onLight() const;             ///< the place on a light with an area, seen from where the ray ends
    [[nodiscard]] dvec2 onward(int reflection) const; ///< the direction in which it goes on from there; from 0, below kMostReflections
    [[nodiscard]] double onwardWhich(int reflection) const; ///< to which patch, or by chance

private:
    double number_;
    dvec2 shift_;
};

} // namespace shadowlab::radiosity
