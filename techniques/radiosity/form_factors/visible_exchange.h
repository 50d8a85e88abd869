// The exchange area of two patches, with everything that blocks light between them.
//
// Between patches that see each other fully it is the unoccluded exchange, in closed form or to 1e-7; between patches that do not
// see each other it is 0. Otherwise lines between sample points of both patches are tested: the visible share of their weights,
// times the unoccluded exchange.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/form_factors/occlusion.h"
#include "techniques/radiosity/form_factors/polygon_exchange.h"
#include "techniques/radiosity/patches/patches.h"
#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

struct VisibleExchange {
    enum class Kind { none, full, partial, hidden }; ///< none: the patches face away from each other
    Kind kind = Kind::none;
    double area = 0;  ///< square metres
    double error = 0; ///< for partly visible pairs, an upper bound of the standard deviation
};

/// `linesPerPatch`: how many lines a patch would need if all its pairs were partly visible. A pair gets a share of them in
/// proportion to its form factor from the smaller patch, so that every line stands for as much light. Sample points are
/// Hammersley points: the same question always gives the same answer.
VisibleExchange visibleExchange(const Patch& a, const Patch& b, const Occlusion& occlusion, const Blockers& known,
                                double linesPerPatch);

/// The integrand of the exchange area for one line between points of both, 1/m^2, times pi.
double exchangeKernel(const Patch& a, const Patch& b, const dvec3& from, const dvec3& to);

/// How many lines a pair with that exchange area gets.
int linesBetween(const Patch& a, const Patch& b, double exchangeArea, double linesPerPatch);

/// Calls line(from, to, weight) for so many lines.
template <typename Line>
void forLinesBetween(const Patch& a, const Patch& b, int lines, const Line& line) {
    for (int i = 0; i < lines; ++i) {
        const auto x = hammersley4(i, lines);
        const Place from = placeIn(a.polygon, x[0], x[1]), to = placeIn(b.polygon, x[2], x[3]);
        line(from.point, to.point, from.weight * to.weight * exchangeKernel(a, b, from.point, to.point));
    }
}

} // namespace shadowlab::radiosity
