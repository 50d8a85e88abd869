// The knobs of a light that is sampled at points, the same in every technique that does so.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/query/light_points.h"

namespace shadowlab::scene {

/// How many (`unit`, and what that means in this technique: `help`), and how they are chosen.
params::ParamList describe(LightPointParams& points, std::string unit, std::string help);

} // namespace shadowlab::scene
