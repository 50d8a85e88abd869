// Step mode: a technique's passes one by one, and the picture as it is after each.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/picture/session.h"

namespace shadowlab::picture {

/// A pass as a stage of `capture`: "pass:light@sun".
std::string passStage(const StageKey& pass, const scene::Scene& scene);

/// Where among the passes a stage stands; nothing when it is no pass, or none of these. A pass of one light that names
/// none is that of `light`.
std::optional<std::size_t> stepOf(const std::string& stage, const std::vector<StageKey>& passes,
                                  const scene::Scene& scene, int light);

/// The stage after `stage`, `by` passes on (or back, for less than zero). From the finished picture (an empty stage)
/// forward is the first pass; past the last pass, and before the first, is the finished picture again.
std::string stepped(const std::string& stage, const std::vector<StageKey>& passes, const scene::Scene& scene, int light,
                    int by);

/// What shows a pass in step mode: the picture after it, or the stage that shows what it wrote elsewhere. A stage of one
/// light is that of `light` (kNoLight: the scene has none, and no such stage), where the pass has none of its own.
StageChoice shownInStep(const StageChoice& pass, const TechniqueInfo& info, int light);

/// Is what the window shows of `STAGE` or `pass:ID`, with or without @LIGHT, about View::picked?
bool windowFollowsPicked(const TechniqueInfo& info, std::string_view stage);

} // namespace shadowlab::picture
