// What the three techniques of this folder have in common: the lecture's procedure, the first passes, the stages of a map.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::shadow_map {

// The three techniques, each in the file of its name.
TechniqueInfo shadowMapInfo();
TechniqueInfo exactMapInfo();
TechniqueInfo aliasFreeMapInfo();

/// The lecture's "procedure SHADOWMAPPING".
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

inline constexpr PassInfo kLightsOffPass = {
    .id = "lights-off",
    .title = "Render the scene with all light sources turned off",
    .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
    .glState = "depth test LESS, depth write on",
    .pseudocodeLines = {4, 4},
    .formula = "L = emission + ambient * diffuse",
    .anchors = "lights-off"};

/// The pass `light` where visibility was decided before, by rays or by triangles; lines of kProcedure.
inline constexpr PassInfo kDecidedLightPass = {
    .id = "light",
    .title = "Render the scene from the eye, with the light where it arrives",
    .why = "Every pixel's visibility has been decided; the light is added where that is one.",
    .glState = "depth EQUAL, blending ONE ONE, visibility read with texelFetch",
    .perLight = true,
    .pseudocodeLines = {8, 10},
    .formula = "L = L + visibility * color * E * (diffuse / pi + specular * (s + 8) / (8 pi) * (n.h)^s)",
    .anchors = "shade-light"};

/// The same pass in another procedure, of which these are its lines.
constexpr PassInfo atLines(PassInfo pass, LineRange lines) {
    pass.pseudocodeLines = lines;
    return pass;
}

inline constexpr std::string_view kMapFormula = "d(u,v) = the least depth on the light's ray through the texel";

/// Names in formulas and source, and the facts of a probe that are their values where a map is looked up.
inline constexpr NamedValue kMapValues[] = {{"d(u,v)", "d(u,v) as it is compared"},
                                            {"z(u,v)", "z(u,v) as it is compared, the bias taken off"},
                                            {"pixel is shadowed", "if d(u,v) < z(u,v) then pixel is shadowed"},
                                            {"(s, t, r)", "(s, t, r) = clip / w / 2 + 1/2"},
                                            {"shadowUv", "(s, t, r) = clip / w / 2 + 1/2"},
                                            {"lightClip", "point in the light's clip space"},
                                            {"referenceDepth", "z(u,v) as it is compared, the bias taken off"}};

inline constexpr StageInfo kWithoutShadowsStage = {"without-shadows", "Image without shadows", StageKind::radiance,
                                                   false};
inline constexpr StageInfo kLightViewStage = {"light-view", "Image from the light", StageKind::radiance, true, false, true};
inline constexpr StageInfo kLightDepthStage = {"light-depth", "Depth from the light: the shadow map", StageKind::scalar,
                                               true, false, true};
inline constexpr StageInfo kDepthOnViewStage = {"depth-on-view", "Light depth d(u,v), projected onto the eye's view",
                                                StageKind::scalar, true};
inline constexpr StageInfo kDistanceOnViewStage = {
    "distance-on-view", "Light distance z(u,v), projected onto the eye's view", StageKind::scalar, true};
inline constexpr StageInfo kComparisonStage = {"comparison", "Comparison: d(u,v) against z(u,v)", StageKind::swatches,
                                               true};
inline constexpr StageInfo kTexelSizeStageInfo = {kTexelSizeStage, "Aliasing: how many pixels a texel covers",
                                                  StageKind::scalar, true};
inline constexpr StageInfo kTexelGridStage = {"texel-grid", "The texels as they lie on what the eye sees",
                                              StageKind::swatches, true};
inline constexpr StageInfo kMapLayersStage = {"map-layers", "Which map answers: cascades, or those around the light",
                                              StageKind::swatches, true};
inline constexpr StageInfo kVisibilityStageInfo = {kVisibilityStage, "Visibility of the light", StageKind::visibility,
                                                   true};

/// What `inspect` says about a mesh.
inline std::string remarkOn(const scene::MeshReport& report) {
    return std::string("any mesh that can be drawn can be mapped") +
           (report.hasHoles ? ", and so can the holes that an alpha map cuts" : "");
}

} // namespace shadowlab::shadow_map
