// What `shadowlab measure` and `shadowlab report` have in common.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::cli {

/// Sets aside the memory that truth and verdicts of pictures of that size take. Throws Error (overLimit).
void reserveForMeasured(ivec2 size);

/// Technique ids of -t, with commas between them. `all` stands for every production technique that publishes its visibility of
/// one light, `lecture` for the lecture's own.
std::vector<std::string> measuredTechniquesFrom(const std::vector<std::string>& texts);

} // namespace shadowlab::cli
