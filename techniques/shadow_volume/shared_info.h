// The passes and stages that the three techniques of this folder have in common.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::shadow_volume {

// The three techniques, each in the file of its name.
TechniqueInfo zpassInfo();
TechniqueInfo zfailInfo();
TechniqueInfo automaticInfo();

inline constexpr PassInfo kLightsOffPass = {
    .id = "lights-off",
    .title = "Render the scene with all light sources turned off",
    .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
    .glState = "depth test LESS, depth write on",
    .pseudocodeLines = {1, 1},
    .formula = "L = emission + ambient * diffuse",
    .anchors = "lights-off"};

/// What the stencil holds after the steps before the last one.
inline constexpr NamedValue kCleared[] = {{"stencil", "stencil, cleared"}};
inline constexpr NamedValue kAfterBacks[] = {{"stencil", "stencil after the back faces"}};
inline constexpr NamedValue kAfterFronts[] = {{"stencil", "stencil after the front faces"}};

inline constexpr PassInfo kClearStencilPass = {.id = "clear-stencil",
                                               .title = "Clear the stencil buffer",
                                               .why = "Each light counts from zero.",
                                               .glState = "stencil write mask 0xff",
                                               .perLight = true,
                                               .pseudocodeLines = {2, 2},
                                               .formula = "stencil = 0",
                                               .anchors = "clear-count",
                                               .values = kCleared};

/// The lecture's "Shadow Volume Using Stencil Buffer"; it counts with depth fail.
inline constexpr std::string_view kStencilSteps =
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

/// The lecture's "Z-Pass Shadow Volume Algorithm".
inline constexpr std::string_view kZPassSteps =
    "1. For each point in the scene, connect a line segment from this point to the view point.\n"
    "2. Count the number of front facing and back facing shadow volume faces this line segment intersects: n_f and "
    "n_b.\n"
    "3. If n_f = n_b the point is illuminated, otherwise it is in the shadow.";

inline constexpr StageInfo kFacingStage = {"facing", "Faces by the sign of N·L", StageKind::swatches, true};
inline constexpr StageInfo kLightsOffStage = {"lights-off", "Scene with lights off", StageKind::radiance, false};
inline constexpr StageInfo kSilhouettesStage = {"silhouettes", "Silhouettes seen from the light", StageKind::radiance,
                                                true};
inline constexpr StageInfo kVolumeSignsStage = {"volume-signs", "Volume faces by the side they turn to the viewer",
                                                StageKind::radiance, true};
inline constexpr StageInfo kStencilStage = {"stencil", "Stencil after all faces: zero is lit", StageKind::count, true};
inline constexpr StageInfo kVisibilityStage = {"visibility", "Visibility of the light", StageKind::visibility, true};

} // namespace shadowlab::shadow_volume
