// SPDX-License-Identifier: MIT
#include <array>

#include "app/student/grading/families.h"

namespace shadowlab::student {

namespace {

constexpr std::string_view kExactVolume = "volumes are exact but for cracks between triangles, a pixel here and there";

constexpr std::array kShadowVolumeCases = std::to_array<Case>({
    {"volume-lamp", "silhouette, extrusion and count, for a lamp", "1 2 3", 8, kExactVolume, 3,
     "Draw the volumes as a picture, front faces in one colour, back faces in another: are they closed?"},
    {"volume-sun", "the same for the sun: all sides meet at infinity", "1 3", 8, kExactVolume, 2,
     "The light is a homogeneous point: from v it lies toward light.xyz - light.w v, for lamp and sun alike."},
    {"volume-knot", "a mesh that shadows itself", "1 2", 20, kExactVolume, 2,
     "The top cap lies on the caster's own surface: same vertices, same order, depth test LESS and not LEQUAL."},
    {"volume-eye-inside", "the eye stands in a shadow", "7", 8, kExactVolume, 3,
     "Count what lies behind the point, where the depth test fails. What lies before it begins with the eye."},
    {"volume-along-light", "volumes are closed at infinity", "4", 12, kExactVolume, 2,
     "A line that stays in a volume to its end leaves it through the bottom cap."},
    {"volume-mirrored", "meshes that a mirror has turned inside out", "1 2", 8, kExactVolume, 2,
     "Which corner order is the front depends on the object: scene::isMirrored, glFrontFace."},
    {"volume-row", "points in several volumes at once", "5 6", 12, kExactVolume, 2,
     "Add one for each face behind a point that faces away, then take one for each that faces the viewer: in the light nothing is left."},
    {"volume-long", "a shadow falls as far as there is something", "3", 12, kExactVolume, 2,
     "Extrude to infinity (w = 0), and clamp depths, so that the far plane does not cut the volume open."},
});

} // namespace

std::span<const Case> shadowVolumeCases() { return kShadowVolumeCases; }

} // namespace shadowlab::student
