// What the window says of the steps of the shadow map (shadow_map.cpp).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::lecture::shadow_map {

/// The lecture's procedure, word by word.
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

inline constexpr PassInfo kPasses[] = {
    {.id = "depth",
     .title = "Render the scene from the perspective of the light source, and save its depth as shadow map",
     .why = "In every direction the map keeps the distance of the first surface: all that the light source sees.",
     .glState = "depth only, depth test LESS, depth clamp, polygon offset",
     .perLight = true,
     .shownBy = "light-depth",
     .pseudocodeLines = {2, 3},
     .formula = "d(u,v) = depth of the first surface that the light sees at (u,v)",
     .anchors = "map-camera map-render map-casters"},
    {.id = "lights-off",
     .title = "Render the scene from the original view point, all light sources turned off",
     .why = "The depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on",
     .pseudocodeLines = {4, 4},
     .formula = "L = emission + ambient * diffuse",
     .anchors = "lights-off"},
    {.id = "light",
     .title = "Transform each point into light source coordinates, compare, and add the light where it is seen",
     .why =
         "If the sample of the map is less than the point's own r coordinate, something nearer to the light is in the "
         "way: the point is in shadow.",
     .glState = "depth EQUAL, blending ONE ONE, map sampled at the nearest texel",
     .perLight = true,
     .shownBy = "comparison",
     .pseudocodeLines = {5, 10},
     .formula = "(s, t, r) = clip / w / 2 + 1/2\nz(u,v) = r, shadowed if d(u,v) < z(u,v)",
     .anchors = "map-coordinates map-comparison map-receivers shade-light"},
};

inline constexpr StageInfo kStages[] = {
    {"light-depth", "Depth from light: depth map D", StageKind::scalar, true},
    {"depth-on-view", "Light depth d(u,v), projected onto eye", StageKind::scalar, true},
    {"distance-on-view", "Light distance z(u,v), projected onto eye", StageKind::scalar, true},
    {"comparison", "Comparison (green = equal)", StageKind::swatches, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

} // namespace shadowlab::lecture::shadow_map
