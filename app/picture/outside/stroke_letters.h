// Letters made of a few straight lines, to be drawn in the scene like any other lines: names of rays and vectors.
// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::picture {

/// Adds the lines of a word, two points for each, with its middle at `centreWorld`. `rightWorld` and `upWorld` are the
/// width and the height of a capital letter. Known are the digits and H L N R S T V u; anything else is a gap.
void addWord(std::vector<dvec3>& pointsWorld, std::string_view word, const dvec3& centreWorld, const dvec3& rightWorld,
             const dvec3& upWorld);

} // namespace shadowlab::picture
