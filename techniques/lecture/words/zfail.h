// What the window says of the steps of z-fail (zfail.cpp).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::lecture::zfail {

/// The lecture's "Shadow Volume Using Stencil Buffer".
inline constexpr std::string_view kSteps =
    "1. Render the scene with all light sources turned off.\n"
    "2. Clear stencil buffer.\n"
    "3. Turn off depth buffer and color buffer writes.\n"
    "4. Render all shadow volume faces facing away from the viewer. Increase stencil buffer value by one for each "
    "point that fails the depth test.\n"
    "5. Render all shadow volume faces facing towards the viewer. Decrease stencil buffer value by one for each point "
    "that fails the depth test.\n"
    "6. Turn on depth buffer and color buffer writes.\n"
    "7. Render the scene again with light source turned on and only where the stencil buffer value is zero.\n"
    "8. Repeat 2, 3, 4, 5, 6, 7 for each light source.";

inline constexpr PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "The depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on",
     .pseudocodeLines = {1, 1},
     .formula = "L = emission + ambient * diffuse",
     .anchors = "zfail-passes lights-off"},
    {.id = "clear-stencil",
     .title = "Clear the stencil buffer",
     .why = "Each light source is counted by itself.",
     .glState = "stencil write mask 0xff",
     .perLight = true,
     .pseudocodeLines = {2, 2},
     .formula = "stencil = 0",
     .anchors = "zfail-passes zfail-volume zfail-facing zfail-outline zfail-extrude"},
    {.id = "volumes-back",
     .title = "Render all shadow volume faces facing away from the viewer",
     .why = "Increase the stencil by one for each point that fails the depth test: the face lies behind the point, and "
            "the ray from the point to infinity leaves a volume there.",
     .glState = "colour and depth writes off, cull FRONT, depth LESS, depth clamp, stencil depth-fail INCR_WRAP",
     .perLight = true,
     .shownBy = "stencil-back",
     .pseudocodeLines = {3, 4},
     .formula = "stencil = stencil + 1 where a face that faces away fails the depth test: n_b",
     .anchors = "zfail-count zfail-draw"},
    {.id = "volumes-front",
     .title = "Render all shadow volume faces facing towards the viewer",
     .why = "Decrease the stencil by one for each point that fails the depth test: the ray enters a volume there. What "
            "was entered and left cancels.",
     .glState = "colour and depth writes off, cull BACK, depth LESS, depth clamp, stencil depth-fail DECR_WRAP",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {5, 5},
     .formula = "stencil = stencil - 1 where a face that faces the viewer fails the depth test: n_b - n_f",
     .anchors = "zfail-count zfail-draw"},
    {.id = "light",
     .title = "Render the scene again with light source turned on, only where the stencil is zero",
     .why = "n_f = n_b: the point is outside of every shadow volume, so it is illuminated.",
     .glState = "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true,
     .pseudocodeLines = {6, 7},
     .formula = "illuminated if n_f = n_b",
     .anchors = "lecture-light-on shade-light"},
};

inline constexpr StageInfo kStages[] = {
    {"volume-parts", "Shadow volume: top cap, sides, bottom cap", StageKind::radiance, true},
    {"stencil-back", "Stencil after the back faces: n_b behind the point", StageKind::count, true},
    {"stencil", "Stencil: n_b - n_f behind the point; zero is illuminated", StageKind::count, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

} // namespace shadowlab::lecture::zfail
