// What a foreign picture's errors look like: the causes that explain them best, with their evidence, the likeliest first.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/foreign/evidence.h"
#include "app/foreign/worst_region.h"

namespace shadowlab::foreign {

enum class Beside {
    first,   ///< it explains most
    instead, ///< it explains nearly as much of the same: the evidence does not decide
    also,    ///< it explains a good part of what the first leaves
};

struct NamedCause {
    std::string id, what, remedy;
    double explained = 0;         ///< share of all wrong pixels, less right ones that it makes wrong
    double explainedInRegion = 0; ///< the same within the worst region's box
    Beside beside = Beside::first;
};

struct Diagnosis {
    std::optional<Region> region;   ///< none: nothing is wrong
    std::vector<NamedCause> causes; ///< one; or two, where the evidence does not decide or both are seen; none: no cause that is known explains much
};

/// Takes some seconds for large pictures. `evidence` gets its samples here.
Diagnosis diagnose(Evidence& evidence);

/// The technique whose figure shows that cause: a shadow map's or a shadow volume's.
std::string_view techniqueShowing(std::string_view causeId);

} // namespace shadowlab::foreign
