// The passes and stages of planar shadows, and the algorithm as numbered steps. The lecture gives only a figure and a
// formula, so the steps are those of this program.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::planar {

inline constexpr std::string_view kProcedure = "render the scene with all light sources turned off\n"
                                               "write the number of each receiver plane N·P + D = 0 into the stencil\n"
                                               "for each light source P_L\n"
                                               "  clear the shadow marks\n"
                                               "  for each receiver plane (N, D)\n"
                                               "    for each vertex P of a caster\n"
                                               "      w' = (N·P_L + D) - (N·P + D)\n"
                                               "      P' = ((N·P_L + D) P - (N·P + D) P_L) / w'\n"
                                               "    mark its triangles where w' > 0 and N·P + D > 0\n"
                                               "  render the scene with the light turned on where there is no mark";

inline constexpr PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on",
     .pseudocodeLines = {1, 1},
     .formula = "L = emission + ambient * diffuse",
     .anchors = "lights-off"},
    {.id = "tag-receivers",
     .title = "Write the number of each receiver plane N·P + D = 0 into the stencil",
     .why = "A shadow on a plane must end where the plane's surface ends, and where something stands before it.",
     .glState = "colour and depth writes off, depth EQUAL, stencil GREATER, REPLACE, write mask 0x3f, scissor where "
                "shadows can fall",
     .shownBy = "stencil-tags",
     .pseudocodeLines = {2, 2},
     .formula = "N·P + D = 0",
     .anchors = "tag-receivers"},
    {.id = "clear-marks",
     .title = "Clear the shadow marks",
     .why =
         "Each light casts shadows of its own; the numbers of the planes stay. Before the first light there are none.",
     .glState = "stencil write mask 0xc0",
     .perLight = true,
     .pseudocodeLines = {4, 4},
     .anchors = "clear-marks"},
    {.id = "shadows",
     .title = "Project the casters onto each plane and mark where they fall",
     .why = "The line from the light P_L through P meets the plane in P', with N·P' + D = 0: P' is in shadow. Only "
            "what lies between light and plane casts; a mark set twice is still one mark.",
     .glState = "colour and depth writes off, depth test off, clip distances at the light's height and at the plane, "
                "stencil EQUAL the plane's number, REPLACE, write mask 0x80",
     .perLight = true,
     .shownBy = "shadow-marks",
     .pseudocodeLines = {5, 9},
     .formula = "N·P' + D = 0\n"
                "P' = ((N·P_L + D) P - (N·P + D) P_L) / w'\n"
                "w' = (N·P_L + D) - (N·P + D)",
     .anchors = "flatten mark-state"},
    {.id = "count-points",
     .title = "The same for many points of the light; count their shadows in every pixel",
     .why = "A light with an area is many points of light. The share of them whose shadows fall on a pixel is the "
            "share of the light that it does not see. Only with light-samples above 1.",
     .glState = "for each point the marks as before, then one triangle over the picture: stencil EQUAL 0x80, INVERT "
                "(the mark is gone), blending ONE ONE into a picture of floats",
     .perLight = true,
     .shownBy = "points-in-shadow",
     .formula = "points in shadow = points in shadow + 1 where there is a mark",
     .anchors = "count-marks"},
    {.id = "light",
     .title = "Render the scene again with the light turned on, only where there is no mark",
     .why = "What is not marked is seen by the light; what is no plane can have no mark. Where points were counted, "
            "the light is as strong as the share of them that is seen.",
     .glState = "depth EQUAL, stencil EQUAL 0 in the bits 0xc0, INVERT with write mask 0x40 (each pixel once), "
                "blending ONE ONE",
     .perLight = true,
     .pseudocodeLines = {10, 10},
     .formula = "L = L + visibility * color * E * (diffuse / pi + specular * (s + 8) / (8 pi) * (n.h)^s)\n"
                "visibility = 1 - points in shadow / points of the light, where they are counted",
     .anchors = "light-unmarked shade-light share-of-points"},
    {.id = "darken",
     .title = "Draw the flattened faces in black, half transparent, over the finished picture",
     .why = "The oldest way, and wrong: faces that overlap darken twice, and the ambient light, which nothing blocks, "
            "is darkened with the rest. Only with once = false.",
     .glState = "colour writes on, blending SRC_ALPHA ONE_MINUS_SRC_ALPHA with alpha 0.5, tests as for the marks",
     .perLight = true,
     .formula = "L = L / 2 for every face",
     .anchors = "darken"},
};

inline constexpr StageInfo kStages[] = {
    {"receiver-planes", "Receiver planes N·P + D = 0", StageKind::radiance, false},
    {"stencil-tags", "Stencil: the number of the receiver plane", StageKind::swatches, false},
    {"flattened", "Flattened geometry before clipping, on the plane with the most shadow", StageKind::radiance, true},
    {"shadow-marks", "Stencil: shadow marks on the receiver planes", StageKind::swatches, true},
    {"points-in-shadow", "Points of the light whose shadows fall here", StageKind::scalar, true},
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

} // namespace shadowlab::planar
