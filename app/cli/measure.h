// What `shadowlab measure` and `shadowlab report` have in common.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::cli {

/// Sets aside the memory that truth and verdicts of pictures of that size take, and where pixels have several samples on a side a
/// picture of those. Throws Error (overLimit).
void reserveForMeasured(ivec2 size, int samples = 1);

/// Technique ids of -t, with commas between them. `all` stands for every production technique that publishes its visibility of
/// one light, `lecture` for the lecture's own.
std::vector<std::string> measuredTechniquesFrom(const std::vector<std::string>& texts);

} // namespace shadowlab::cli
