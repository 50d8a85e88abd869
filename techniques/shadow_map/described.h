// The passes and stages of shadow maps, and the procedure that the lecture writes.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/technique.h"

namespace shadowlab::shadow_map {

inline constexpr std::string_view kProcedure = "procedure SHADOWMAPPING\n"
                                               "  render z-buffer from light's point of view to depth map D\n"
                                               "  store D as texture map d(u,v)\n"
                                               "  render scene S from the eye's point of view into image A\n"
                                               "  for each rasterized pixel of A with texture coords (u,v)\n"
                                               "      in eye space and transformed distance z(u,v) do\n"
                                               "    if d(u,v) < z(u,v) then\n"
                                               "      pixel is shadowed\n"
                                               "    end if\n"
                                               "  end for";

/// In the order in which they are drawn.
std::span<const PassInfo> passes();

inline constexpr StageInfo kStages[] = {
    {"without-shadows", "Image without shadows", StageKind::radiance, false},
    {"light-view", "Image from the light", StageKind::radiance, true},
    {"light-depth", "Depth from the light: the shadow map", StageKind::scalar, true},
    {"depth-on-view", "Light depth d(u,v) projected onto the eye's view", StageKind::scalar, true},
    {"distance-on-view", "Light distance z(u,v) projected onto the eye's view", StageKind::scalar, true},
    {"comparison", "Comparison: d(u,v) against z(u,v)", StageKind::swatches, true},
    {"texel-size", "Aliasing: how many pixels a texel covers", StageKind::scalar, true},
    {"texel-grid", "The texels as they lie on what the eye sees", StageKind::swatches, true},
    {"map-layers", "Which map answers: cascades, or those around the light", StageKind::swatches, true},
    {"moments", "Moments: how much the depths around each texel vary", StageKind::scalar, true},
    {"blocker-search", "Blocker search: how far before the point its shadow comes from", StageKind::scalar, true},
    {"penumbra-width", "Penumbra: how wide the shadow's edge is to be", StageKind::scalar, true},
    {"kernel", "Which texels are asked for one pixel, and their answers", StageKind::swatches, true},
    {"eye-samples", "Where in the light's picture the eye asks", StageKind::scalar, true},
    {"traced", "What the map decides for certain, and what rays do", StageKind::swatches, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

} // namespace shadowlab::shadow_map
