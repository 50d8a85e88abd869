// The stages that the session makes: truth, error, scanline. Their colours must be where the truth says.
// SPDX-License-Identifier: MIT
#include "app/picture/derived_stages.h"

#include "app/judge/verdict.h"
#include "app/lab/settings.h"
#include "app/picture/stages/scanline_plot.h"
#include "techniques/foundation/base/look.h"
#include "tests/support/area_lights.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab::picture {
namespace {

constexpr ivec2 kSize{320, 240};

image::Color8 encoded(const vec3& linear) {
    return {image::srgbFromLinear(linear.r), image::srgbFromLinear(linear.g), image::srgbFromLinear(linear.b), 255};
}

class DerivedStagesTest : public testing::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        slots.push_back(Session::makeSlot("shadow-map"));
        lab::applySettings(slots, {"shadow-map.resolution=64"});
        session = std::make_unique<Session>(testing::snapshot(testing::simpleScene()));
        view.camera = session->snapshot()->camera;
        view.size = kSize;
    }
    void TearDown() override {
        slots.clear();
        session.reset();
        GlTest::TearDown();
    }
    Panel panel(const std::string& stage, std::optional<int> row = {}) {
        const StageKey key{stage, 0};
        FrameRequest request;
        request.stages = neededFor(key);
        const RenderedFrame rendered = session->render(slots[0], view, request);
        return derivedPanel(*session, slots[0], rendered, PictureEncoder(), {key, view, row, nullptr});
    }
    judge::Judgement judgement() {
        FrameRequest request;
        request.stages = {{"visibility", 0}};
        const RenderedFrame rendered = session->render(slots[0], view, request);
        return judge::judge(session->truth(view, 0),
                              readVisibility(findStage(rendered, {"visibility", 0})).greyAlpha);
    }
    /// Pixels of a colour, within the view.
    static int count(const image::Image& picture, const image::Color8& color) {
        int found = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                found += picture.at(x, y) == color;
        return found;
    }
    std::vector<Slot> slots;
    std::unique_ptr<Session> session;
    View view;
};

TEST_F(DerivedStagesTest, ErrorPaintsEveryWrongPixelAndOnlyThose) {
    const judge::Judgement judged = judgement();
    ASSERT_GT(judged.counts.falseLit, 20);
    ASSERT_GT(judged.counts.falseShadow, 20);
    const Panel error = panel("error");
    int wrong = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const image::Color8 color = error.picture.at(x, y);
            const auto verdict = judged.verdicts[static_cast<std::size_t>(y * kSize.x + x)];
            ASSERT_EQ(color == encoded(look::kFalseLit), verdict == judge::Verdict::falseLit);
            ASSERT_EQ(color == encoded(look::kFalseShadow), verdict == judge::Verdict::falseShadow);
            wrong += verdict == judge::Verdict::falseLit || verdict == judge::Verdict::falseShadow;
            if (verdict == judge::Verdict::correct) {
                ASSERT_TRUE(color.r == color.g && color.g == color.b);
            }
        }
    EXPECT_EQ(wrong, judged.counts.wrong());
    EXPECT_NE(error.display.key[0].label.find(std::to_string(judged.counts.falseLit)), std::string::npos);
    EXPECT_NE(error.display.key[1].label.find(std::to_string(judged.counts.falseShadow)), std::string::npos);
}

TEST_F(DerivedStagesTest, TruthPaintsWhatIsLit) {
    const Panel truth = panel("truth");
    const judge::Truth& exact = session->truth(view, 0);
    int lit = 0, rims = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const std::size_t i = exact.index(x, y);
            if (exact.visibility[i] != trace::Visibility::lit || exact.ties[i]) continue;
            const bool isLit = truth.picture.at(x, y) == encoded(look::kLit);
            lit += isLit;
            rims += !isLit; // on outlines of objects
        }
    EXPECT_GT(lit, 10'000);
    EXPECT_LT(rims, lit / 20);
    EXPECT_GT(count(truth.picture, encoded(look::kShadowed)), 500);
    EXPECT_GT(count(truth.picture, encoded(look::kTurnedAway)), 200);
}

