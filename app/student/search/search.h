// The search for a scene in which a plug-in is wrong: random ones of its family's hard kinds are tried, and the first that fails is made as
// small as it can be.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/student/search/scene_trial.h"

namespace shadowlab::student {

struct SearchPlan {
    int scenes = 60;
    std::chrono::seconds time{60}; ///< of all of it: a quarter is kept for making the scene smaller
    std::uint64_t seed = 1;
};

/// What the plug-in's own stages show in the scene, beside those of the lecture's algorithm.
struct StageEvidence {
    std::string stage;
    bool isEmpty = false; ///< one colour everywhere, where the right one has several; else it only differs
};

struct Finding {
    int number = 0; ///< of the scene, counted from 0
    const SceneKind* kind = nullptr;
    SearchScene scene; ///< shrunk
    Trial trial;       ///< of that
    int attempts = 0;  ///< smaller scenes that were tried
    int trianglesBefore = 0;
    bool isFresh = true;            ///< a process that has drawn nothing before fails as well
    std::optional<StageEvidence> stage;
    int wrongAtDouble = 0, rightAtDouble = 0; ///< wrong pixels in a lesson's pictures, of 320 x 180: the plug-in's, and the right technique's
};

struct SearchResult {
    int tried = 0;  ///< scenes
    int unfair = 0; ///< of these, in which nothing could be asked
    bool isOutOfTime = false;
    std::optional<Finding> finding;
};

/// Ends with the first scene that fails, if it can be made as small as twelve triangles; else others are tried, and the smallest is found.
/// `done` is told how many scenes are through. Same plug-in, plan and program, same result, unless the time is over first.
SearchResult search(SceneTrials& trials, const SearchPlan& plan, const std::function<void(int)>& done);

} // namespace shadowlab::student
