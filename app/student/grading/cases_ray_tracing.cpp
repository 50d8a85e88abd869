// SPDX-License-Identifier: MIT
#include <array>

#include "app/student/grading/families.h"

namespace shadowlab::student {

namespace {

constexpr std::string_view kRays =
    "rays are exact; on an edge between two triangles rounding decides, a pixel here and there";

constexpr std::array kRayTracingCases = std::to_array<Case>({
    {"ray-lamp", "pixel rays, and shadow rays toward a lamp", "1 2", 8, kRays, 3,
     "Is the scene where it belongs? If not, look at the pixel rays: row 0 is the uppermost, and pixels are squares. "
     "If it is, look at "
     "the shadow ray."},
    {"ray-sun", "shadow rays toward the sun have no end", "2", 8, kRays, 2,
     "The sun has no place: nothing is too far away to stand before it."},
    {"ray-behind-lamp", "a shadow ray ends at its lamp", "2", 8, kRays, 2,
     "What stands behind the lamp shadows nothing: end the ray at the lamp's distance."},
    {"ray-mirror", "the reflection ray", "3", 8, kRays, 3,
     "R = u - 2 (u.N) N. It starts on the surface, and its intensity comes back times k_r.", Judged::picture},
    {"ray-glass", "the refraction ray, into glass and out of it", "4 7 8", 8, kRays, 3,
     "Into glass eta is 1 / ior, out of it ior. Is T a unit vector? Its component along N has the square "
     "cos^2(refracted).",
     Judged::picture},
    {"ray-total", "total reflection", "5", 8, kRays, 2,
     "Where no ray can leave the glass, all of it is reflected: k_t goes over to k_r.", Judged::picture},
    {"ray-mirrors", "the depth of the tree ends what has no end", "6", 8, kRays, 2,
     "The root has level 0. A node at the maximum depth, 4, has no children: its branches have the background's "
     "intensity.",
     Judged::picture},
    {"ray-tree", "the tree itself: the stage tree-depth", "6 7", 8, kRays, 3,
     "A mirror has one child, glass two, dull things none; five levels at most, the root's included.",
     Judged::treeDepth},
});

} // namespace

std::span<const Case> rayTracingCases() { return kRayTracingCases; }

} // namespace shadowlab::student