// The stage follows the technique: with many points of a panel, half-shadows between lit and in shadow.
TEST_F(DerivedStagesTest, TruthOfAnAreaHasPenumbras) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5})};
    session->setScene(testing::snapshot(std::move(scene)));
    const auto between = [&] {
        const image::Image picture = panel("truth").picture;
        const int known = count(picture, encoded(look::kLit)) + count(picture, encoded(look::kShadowed)) +
                          count(picture, encoded(look::kTurnedAway)) + count(picture, encoded(look::kNoSurface)) +
                          count(picture, encoded(look::kTie));
        return picture.width * picture.height - known; // and darker rims
    };
    const int sharp = between();
    lab::applySettings(slots, {"shadow-map.light-samples=4"});
    EXPECT_GT(between(), sharp + 1000);
    EXPECT_NE(panel("truth").display.key[0].label.find("more than half"), std::string::npos);
    int shares = 0;
    for (const float share : session->truth(view, session->truthFor(slots[0], 0)).shares)
        shares += share > 0 && share < 1;
    EXPECT_GT(shares, 1000);
}

TEST_F(DerivedStagesTest, OnlyTheRegionIsCounted) {
    const judge::Judgement all = judgement();
    view.region = {{kSize.x / 2, 0}, {kSize.x / 2, kSize.y}};
    int falseLit = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = kSize.x / 2; x < kSize.x; ++x)
            falseLit += all.verdicts[static_cast<std::size_t>(y * kSize.x + x)] == judge::Verdict::falseLit;
    const Panel error = panel("error");
    EXPECT_NE(error.display.key[0].label.find(": " + std::to_string(falseLit) + " px"), std::string::npos)
        << error.display.key[0].label;
}

TEST_F(DerivedStagesTest, ScanlineMarksItsRowAndTheWrongColumns) {
    const judge::Judgement judged = judgement();
    const judge::Truth truth = session->truth(view, 0);
    FrameRequest request;
    request.stages = {{"visibility", 0}};
    const RenderedFrame rendered = session->render(slots[0], view, request);
    const VisibilityImage visibility = readVisibility(findStage(rendered, {"visibility", 0}));
    const int row = mostTellingRow({truth, judged, visibility, "key", "map"}, {});
    int wrong = 0, most = 0;
    for (int y = 0; y < kSize.y; ++y) {
        int inRow = 0;
        for (int x = 0; x < kSize.x; ++x)
            inRow += judged.verdicts[static_cast<std::size_t>(y * kSize.x + x)] == judge::Verdict::falseLit ||
                     judged.verdicts[static_cast<std::size_t>(y * kSize.x + x)] == judge::Verdict::falseShadow;
        most = std::max(most, inRow);
        if (y == row) wrong = inRow;
    }
    ASSERT_GT(wrong, 0);
    EXPECT_EQ(wrong, most) << "row " << row;

    const Panel plot = panel("scanline");
    // Every false column is painted over the height of the plot, less the lines that cross it.
    for (int x = 0; x < kSize.x; ++x) {
        const auto verdict = judged.verdicts[static_cast<std::size_t>(row * kSize.x + x)];
        const image::Color8 color =
            encoded(verdict == judge::Verdict::falseLit ? look::kFalseLit : look::kFalseShadow);
        int painted = 0;
        for (int y = 0; y < kSize.y; ++y)
            painted += plot.picture.at(x, y) == color;
        const bool isWrong = verdict == judge::Verdict::falseLit || verdict == judge::Verdict::falseShadow;
        EXPECT_TRUE(!isWrong || painted > kSize.y / 8) << x;
    }
    EXPECT_FALSE(panel("scanline", 10).picture == plot.picture);
}

TEST(DerivedStages, BelongToTechniquesThatPublishVisibility) {
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const std::vector<StageInfo> stages = stagesOf(*technique.info);
        const auto has = [&](std::string_view id) { return std::ranges::count(stages, id, &StageInfo::id); };
        EXPECT_EQ(has("truth"), has("visibility")) << technique.info->id;
        EXPECT_EQ(has("error"), has("visibility"));
        EXPECT_EQ(has("scanline"), has("visibility"));
        EXPECT_EQ(has("shadow-outline"), 1);
        EXPECT_EQ(has("mesh-edges"), 1);
        EXPECT_EQ(has("outside"), 1);
        for (const StageInfo& own : technique.info->stages)
            EXPECT_FALSE(isDerived(own.id)) << technique.info->id << " takes a reserved id: " << own.id;
    }
}

} // namespace
} // namespace shadowlab::picture
