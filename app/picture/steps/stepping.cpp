// SPDX-License-Identifier: MIT
#include "app/picture/steps/stepping.h"

#include "app/picture/derived_stages.h"
#include "techniques/frame.h"

namespace shadowlab::picture {

std::string passStage(const StageKey& pass, const scene::Scene& scene) {
    std::string stage = "pass:" + pass.id;
    if (pass.light != kNoLight) stage += "@" + scene.light(pass.light).name;
    return stage;
}

std::optional<std::size_t> stepOf(const std::string& stage, const std::vector<StageKey>& passes,
                                  const scene::Scene& scene, int light) {
    const bool named = stage.find('@') != std::string::npos;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const std::string pass = passStage(passes[i], scene);
        if (pass == stage) return i;
        if (!named && passes[i].light == light && pass.starts_with(stage + "@")) return i;
    }
    return {};
}

std::string stepped(const std::string& stage, const std::vector<StageKey>& passes, const scene::Scene& scene, int light,
                    int by) {
    if (passes.empty()) return {};
    const auto count = static_cast<int>(passes.size());
    const std::optional<std::size_t> now = stepOf(stage, passes, scene, light);
    // The finished picture stands before the first pass and after the last.
    const int next = now ? static_cast<int>(*now) + by : by > 0 ? by - 1 : count + by;
    return next < 0 || next >= count ? std::string() : passStage(passes[static_cast<std::size_t>(next)], scene);
}

StageChoice shownInStep(const StageChoice& pass, const TechniqueInfo& info, int light) {
    const std::string_view stage = passInfo(info.passes, pass.key.id).shownBy;
    if (stage.empty()) return pass;
    const int shown = !stageInfo(info, stage).perLight ? kNoLight : pass.key.light != kNoLight ? pass.key.light : light;
    if (stageInfo(info, stage).perLight && shown == kNoLight) return pass;
    return {{std::string(stage), shown}, false};
}

bool windowFollowsPicked(const TechniqueInfo& info, std::string_view stage) {
    constexpr std::string_view kPass = "pass:";
    stage = stage.substr(0, stage.find('@'));
    if (!stage.starts_with(kPass)) return followsPicked(info, stage);
    return std::ranges::any_of(info.passes, [&](const PassInfo& pass) {
        return pass.id == stage.substr(kPass.size()) && followsPicked(info, pass.shownBy);
    });
}

} // namespace shadowlab::picture
