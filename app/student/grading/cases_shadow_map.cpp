// SPDX-License-Identifier: MIT
#include <array>

#include "app/student/grading/families.h"

namespace shadowlab::student {

namespace {

constexpr std::string_view kTexels =
    "outlines are as coarse as texels: a right map of 1024 x 1024 texels stays well below";

constexpr std::array kShadowMapCases = std::to_array<Case>({
    {"map-lamp", "the light's camera for a lamp", "2 4 5", 40, kTexels, 3,
     "Does the lamp take in the whole ball? Half its angle is the arc sine of the radius over the distance."},
    {"map-sun", "the light's camera for the sun: parallel rays", "1 4 5", 40, kTexels, 3,
     "An orthographic camera, looking along the light, that takes in the ball around all casters."},
    {"map-grazing", "no acne on a surface that the light grazes", "3", 80, kTexels, 2,
     "The bias has to grow with the slope: the factor of glPolygonOffset, not its units."},
    {"map-contact", "a shadow begins where its caster stands", "3", 90, kTexels, 2,
     "A bias that is too large lets light under the wall: peter-panning. Let it follow the slope."},
    {"map-behind-lamp", "what is behind the lamp is in no map", "4", 40, kTexels, 2,
     "Behind the lamp w is negative, and the division by it mirrors the point into the map."},
    {"map-round", "round things that shadow themselves", "3", 150, kTexels, 2,
     "Acne, or a bias that lights the inside of the ring? Look at the difference."},
    {"map-sheet", "a sheet one millimetre thick casts", "3", 110, kTexels, 2,
     "Do not draw back faces alone into the map: the sheet's are a millimetre behind its front."},
    {"map-distant-lamp", "near and far planes that fit", "2", 40, kTexels, 2,
     "Depths of a perspective camera are fine near its near plane alone: move it out to the first caster."},
});

} // namespace

std::span<const Case> shadowMapCases() { return kShadowMapCases; }

} // namespace shadowlab::student
