// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/light_point_params.h"

#include <utility>

namespace shadowlab::scene {

params::ParamList describe(LightPointParams& points, std::string unit, std::string help) {
    using params::onlyIf, params::integer, params::choice;
    const auto areMany = [&points] { return points.count > 1; };
    return {
        integer("light-samples", points.count, 1, 1024, std::move(unit), std::move(help)),
        onlyIf(areMany, choice("light-points", points.spread, {"jittered", "random"},
                               "Where they are: one by chance in each of as many equal parts; random: anywhere, which "
                               "takes far more of them (teaching).")),
        onlyIf(areMany,
               integer("light-seed", points.seed, 0, 1000000, "", "Another number, another choice by chance.")),
    };
}

} // namespace shadowlab::scene
