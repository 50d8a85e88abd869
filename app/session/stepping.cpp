// SPDX-License-Identifier: MIT
#include "app/session/stepping.h"

namespace shadowlab::session {

std::string passStage(const StageKey& pass, const scene::Scene& scene) {
    std::string stage = "pass:" + pass.id;
    if (pass.light != kNoLight) stage += "@" + scene.lights[static_cast<std::size_t>(pass.light)].name;
    return stage;
}

std::optional<std::size_t> stepOf(const std::string& stage, const std::vector<StageKey>& passes,
                                  const scene::Scene& scene) {
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (passStage(passes[i], scene) == stage) return i;
    return {};
}

std::string stepped(const std::string& stage, const std::vector<StageKey>& passes, const scene::Scene& scene, int by) {
    if (passes.empty()) return {};
    const auto count = static_cast<int>(passes.size());
    const std::optional<std::size_t> now = stepOf(stage, passes, scene);
    // The finished picture stands before the first pass and after the last.
    const int next = now ? static_cast<int>(*now) + by : by > 0 ? by - 1 : count + by;
    return next < 0 || next >= count ? std::string() : passStage(passes[static_cast<std::size_t>(next)], scene);
}

} // namespace shadowlab::session
