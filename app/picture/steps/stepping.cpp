// SPDX-License-Identifier: MIT
#include "app/picture/steps/stepping.h"

#include <algorithm>

#include "app/picture/derived_stages.h"

namespace shadowlab::picture {

std::optional<std::size_t> stepOf(const StageRef& stage, const std::vector<StageKey>& passes, const scene::Scene& scene,
                                  int light) {
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const StageRef pass = refOf(passes[i], true, scene);
        if (pass == stage) return i;
        if (!stage.light && passes[i].light == light && pass.ofAnyLight() == stage) return i;
    }
    return {};
}

StageRef stepped(const StageRef& stage, const std::vector<StageKey>& passes, const scene::Scene& scene, int light, int by) {
    if (passes.empty()) return {};
    const auto count = static_cast<int>(passes.size());
    const std::optional<std::size_t> now = stepOf(stage, passes, scene, light);
    // The finished picture stands before the first pass and after the last.
    const int next = now ? static_cast<int>(*now) + by : by > 0 ? by - 1 : count + by;
    return next < 0 || next >= count ? StageRef() : refOf(passes[static_cast<std::size_t>(next)], true, scene);
}

ResolvedStage shownInStep(const ResolvedStage& stage, const TechniqueInfo& info, int light) {
    if (!stage.isPass) return stage;
    const std::string_view shownBy = passInfo(info.passes, stage.key.id).shownBy;
    if (shownBy.empty()) return stage;
    const bool perLight = stageInfo(info, shownBy).perLight;
    const int shown = !perLight ? kNoLight : stage.key.light != kNoLight ? stage.key.light : light;
    if (perLight && shown == kNoLight) return stage;
    return {{std::string(shownBy), shown}, false};
}

int stageLight(const scene::Scene& scene, int chosen) { return scene.lights.empty() ? kNoLight : std::max(chosen, 0); }

bool windowFollowsPicked(const TechniqueInfo& info, const StageRef& stage) {
    if (!stage.isPass) return followsPicked(info, stage.id);
    return std::ranges::any_of(info.passes, [&](const PassInfo& pass) {
        return pass.id == stage.id && followsPicked(info, pass.shownBy);
    });
}

} // namespace shadowlab::picture
