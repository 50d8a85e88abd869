// SPDX-License-Identifier: MIT
#include "app/picture/stage_ref.h"

#include <vector>

#include "app/picture/derived_stages.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::picture {

namespace {

constexpr std::string_view kPass = "pass:";
constexpr char kBeforeLight = '@';

} // namespace

StageRef StageRef::parse(std::string_view text) {
    if (text.starts_with(kPass)) return parsePass(text.substr(kPass.size()));
    StageRef stage = parsePass(text);
    stage.isPass = false;
    return stage;
}

StageRef StageRef::parsePass(std::string_view idAndLight) {
    const std::size_t at = idAndLight.find(kBeforeLight);
    StageRef pass{std::string(idAndLight.substr(0, at)), {}, true};
    if (at != std::string_view::npos) pass.light = idAndLight.substr(at + 1);
    return pass;
}

std::string StageRef::text() const { return (isPass ? std::string(kPass) : "") + idAndLight(); }

std::string StageRef::idAndLight() const { return light ? id + kBeforeLight + *light : id; }

bool StageRef::isVisibility() const { return !isPass && id == kVisibilityStage; }
bool StageRef::isDerived() const { return !isPass && picture::isDerived(id); }
bool StageRef::isJudged() const { return isTruth() || isError() || isScanline(); }
bool StageRef::isTruth() const { return !isPass && id == "truth"; }
bool StageRef::isError() const { return !isPass && id == "error"; }
bool StageRef::isScanline() const { return !isPass && id == "scanline"; }
bool StageRef::isShadowOutline() const { return !isPass && id == "shadow-outline"; }
bool StageRef::isOutside() const { return !isPass && id == "outside"; }

ResolvedStage resolve(const StageRef& stage, const TechniqueInfo& info, const scene::Scene& scene, int defaultLight) {
    if (stage.isPicture()) return {};
    const int light = stage.light ? lightIndex(scene, *stage.light) : defaultLight;
    std::vector<std::string> known;
    std::optional<bool> perLight;
    for (const PassInfo& pass : info.passes) {
        known.push_back(StageRef{std::string(pass.id), {}, true}.text());
        if (stage.isPass && pass.id == stage.id) perLight = pass.perLight;
    }
    for (const StageInfo& one : stagesOf(info)) {
        known.emplace_back(one.id);
        if (!stage.isPass && one.id == stage.id) perLight = one.perLight;
    }
    if (!perLight)
        throw Error(ExitStatus::usage, "'" + std::string(info.id) + "' has no stage '" + stage.text() + "'; " +
                                           suggestion(stage.ofAnyLight().text(), known));
    if (!*perLight) {
        if (stage.light)
            throw Error(ExitStatus::usage, "stage '" + stage.id + "' of '" + std::string(info.id) +
                                               "' does not belong to one light; leave out '" + kBeforeLight +
                                               *stage.light + "'");
        return {{stage.id, kNoLight}, stage.isPass};
    }
    if (scene.lights.empty())
        throw Error(ExitStatus::usage, "stage '" + stage.id + "' needs a light and scene '" + scene.name +
                                           "' has none; choose another stage or scene");
    return {{stage.id, light == kNoLight ? 0 : light}, stage.isPass};
}

StageRef refOf(const StageKey& key, bool isPass, const scene::Scene& scene) {
    StageRef stage{key.id, {}, isPass};
    if (key.light != kNoLight) stage.light = scene.light(key.light).name;
    return stage;
}

StageKey visibilityOf(int light) { return {std::string(kVisibilityStage), light}; }

} // namespace shadowlab::picture
