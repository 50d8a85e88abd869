// The steps of lecture/radiosity.cpp, as the lecture words them, and the pictures of what they find.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::lecture {

inline constexpr std::string_view kBasicRadiosityModel =
    "1. The object surfaces must form an enclosed space that has no energy exchange with outside world.\n"
    "2. Assume each surface is either a Lambertian reflector, a emitter, or a combination of both.\n"
    "3. Divide each surface into small surface polygons (surface patches) "
    "and calculate form factors.\n"
    "4. Solve radiosity equations: B_i - rho_i * sum over k of F_ik * B_k = E_i, "
    "i = 1, 2, 3, ..., n.";

inline constexpr PassInfo kRadiosityPasses[] = {
    {.id = "patches",
     .title = "Divide each surface into small surface patches",
     .why = "One radiosity stands for all of a patch, so a patch has to be small beside what it shows.",
     .glState = "depth test LESS, depth write on",
     .shownBy = "patches",
     .pseudocodeLines = {3, 3},
     .anchors = "lecture-patches lecture-place-of-patch"},
    {.id = "form-factors",
     .title = "Calculate form factors",
     .why = "F_jk is the fraction of the radiant energy from patch j that reaches patch k.",
     .glState = "nothing is drawn",
     .shownBy = "form-factors",
     .pseudocodeLines = {3, 3},
     .formula = "F_jk = 1 / A_j * sum over points of j and k of cos phi_j cos phi_k / (pi r^2) dA_j dA_k\n"
                "A_j F_jk = A_k F_kj",
     .anchors = "lecture-exchange lecture-form-factors"},
    {.id = "emission",
     .title = "Find the energy emission rates",
     .why = "E_i: what patch i emits itself, and what it reflects of lights that are no patches.",
     .glState = "depth test EQUAL, one value per patch",
     .pseudocodeLines = {1, 2},
     .formula = "E_i = pi * emission + rho_i * (irradiance by lights + (1 - sum over k of F_ik) * pi * background)",
     .anchors = "lecture-emission"},
    {.id = "gather",
     .title = "Solve the radiosity equations: each patch gathers from all others",
     .why = "Every repetition adds the light of one more reflection.",
     .glState = "depth test EQUAL, one value per patch",
     .pseudocodeLines = {4, 4},
     .formula = "B_i = E_i + rho_i * sum over k of F_ik * B_k\nI = B_i / pi",
     .anchors = "lecture-gather"},
};

inline constexpr StageInfo kRadiosityStages[] = {
    {"patches", "The patches, each in a colour of its own", StageKind::swatches, false},
    {"form-factors", "Form factors of the brightest patch: what share of its light goes where", StageKind::scalar,
     false},
    {"row-sums", "Sum of each patch's form factors: 1 in an enclosed space", StageKind::scalar, false},
    {"visibility", "The share of the patch that sees the light", StageKind::visibility, true},
};

} // namespace shadowlab::lecture
