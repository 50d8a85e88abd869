// Where things touch, patches end there.
//
// A wall that stands in the middle of a floor patch would have light and dark under it share one radiosity: light leaks into the
// room behind, shadow creeps out from under a box. So patches are cut along every line in which another face meets theirs (the
// simplest part of discontinuity meshing: P. Heckbert, "Discontinuity Meshing for Radiosity", EGWR 1992; D. Lischinski,
// F. Tampieri and D. Greenberg, IEEE Computer Graphics and Applications 12(6), 1992).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

/// A line on the front of a face along which another face meets it: stands on it, lies on it, or goes through. Centred space.
struct Contact {
    dvec3 from, to;
    std::uint32_t other; ///< face
};

/// Of every face its contacts, in the order of the other faces, within it and along its edges (there also those with the faces
/// that it is joined to, if they are not behind it). What only touches its back, or in a point, is left out.
std::vector<std::vector<Contact>> contactsOf(const Faces& faces);

/// The same patches, those that another face touches or goes through in pieces, in the order of their faces as before.
std::vector<Patch> cutAtContacts(const Faces& faces, std::vector<Patch> patches);

} // namespace shadowlab::radiosity
