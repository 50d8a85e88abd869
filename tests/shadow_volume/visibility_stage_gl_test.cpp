// The stage `visibility` of shadow volumes, which is drawn from the count that the picture is then drawn from.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/context/assets.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using VisibilityStageTest = testing::GlTest;

struct Drawn {
    picture::RenderedFrame frame;
    std::vector<vec4> radiance;
    std::vector<float> visible;
    [[nodiscard]] std::ptrdiff_t passes(const std::string& id) const {
        return std::ranges::count(frame.result.passes, id, &StageKey::id);
    }
};

Drawn drawn(picture::Session& session, const View& view, const std::string& technique, std::vector<StageKey> stages) {
    picture::Slot slot = picture::Session::makeSlot(technique);
    FrameRequest request;
    request.stages = std::move(stages);
    Drawn result{session.render(slot, view, request), gl::readTexels(slot.target.color), {}};
    for (const Stage& stage : result.frame.result.stages)
        if (stage.key.id == kVisibilityStage)
            for (const vec4& texel : gl::readTexels(stage.texture))
                result.visible.push_back(texel.r);
    return result;
}

TEST_F(VisibilityStageTest, IsDrawnWithoutCountingAgainAndLeavesThePictureAsItIs) {
    int compared = 0;
    for (const char* name : {"three-lights", "still-life", "leafy"}) {
        const scene::Snapshot snapshot = scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        picture::Session session(snapshot);
        View view;
        view.camera = snapshot->camera;
        view.size = {240, 135};
        std::vector<StageKey> visibilities, all;
        for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light) {
            visibilities.push_back({std::string(kVisibilityStage), light});
            all.push_back(visibilities.back());
            all.push_back({"stencil", light}); // counts once more, and once more after it
        }
        for (const char* technique : {"shadow-volume", "shadow-volume-zpass", "shadow-volume-zfail"}) {
            const std::string where = std::string(name) + ", " + technique;
            const Drawn alone = drawn(session, view, technique, {}), judged = drawn(session, view, technique, visibilities),
                        counted = drawn(session, view, technique, all);
            EXPECT_EQ(judged.passes("clear-stencil"), std::ssize(snapshot->lights)) << where;
            EXPECT_EQ(judged.passes("clear-stencil"), alone.passes("clear-stencil")) << where;
            EXPECT_EQ(counted.passes("clear-stencil"), 3 * std::ssize(snapshot->lights)) << where;
            EXPECT_TRUE(judged.radiance == alone.radiance) << where;
            EXPECT_TRUE(counted.radiance == alone.radiance) << where;
            EXPECT_TRUE(judged.visible == counted.visible) << where;
            const auto lit = std::ranges::count(judged.visible, 1.0f);
            EXPECT_GT(lit, 5000) << where;
            EXPECT_LT(lit, std::ssize(judged.visible) - 500) << where;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 9);
}

} // namespace
} // namespace shadowlab
