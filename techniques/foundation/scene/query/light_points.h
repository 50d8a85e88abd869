// Random sample points of an area light, one in each of its equal parts, and the parameters for them.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/model/light.h"

namespace shadowlab::scene {

struct LightPointParams {
    int count = 1;
    enum class Spread { jittered, random } spread = Spread::jittered;
    int seed = 0;
    friend bool operator==(const LightPointParams&, const LightPointParams&) = default;
};

/// The sample points, in world space; jittered: one in each of `count` parts of equal size. Deterministic for the same
/// parameters and number of the light. For a rect they lie on its surface. For a sphere they lie inside it, so that from
/// every direction they fill its disc evenly.
std::vector<dvec3> pointsOfLight(const Light& light, int lightNumber, const LightPointParams& params);

/// Name of the group of these parameters.
inline constexpr std::string_view kAreaLights = "Area lights";

/// How many (`unit`, and what that means in this technique: `help`), and how they are chosen.
params::ParamList describe(LightPointParams& points, std::string unit, std::string help);

} // namespace shadowlab::scene
