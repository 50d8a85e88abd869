// SPDX-License-Identifier: MIT
#include "tests/shadow_volume/volume_case.h"

namespace shadowlab::testing {

bool VolumeCase::isRenderer(std::string_view name) {
    return std::string_view(reinterpret_cast<const char*>(glGetString(GL_RENDERER))).starts_with(name);
}

JudgedPicture VolumeCase::judged(const scene::Scene& scene, int light, ivec2 size) const {
    return {snapshot(scene), size, light, kTiePx};
}

void VolumeCase::expectExact(const JudgedPicture& picture, const Least& least) {
    for (const ExactWay& way : kExactWays) {
        SCOPED_TRACE(way.technique);
        const TruthComparison before = picture.compare(draw(picture, way, false));
        const TruthComparison after = picture.compare(draw(picture, way, true));
        EXPECT_GE(before.lit, least.lit);
        EXPECT_GE(before.shadowed, least.shadowed);
        EXPECT_LE(before.wrong(), kCrackShare * before.compared) << "before repair: " << before;
        EXPECT_EQ(after.wrong(), 0) << "after repair: " << after;
        EXPECT_LE(after.ties, after.compared / 100) << "edges everywhere: the test says little";
    }
}

void VolumeCase::expectExact(const scene::Scene& scene, const Least& least) const {
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        SCOPED_TRACE("light " + std::to_string(light));
        expectExact(judged(scene, light), least);
    }
}

picture::VisibilityImage VolumeCase::draw(const JudgedPicture& picture, const std::string& technique,
                                          std::vector<std::string> settings) {
    return renderVisibility(picture.snapshot(), technique, settings, picture.size(), picture.light());
}

picture::VisibilityImage VolumeCase::draw(const JudgedPicture& picture, const ExactWay& way, bool repair) {
    std::vector<std::string> settings = way.settings;
    settings.emplace_back(repair ? "repair=true" : "repair=false");
    return draw(picture, way.technique, settings);
}

} // namespace shadowlab::testing
