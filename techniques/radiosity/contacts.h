// Where things touch, patches end there.
//
// A wall that stands in the middle of a floor patch would have light and dark under it share one radiosity: light leaks into the
// room behind, shadow creeps out from under a box. So patches are cut along every line in which another face meets theirs (the
// simplest part of discontinuity meshing: P. Heckbert, "Discontinuity Meshing for Radiosity", EGWR 1992; D. Lischinski,
// F. Tampieri and D. Greenberg, IEEE Computer Graphics and Applications 12(6), 1992).
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/patches.h"

namespace shadowlab::radiosity {

/// The same patches, those that another face touches or goes through in pieces, in the order of their faces as before.
std::vector<Patch> cutAtContacts(const Faces& faces, std::vector<Patch> patches);

} // namespace shadowlab::radiosity
