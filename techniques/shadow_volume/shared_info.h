// What the techniques of this folder say alike of their passes and stages.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::shadow_volume {

inline constexpr PassInfo kLightsOffPass = {
    "lights-off", "Render the scene with all light sources turned off",
    "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
    "depth test LESS, depth write on", false};

inline constexpr StageInfo kFacingStage = {"facing", "Faces by the sign of N·L", StageKind::swatches, true};
inline constexpr StageInfo kLightsOffStage = {"lights-off", "Scene with lights off", StageKind::radiance, false};
inline constexpr StageInfo kSilhouettesStage = {"silhouettes", "Silhouettes seen from the light", StageKind::radiance,
                                                true};
inline constexpr StageInfo kVolumeSignsStage = {"volume-signs", "Volume faces by the side they turn to the viewer",
                                                StageKind::radiance, true};
inline constexpr StageInfo kStencilStage = {"stencil", "Stencil after all faces: zero is lit", StageKind::count, true};
inline constexpr StageInfo kVisibilityStage = {"visibility", "Visibility of the light", StageKind::visibility, true};

} // namespace shadowlab::shadow_volume
