// The passes and stages of radiosity, in the words of a lecture.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::radiosity {

inline constexpr PassInfo kPasses[] = {
    {"patches", "Divide each surface into small surface patches",
     "One radiosity stands for all of a patch. Rectangles and triangles are cut to one size, and where other things "
     "stand on them; "
     "meshes of many triangles are simplified first.",
     "nothing is drawn", false, "patches"},
    {"form-factors", "Calculate the form factors",
     "F_jk is the fraction of the radiant energy leaving surface j that reaches surface k. It depends on shapes and "
     "places "
     "alone, so it stays when a light moves or changes.",
     "nothing is drawn", false, "form-factors"},
    {"emission", "Show what the surfaces emit",
     "E_k, the energy emission rate per unit area: all the light there is before any of it has arrived.",
     "depth test LESS, depth write on", false},
    {"light",
     "Add what one light brings straight to the patches",
     "The first shot: a light that is no patch itself shines on every patch that it sees, and each reflects its share "
     "rho_k.",
     "depth test EQUAL",
     true,
     {},
     "E_k + rho_k * (irradiance of patch k by the light)"},
    {"solve",
     "Solve the radiosity equations",
     "Every patch sends on what it receives from all others: n equations for the n radiosities, solved step by step "
     "until the error is "
     "certainly small.",
     "depth test EQUAL, one value per patch",
     false,
     {},
     "B_k = E_k + rho_k * sum over j of F_kj * B_j\nfor k = 1, 2, 3, ..., n"},
    {"display", "Show it from the eye's point of view",
     "A Lambertian reflector of radiosity B looks alike from everywhere: its intensity is I = B / pi. So the eye may "
     "move, and nothing has "
     "to be solved again.",
     "depth test EQUAL, interpolated between the corners of patches", false},
};

inline constexpr StageInfo kStages[] = {
    {"patches", "The patches, coloured by why they were cut", StageKind::swatches, false},
    {"form-factors", "Form factors of one patch: what share of its light goes where", StageKind::scalar, false, true},
    {"matrix", "All form factors as a matrix, and its row sums", StageKind::swatches, false},
    {"row-sums", "Sum of each patch's form factors: 1 in a closed room", StageKind::scalar, false},
    {"surroundings", "Share of each patch's view in which there is no surface", StageKind::scalar, false},
    {"emission", "Emission: what shines by itself", StageKind::radiance, false},
    {"first-bounce", "Light that was reflected once", StageKind::radiance, false},
    {"bounce", "Light that was reflected as often as parameter bounce says", StageKind::radiance, false},
    {"reflected", "Light that was reflected more than once: what direct light alone leaves out", StageKind::radiance,
     false},
    {"residual", "Received and not yet sent on: how far the equations are from true", StageKind::scalar, false},
    {"radiosity", "Radiosity, one value for each patch", StageKind::radiance, false},
    {"interpolated", "Radiosity, interpolated between corners of patches", StageKind::radiance, false},
    {"visibility", "The share of a light that arrives, as the patches know it", StageKind::visibility, true},
};

} // namespace shadowlab::radiosity
