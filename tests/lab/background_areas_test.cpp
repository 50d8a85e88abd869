// The judge beside the window, where techniques answer to a light's area: each is held against its own truth, and what takes long
// keeps nobody waiting.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "app/lab/errors/background_judge.h"
#include "tests/support/area_lights.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab::lab {
namespace {

using judge::TruthOf;
using Answer = std::shared_ptr<const JudgeAnswer>;

constexpr ivec2 kSize{162, 121};
constexpr judge::Rasterised kRasterised{1.0 / 64, {}};

/// Loose triangles under one panel.
scene::Snapshot panelScene() {
    scene::Scene scene = testing::hardScene(testing::HardClass::soup, 5, false);
    scene.lights = {testing::rectLight(scene.lights[0].positionWorld, {0.9, 0.1, 0.2}, {-0.2, 0.1, 0.7})};
    return testing::snapshot(std::move(scene));
}

judge::Truth truthOf(const scene::Snapshot& snapshot, bool exact, TruthOf of) {
    const trace::SceneTracer tracer = testing::tracerOf(snapshot);
    return exact ? judge::exactTruth(tracer, snapshot->camera, kSize, 0, kRasterised, {}, of)
                 : judge::truthAtCentres(tracer, snapshot->camera, kSize, 0, {}, of);
}

/// One slot for each truth, of a technique that says everything is lit.
JudgeTask taskFor(const scene::Snapshot& snapshot, bool exact, const std::vector<TruthOf>& truths) {
    JudgeTask task;
    task.snapshot = snapshot;
    task.view.camera = snapshot->camera;
    task.view.size = kSize;
    task.exact = exact;
    task.rasterised = kRasterised;
    task.wantsTruthPanel = true;
    const auto bytes = 2 * static_cast<std::size_t>(kSize.x) * kSize.y;
    for (const TruthOf truth : truths)
        task.slots.push_back(
            {.visibility = {kSize.x, kSize.y, std::vector<std::uint8_t>(bytes, 255)}, .region = {}, .truth = truth});
    return task;
}

void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

Answer whenDone(BackgroundJudge& judge) {
    while (judge.busy())
        rest();
    return judge.newest();
}

TEST(BackgroundAreas, EachSlotIsHeldAgainstTheTruthItAnswersTo) {
    const scene::Snapshot snapshot = panelScene();
    for (const bool exact : {false, true}) {
        const judge::Truth area = truthOf(snapshot, exact, TruthOf::area);
        JudgeTask task = taskFor(snapshot, exact, {TruthOf::centre, TruthOf::area});
        const judge::Counts expected = judge::judge(area, task.slots[1].visibility.greyAlpha).counts;
        BackgroundJudge judge;
        judge.submit(std::move(task));
        // What is known of the centre comes first; of the area nothing is said before all of it is known.
        int early = 0;
        while (judge.busy()) {
            const Answer answer = judge.newest();
            if (answer && !answer->slots[1]) {
                ++early;
                EXPECT_TRUE(answer->slots[0]);
                EXPECT_FALSE(answer->exact);
            }
            rest();
        }
        EXPECT_GT(early, 0) << "most of the time is spent on the area";
        const Answer answer = judge.newest();
        ASSERT_TRUE(answer->slots[0] && answer->slots[1]);
        EXPECT_EQ(answer->exact, exact);
        EXPECT_EQ(answer->slots[0]->truth->visibility, truthOf(snapshot, exact, TruthOf::centre).visibility);
        EXPECT_TRUE(answer->slots[0]->truth->shares.empty());
        EXPECT_EQ(answer->slots[1]->truth->shares, area.shares);
        EXPECT_EQ(answer->slots[1]->truth->ties, area.ties);
        EXPECT_EQ(answer->slots[1]->truthPanel->picture, picture::truthPanel(area, {}).picture);
        EXPECT_NE(answer->slots[0]->truthPanel->picture, answer->slots[1]->truthPanel->picture);
        const judge::Counts &found = answer->slots[1]->judgement.counts,
                              &ofCentre = answer->slots[0]->judgement.counts;
        EXPECT_EQ(found.lit, expected.lit);
        EXPECT_EQ(found.falseLit, expected.falseLit);
        EXPECT_EQ(found.ties, expected.ties);
        EXPECT_EQ(found.rmse, expected.rmse);
        EXPECT_GT(found.lit, 1000);
        EXPECT_GT(found.falseLit, 500);
        EXPECT_NE(ofCentre.lit, found.lit);
        EXPECT_GT(ofCentre.rmse, found.rmse) << "some of the light is seen where its centre is not";
    }
}

TEST(BackgroundAreas, OnlyTheAreaIsAskedWhereNobodyAnswersToTheCentre) {
    const scene::Snapshot snapshot = panelScene();
    BackgroundJudge judge;
    judge.submit(taskFor(snapshot, true, {TruthOf::area}));
    const Answer answer = whenDone(judge);
    ASSERT_TRUE(answer && answer->slots[0]);
    EXPECT_TRUE(answer->exact);
    EXPECT_FALSE(answer->truth->shares.empty());
    // The same truth serves the next task, which is no exact one.
    judge.submit(taskFor(snapshot, false, {TruthOf::area}));
    const Answer second = whenDone(judge);
    EXPECT_EQ(second->truth, answer->truth);
    EXPECT_TRUE(second->exact);
}

TEST(BackgroundAreas, WorkOnAnAreaIsDroppedForTheNextTask) {
    const scene::Snapshot snapshot = panelScene();
    BackgroundJudge judge;
    for (const int ms : {0, 50}) {
        JudgeTask task = taskFor(snapshot, true, {TruthOf::area});
        task.slots[0].visibility.greyAlpha.clear();
        task.view.size = ivec2(4096); // minutes
        judge.submit(std::move(task));
        for (int i = 0; i < ms; ++i)
            rest();
        const std::uint64_t next = judge.submit(taskFor(snapshot, true, {TruthOf::centre}));
        const Answer answer = whenDone(judge);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->number, next);
        EXPECT_TRUE(answer->exact);
    }
}

} // namespace
} // namespace shadowlab::lab
