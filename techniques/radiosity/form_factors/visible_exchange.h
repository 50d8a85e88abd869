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

} // namespace shadowlab::radiosity
