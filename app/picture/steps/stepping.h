// Step mode: a technique's passes one by one, and the picture as it is after each.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/picture/stage_ref.h"

namespace shadowlab::picture {

/// Where among the passes a stage stands; nothing when it is no pass, or none of these. A pass of one light that names
/// none is that of `light`.
std::optional<std::size_t> stepOf(const StageRef& stage, const std::vector<StageKey>& passes,
                                  const scene::Scene& scene, int light);

/// The stage after `stage`, `by` passes on (or back, for less than zero). From the finished picture forward is the first pass;
/// past the last pass, and before the first, is the finished picture again.
StageRef stepped(const StageRef& stage, const std::vector<StageKey>& passes, const scene::Scene& scene, int light, int by);

/// What shows a pass in step mode: the picture after it, or the stage that shows what it wrote elsewhere. A stage of one
/// light is that of `light` (kNoLight: the scene has none, and no such stage), where the pass has none of its own. What is no
/// pass is shown as it is.
ResolvedStage shownInStep(const ResolvedStage& stage, const TechniqueInfo& info, int light);

/// The light that stages of one light are about: the first where none is chosen (kNoLight), none where the scene has none.
int stageLight(const scene::Scene& scene, int chosen);

/// Is what the window shows of that stage or pass about View::picked?
bool windowFollowsPicked(const TechniqueInfo& info, const StageRef& stage);

} // namespace shadowlab::picture
