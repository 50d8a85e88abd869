// The steps of lecture/ray_tracing.cpp, as the lecture words them, and the pictures of what they find.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::lecture {

inline constexpr std::string_view kRayCastingProcedure =
    "1. Cast pixel ray from projection reference point through pixel center.\n"
    "2. Each time a pixel ray intersects an object surface, it splits into a reflection ray and a refraction ray.\n"
    "3. Repeat step 2. Each intersected surface is added to a binary ray-tracing tree.\n"
    "4. A ray is terminated when it intersects no surfaces, intersects a light source that is not a reflecting "
    "surface, or the tree reaches maximum allowable depth.\n"
    "5. Process the tree in bottom-up order: accumulate the intensities from reflection ray, refraction ray and "
    "all the light sources, attenuated by distance. The pixel intensity is obtained at the root.";

inline constexpr PassInfo kRayPasses[] = {
    {.id = "pixel-rays",
     .title = "Cast a pixel ray through each pixel centre",
     .why = "The nearest surface is visible.",
     .glState = "none: the processor traces",
     .shownBy = "distance",
     .pseudocodeLines = {1, 1},
     .formula = "P = eye + t u, t the least at which a surface is met",
     .anchors = "lecture-pixel-ray lecture-intersection lecture-bounding-volume lecture-top-down "
                "lecture-bounding-volume-tree"},
    {.id = "shadow-rays",
     .title = "Send a shadow ray to the light from each visible surface",
     .why = "The surface is in shadow if the segment to the light intersects any object.",
     .glState = "none: the processor traces",
     .perLight = true,
     .shownBy = "visibility",
     .pseudocodeLines = {5, 5},
     .formula = "visibility = 0 if anything lies between P and the light, else 1",
     .anchors = "lecture-shadow-ray"},
    {.id = "tree",
     .title = "Split rays at each surface: the binary ray-tracing tree",
     .why = "A mirror shows what its reflection ray meets, glass also what its refraction ray meets.",
     .glState = "none: the processor traces",
     .shownBy = "tree-depth",
     .pseudocodeLines = {2, 4},
     .formula = "R = u - 2 (u.N) N",
     .anchors = "lecture-tree lecture-secondary-rays lecture-refraction"},
    {.id = "intensity",
     .title = "Process the tree in bottom-up order",
     .why = "The pixel intensity is that of the root.",
     .glState = "none: the processor shades; the picture is uploaded",
     .pseudocodeLines = {5, 5},
     .formula = "I = (I of all light sources + k_r I_R + k_t I_T) / (1 + c1 d + c2 d^2)",
     .anchors = "lecture-intensity"},
};

inline constexpr StageInfo kRayStages[] = {
    {"distance", "How far pixel rays travel", StageKind::scalar, false},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
    {"tree-depth", "Levels of the ray-tracing tree", StageKind::scalar, false},
};

} // namespace shadowlab::lecture
