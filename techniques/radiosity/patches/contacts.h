// Patches are cut where other things touch them.
//
// A patch under a wall has one radiosity for its lit and its dark part: light leaks into the room behind, and shadow creeps out
// from under a box. So patches are cut along every line in which another face meets theirs. This is the simplest part of
// discontinuity meshing: P. Heckbert, "Discontinuity Meshing for Radiosity", EGWR 1992; D. Lischinski, F. Tampieri and D.
// Greenberg, IEEE Computer Graphics and Applications 12(6), 1992.
//
// What lies close before a patch without touching it, a rug on a floor or a lamp under a ceiling, does nearly the same as if it
// touched: the part of the patch that it covers exchanges light with it alone. So patches are cut along its outline as well.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

/// A face lies close above another when no corner is farther from its plane than this share of the face's size. The light that gets in
/// between them from the sides then comes no farther than to a narrow rim.
constexpr double kCloseAbove = 0.1;

/// A segment on the front of a face along which another face stands on it, lies on it or close above it, or passes through it.
/// Centred space.
struct Contact {
    dvec3 from, to;
    std::uint32_t other; ///< face
};

/// The contacts of every face, in the order of the other faces, including those along its edges (also with the faces that it is
/// joined to, if they are not behind it). Faces that touch only its back, or only a point, are left out.
std::vector<std::vector<Contact>> contactsOf(const Faces& faces);

/// The same patches, with those that another face touches or crosses cut into pieces; in the order of their faces as before.
std::vector<Patch> cutAtContacts(const Faces& faces, std::vector<Patch> patches);

} // namespace shadowlab::radiosity
