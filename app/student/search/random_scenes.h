// Random scenes of what is hard for a family of techniques, each kind about one idea, as its cases are (grading/families.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "app/student/grading/families.h"
#include "app/student/search/dice.h"
#include "app/student/search/search_scene.h"

namespace shadowlab::student {

struct SceneKind {
    std::string_view idea; ///< what is hard in it: "a caster above the lamp"
    std::vector<int> blanks; ///< of the family's skeleton, counted from 1: those that it is about
    Judged judged = Judged::visibility;
    SearchScene (*make)(Dice& dice) = nullptr;
};

/// The kinds of a family, in the order in which they are tried.
std::span<const SceneKind> kindsOf(const Family& family);

/// The scene of that number, counted from 0: one kind after the other. Same seed, same scene, on every machine.
SearchScene randomScene(const Family& family, std::uint64_t seed, int number);
const SceneKind& kindOf(const Family& family, int number);

std::span<const SceneKind> planarKinds();
std::span<const SceneKind> shadowMapKinds();
std::span<const SceneKind> shadowVolumeKinds();
std::span<const SceneKind> rayTracingKinds();
std::span<const SceneKind> radiosityKinds();

} // namespace shadowlab::student
