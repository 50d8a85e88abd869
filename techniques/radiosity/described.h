// The passes and stages of radiosity, in the words of the lecture.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::radiosity {

/// The lecture's "Basic Radiosity Model". As in its figure of the form factor, j is the patch at hand and k another.
inline constexpr std::string_view kModel =
    "1. The object surfaces must form an enclosed space that has no energy exchange with outside world.\n"
    "2. Assume each surface is either a Lambertian reflector, a emitter, or a combination of both.\n"
    "3. Divide each surface into small surface polygons (surface patches)\n"
    "   and calculate form factors.\n"
    "4. Solve radiosity equations: B_j = E_j + rho_j * sum over k of F_jk * B_k,\n"
    "   j = 1, 2, 3, ..., n.";

inline constexpr PassInfo kPasses[] = {
    {.id = "patches",
     .title = "Divide each surface into small surface patches",
     .why = "One radiosity stands for all of a patch. Rectangles and triangles are cut to one size, and where other "
            "things stand on them; meshes of many triangles are simplified first.",
     .glState = "nothing is drawn",
     .shownBy = "patches",
     .pseudocodeLines = {3, 3},
     .anchors = "cut-into-patches"},
    {.id = "form-factors",
     .title = "Calculate the form factors",
     .why = "F_jk is the fraction of the radiant energy leaving surface j that reaches surface k. It depends on shapes "
            "and places alone, so it stays when a light moves or changes.",
     .glState = "nothing is drawn",
     .shownBy = "form-factors",
     .pseudocodeLines = {4, 4},
     .formula = "F_jk = 1 / dA_j * integral over both surfaces of cos phi_j cos phi_k / (pi r^2)\n"
                "dA_j F_jk = dA_k F_kj",
     .anchors = "form-factor-of-a-point"},
    {.id = "emission",
     .title = "Show what the surfaces emit",
     .why = "E_k, the energy emission rate per unit area: all the light there is before any of it has arrived.",
     .glState = "depth test LESS, depth write on",
     .pseudocodeLines = {2, 2},
     .formula = "B_j = E_j",
     .anchors = "lights-off"},
    {.id = "light",
     .title = "Add what one light brings straight to the patches",
     .why = "The first shot: a light that is no patch itself shines on every patch that it sees, and each reflects its "
            "share rho_k.",
     .glState = "depth test EQUAL",
     .perLight = true,
     .formula = "B_j = E_j + rho_j * (irradiance of patch j by the light)",
     .anchors = "light-on-a-patch"},
    {.id = "solve",
     .title = "Solve the radiosity equations",
     .why = "Every patch sends on what it receives from all others: n equations for the n radiosities, solved step by "
            "step until the error is certainly small.",
     .glState = "depth test EQUAL, one value per patch",
     .pseudocodeLines = {5, 6},
     .formula = "B_j = E_j + rho_j * sum over k of F_jk * B_k\n"
                "residual of j = E_j + rho_j * sum over k of F_jk * B_k - B_j",
     .anchors = "radiosity-problem one-bounce residual"},
    {.id = "display",
     .title = "Show it from the eye's point of view",
     .why = "A Lambertian reflector of radiosity B looks alike from everywhere: its intensity is I = B / pi. So the "
            "eye may move, and nothing has to be solved again.",
     .glState = "depth test EQUAL, interpolated between the corners of patches",
     .formula = "I = B_j / pi",
     .anchors = "radiosity-shown final-gather chosen-point shared-gather"},
    {.id = "direct",
     .title = "Add one light's direct light, found for each pixel",
     .why = "Patches are far larger than the edge of a shadow; but light that comes by way of other surfaces changes slowly. So "
            "patches are left to that, and each pixel asks by a ray of its own whether the light is seen.",
     .glState = "depth test EQUAL, blending ONE, ONE",
     .perLight = true,
     .formula = "I += rho / pi * (irradiance of the pixel by the light) * (share of the light that is seen)",
     .anchors = "light-on-a-pixel direct-light-of-a-pixel"},
};

inline constexpr StageInfo kStages[] = {
    {"patches", "The patches, coloured by why they were cut", StageKind::swatches, false},
    {"form-factors", "Form factors of one patch: what share of its light goes where", StageKind::scalar, false, true},
    {"matrix", "All form factors as a matrix, and its row sums", StageKind::swatches, false, false, true},
    {"row-sums", "Sum of each patch's form factors: 1 in a closed room", StageKind::scalar, false},
    {"surroundings", "Share of each patch's view in which there is no surface", StageKind::scalar, false},
    {"emission", "Emission: what shines by itself", StageKind::radiance, false},
    {"first-bounce", "Light that was reflected once", StageKind::radiance, false},
    {"bounce", "Light reflected several times: parameter bounce says how often", StageKind::radiance, false},
    {"reflected", "Light that was reflected more than once: what direct light alone leaves out", StageKind::radiance,
     false},
    {"residual", "Received and not yet sent on: how far the equations are from true", StageKind::scalar, false},
    {"radiosity", "Radiosity, one value for each patch", StageKind::radiance, false},
    {"interpolated", "Radiosity, interpolated between corners of patches", StageKind::radiance, false},
    {"visibility", "The share of a light that arrives, as pixels, points or patches know it", StageKind::visibility, true},
};

} // namespace shadowlab::radiosity
