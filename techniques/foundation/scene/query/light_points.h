// Points of a light that has an area, chosen by chance in equal shares of it.
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

/// So many points in the world: jittered, one in each of as many parts of equal size. Always the same for the same parameters
/// and number of the light. Of a rectangle they are on its surface. Of a ball they lie within it, so that from every
/// direction they fill its disc evenly.
std::vector<dvec3> pointsOfLight(const Light& light, int lightNumber, const LightPointParams& params);

/// How many (`unit`, and what that means in this technique: `help`), and how they are chosen.
params::ParamList describe(LightPointParams& points, std::string unit, std::string help);

} // namespace shadowlab::scene
