// The visibility of planar shadows compared with the exact judge, on the planes that receive, where it has to be exact.
// SPDX-License-Identifier: MIT
#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

/// Counts of pixels.
struct OnPlanes {
    int lit = 0, shadowed = 0, falseLit = 0, falseShadow = 0, ties = 0;
    int contacts =
        0; ///< would be false, but within the tie radius another surface touches or crosses the one that is seen
    int elsewhere = 0;         ///< on surfaces that receive nothing
    int elsewhereShadowed = 0; ///< those of them that face the light and were drawn dark all the same
    std::string firstWrong;    ///< the first wrong pixel, for the failure message
    [[nodiscard]] int compared() const { return lit + shadowed; }
    [[nodiscard]] int wrong() const { return falseLit + falseShadow; }
    OnPlanes& operator+=(const OnPlanes& other);
};
std::ostream& operator<<(std::ostream& stream, const OnPlanes& counts);

/// Floor, camera and light, and nothing that casts.
scene::Scene floorUnder(const dvec3& lightWorld);

scene::Object& addBox(scene::Scene& scene, const dvec3& size, const dvec3& middle);

inline constexpr ivec2 kPlanarSize{320, 240};

/// Draws the scene with settings "param=value" of `planar`. A pixel whose truth changes within the tie radius is a tie and not
/// wrong. `judged`: the scene whose truth it is held against, if another (to show what a mistaken program would draw).
OnPlanes onPlanes(const scene::Scene& scene, const std::vector<std::string>& settings = {}, int light = 0,
                  const scene::Scene* judged = nullptr);

/// Zero wrong pixels, of enough that are lit and in shadow.
void expectExactOnPlanes(const scene::Scene& scene, int least = 500, int light = 0);

} // namespace shadowlab::testing
