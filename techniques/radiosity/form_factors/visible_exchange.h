// How much do two patches exchange, with everything else in the way?
//
// Between patches that see each other fully it is the exchange with nothing in between, in closed form or to a ten millionth;
// between patches that do not see each other at all it is nothing. For the rest lines from points of the one to points of the
// other are tried: the share of what arrives that comes by free lines, times the exchange with nothing in between.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/form_factors/occlusion.h"
#include "techniques/radiosity/form_factors/polygon_exchange.h"
#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

struct VisibleExchange {
    enum class Kind { none, full, partial, hidden }; ///< none: they face away from each other
    Kind kind = Kind::none;
    double area = 0;  ///< square metres
    double error = 0; ///< of partly seen patches one standard deviation, at most, of as many lines chosen by chance
};

/// `linesPerPatch`: as many a patch would send if it saw everything in part; a pair gets its share of them, by how much of what the
/// smaller patch sends out would arrive, so that every line stands for as much. They lie evenly, and are the same whenever the
/// same patches are asked about in the same order.
VisibleExchange visibleExchange(const Patch& a, const Patch& b, const Occlusion& occlusion, const Blockers& known,
                                double linesPerPatch);

} // namespace shadowlab::radiosity
