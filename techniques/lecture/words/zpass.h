// What the window says of the steps of z-pass (zpass.cpp).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::lecture::zpass {

/// The lecture's "Z-Pass Shadow Volume Algorithm".
inline constexpr std::string_view kSteps =
    "1. For each point in the scene, connect a line segment from this point to the view point.\n"
    "2. Count the number of front facing and back facing shadow volume faces this line segment intersects: n_f and "
    "n_b.\n"
    "3. If n_f = n_b the point is illuminated, otherwise it is in the shadow.";

inline constexpr PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "The depth buffer now holds, for every pixel, the end of the line segment from the view point.",
     .glState = "depth test LESS, depth write on",
     .pseudocodeLines = {1, 1},
     .formula = "L = emission + ambient * diffuse",
     .anchors = "zpass-passes lights-off"},
    {.id = "clear-stencil",
     .title = "Clear the stencil buffer",
     .why = "The count starts at zero: the view point is taken to be outside of every shadow volume.",
     .glState = "stencil write mask 0xff",
     .perLight = true,
     .formula = "stencil = 0",
     .anchors = "zpass-passes zpass-sides zpass-facing zpass-silhouette"},
    {.id = "volumes-front",
     .title = "Render the front facing shadow volume faces",
     .why = "A face that passes the depth test lies between view point and point. Where it is front facing, the line "
            "segment enters a shadow volume: +1.",
     .glState = "colour and depth writes off, cull BACK, depth LESS, stencil depth-pass INCR_WRAP",
     .perLight = true,
     .shownBy = "stencil-front",
     .pseudocodeLines = {2, 2},
     .formula = "stencil = stencil + 1 where a front face passes the depth test: n_f",
     .anchors = "zpass-count zpass-draw"},
    {.id = "volumes-back",
     .title = "Render the back facing shadow volume faces",
     .why = "Where a face that passes is back facing, the line segment leaves the shadow volume again: -1.",
     .glState = "colour and depth writes off, cull FRONT, depth LESS, stencil depth-pass DECR_WRAP",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {2, 2},
     .formula = "stencil = stencil - 1 where a back face passes the depth test: n_f - n_b",
     .anchors = "zpass-count zpass-draw"},
    {.id = "light",
     .title = "Render the scene again with light source turned on, only where n_f = n_b",
     .why = "The line segment left every volume that it entered: the point is illuminated.",
     .glState = "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true,
     .pseudocodeLines = {3, 3},
     .formula = "illuminated if n_f = n_b",
     .anchors = "lecture-light-on shade-light"},
};

inline constexpr StageInfo kStages[] = {
    {"silhouettes", "Silhouettes seen from the light", StageKind::radiance, true},
    {"volume-signs", "Shadow volume: front faces +1, back faces -1", StageKind::radiance, true},
    {"stencil-front", "Stencil after the front faces: n_f before the point", StageKind::count, true},
    {"stencil", "Stencil: n_f - n_b before the point; zero is illuminated", StageKind::count, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

} // namespace shadowlab::lecture::zpass
