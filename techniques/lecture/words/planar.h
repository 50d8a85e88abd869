// What the window says of the steps of planar shadows (planar.cpp).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::lecture::direct_projection {

/// The lecture's "Direct Projection Method" is a figure and a formula; these are its steps.
inline constexpr std::string_view kSteps = "render the scene with all light sources turned off\n"
                                           "for each light source P_L\n"
                                           "  for each projection plane N·P + D = 0\n"
                                           "    for each point P of an object\n"
                                           "      project P from P_L onto the plane: P', with N·P' + D = 0\n"
                                           "    mark the projected object in the stencil, where the plane is seen\n"
                                           "  render the scene with the light turned on where there is no mark";

inline constexpr PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "The depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on",
     .pseudocodeLines = {1, 1},
     .formula = "L = emission + ambient * diffuse",
     .anchors = "projection-passes lights-off"},
    {.id = "shadows",
     .title = "Project every object onto every projection plane and mark its shadow",
     .why = "The line from the light source P_L through a point P of an object meets the plane in P': that place is in "
            "the shadow of P.",
     .glState = "colour and depth writes off, depth test off, clip distance at the plane, stencil bit 7: the plane is "
                "seen here, bit 0: shadow",
     .perLight = true,
     .shownBy = "flattened",
     .pseudocodeLines = {3, 6},
     .formula = "N·P' + D = 0\nP' = ((N·P_L + D) P - (N·P + D) P_L) / w'\nw' = (N·P_L + D) - (N·P + D)",
     .anchors = "projection-matrix projection-equation projection-plane projection-vertex projection-mark projection-tag "
                "projection-draw"},
    {.id = "light",
     .title = "Render the scene again with the light source turned on, only where there is no mark",
     .why = "What lies on no projection plane has no mark: curved surfaces receive no shadows.",
     .glState = "depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true,
     .pseudocodeLines = {7, 7},
     .formula = "illuminated if there is no mark",
     .anchors = "lecture-light-on shade-light"},
};

inline constexpr StageInfo kStages[] = {
    {"flattened", "Objects projected onto the planes, face by face", StageKind::radiance, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

} // namespace shadowlab::lecture::direct_projection
