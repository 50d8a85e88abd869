// The judge beside the window against `measure` and the derived stages: the same scene, drawn the same way, has the same
// numbers to the last bit. And, when asked for, what the judge costs the one who draws.
// SPDX-License-Identifier: MIT
#include "app/lab/errors/background_judge.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>

#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/derived_stages.h"
#include "app/report/measurement.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab::lab {
namespace {

bool publishesTexelSize(const picture::Slot& slot) {
    return std::ranges::find(slot.info->stages, "texel-size", &StageInfo::id) != slot.info->stages.end();
}

class BackgroundJudgeTest : public testing::GlTest {
protected:
    static constexpr ivec2 kSize{320, 240};

    /// As the window would ask: each slot draws its region only, and reads back no more.
    static JudgeTask taskFor(picture::Session& session, std::vector<picture::Slot>& slots, const std::vector<Region>& regions,
                             const View& whole, bool exact) {
        JudgeTask task;
        task.snapshot = session.snapshot();
        task.view = whole;
        task.exact = exact;
        if (exact) task.rasterised = session.rasterise(whole);
        for (std::size_t i = 0; i < slots.size(); ++i) {
            View view = whole;
            view.region = regions[i];
            FrameRequest request;
            request.stages = {{"visibility", 0}};
            if (exact && publishesTexelSize(slots[i])) request.stages.push_back({"texel-size", 0});
            const picture::RenderedFrame rendered = session.render(slots[i], view, request);
            SlotTask& slot = task.slots.emplace_back();
            slot.visibility = picture::readVisibility(picture::findStage(rendered, {"visibility", 0}), view.region);
            slot.region = view.region;
            slot.wantsOverlay = true;
            slot.wantsCore = exact;
            if (exact && publishesTexelSize(slots[i]))
                slot.texelPx = picture::readTexelSizes(picture::findStage(rendered, {"texel-size", 0}));
        }
        return task;
    }
    static std::shared_ptr<const JudgeAnswer> whenDone(BackgroundJudge& judge) {
        while (judge.busy())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return judge.newest();
    }
    /// With a coarse map, so that there are errors to be found.
    static std::vector<picture::Slot> slotsOf(const std::vector<std::string>& ids) {
        std::vector<picture::Slot> slots;
        for (const std::string& id : ids)
            slots.push_back(picture::Session::makeSlot(id));
        applySettings(slots, {"shadow-map.resolution=128"});
        return slots;
    }
};

TEST_F(BackgroundJudgeTest, FindsWhatMeasureFinds) {
    BackgroundJudge judge;
    int wrong = 0;
    for (const auto& scene : {testing::simpleScene(), testing::hardScene(testing::HardClass::soup, 7, false),
                              testing::hardScene(testing::HardClass::torus, 3, true)}) {
        const auto snapshot = testing::snapshot(scene);
        picture::Session session(snapshot);
        std::vector<picture::Slot> slots = slotsOf({"shadow-map", "shadow-volume-zfail"});
        report::Measurement measurement(session, slots, 0, kSize);
        measurement.addFrame({snapshot, snapshot->camera});
        const std::vector<report::TechniqueErrors> measured = measurement.results();

        View view;
        view.camera = snapshot->camera;
        view.size = kSize;
        judge.submit(taskFor(session, slots, {{}, {}}, view, true));
        const auto answer = whenDone(judge);
        ASSERT_TRUE(answer && answer->exact);
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const judge::Counts &live = answer->slots[i]->judgement.counts, &counts = measured[i].counts;
            EXPECT_EQ(live.pixels, counts.pixels);
            EXPECT_EQ(live.lit, counts.lit);
            EXPECT_EQ(live.shadowed, counts.shadowed);
            EXPECT_EQ(live.turnedAway, counts.turnedAway);
            EXPECT_EQ(live.ties, counts.ties);
            EXPECT_EQ(live.falseLit, counts.falseLit);
            EXPECT_EQ(live.falseShadow, counts.falseShadow);
            EXPECT_EQ(live.rmse, counts.rmse);
            EXPECT_EQ(answer->slots[i]->edgeErrorPx, measured[i].edgeErrorPx);
            EXPECT_EQ(answer->slots[i]->coreErrors, measured[i].coreErrors);
            EXPECT_GT(counts.lit, 500);
            EXPECT_GT(counts.shadowed, 300);
            wrong += counts.wrong();
        }
    }
    EXPECT_GT(wrong, 100) << "shadow maps have edges";
}

TEST_F(BackgroundJudgeTest, HalvesOfASplitPictureAreThoseOfTheWhole) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    picture::Session session(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = kSize;
    std::vector<picture::Slot> slots = slotsOf({"shadow-map", "shadow-map", "shadow-map"});
    BackgroundJudge judge;
    judge.submit(taskFor(session, slots, {{}, {{0, 0}, {130, 240}}, {{130, 0}, {190, 240}}}, view, true));
    const auto answer = whenDone(judge);
    const auto counts = [&](std::size_t slot) { return answer->slots[slot]->judgement.counts; };
    using judge::Counts;
    for (const auto field : {&Counts::pixels, &Counts::lit, &Counts::shadowed, &Counts::turnedAway, &Counts::ties,
                             &Counts::falseLit, &Counts::falseShadow})
        EXPECT_EQ(counts(0).*field, counts(1).*field + counts(2).*field);
    EXPECT_EQ(*answer->slots[0]->coreErrors, *answer->slots[1]->coreErrors + *answer->slots[2]->coreErrors);
    EXPECT_GT(counts(1).wrong(), 3);
    EXPECT_GT(counts(2).wrong(), 3);
}

TEST_F(BackgroundJudgeTest, DrawsWhatTheDerivedStageShows) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    picture::Session session(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = kSize;
    std::vector<picture::Slot> slots = slotsOf({"shadow-map"});
    BackgroundJudge judge;
    JudgeTask task = taskFor(session, slots, {{}}, view, true);
    task.wantsTruthPanel = true;
    judge.submit(std::move(task));
    const auto answer = whenDone(judge);

    const picture::PictureEncoder encoder;
    FrameRequest request;
    request.stages = {{"visibility", 0}};
    const picture::RenderedFrame rendered = session.render(slots[0], view, request);
    const auto stage = [&](const char* id) {
        return picture::derivedPanel(session, slots[0], rendered, encoder, {{id, 0}, view, std::nullopt, nullptr});
    };
    EXPECT_EQ(answer->truthPanel->picture, stage("truth").picture);
    const image::Image base = encoder.encode(slots[0].target.color, snapshot->exposure);
    const picture::Panel errors = picture::errorPanel(base, *answer->truth, answer->slots[0]->judgement, {});
    EXPECT_EQ(errors.picture, stage("error").picture);
    int over = 0, otherwise = 0;
    const image::Image& overlay = answer->slots[0]->overlay->picture;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            if (overlay.at(x, y).a) ++over, otherwise += overlay.at(x, y) != errors.picture.at(x, y);
    EXPECT_GT(over, 50);
    EXPECT_EQ(otherwise, 0);
}

double elapsedMs(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// Median and worst, milliseconds.
std::string shown(std::vector<double> times) {
    if (times.empty()) return "none";
    std::ranges::sort(times);
    return std::to_string(times[times.size() / 2]) + " ms, worst of " + std::to_string(times.size()) + ": " +
           std::to_string(times.back()) + " ms";
}

// What does the judge cost the picture? A split frame, 1280 x 720, as in the window: drawn alone, beside a reduced task,
// beside an exact one, and with its visibility drawn and read back; turn by turn, so that whatever else the machine does
// meets all alike. SHADOWLAB_LONG=1 runs it, SHADOWLAB_RATE_SCENE names the scene.
TEST_F(BackgroundJudgeTest, CostsTheFrameLittle) {
    if (!std::getenv("SHADOWLAB_LONG")) GTEST_SKIP() << "a measurement; set SHADOWLAB_LONG=1";
    const char* const given = std::getenv("SHADOWLAB_RATE_SCENE");
    const scene::Snapshot snapshot =
        scene::loadScene(given ? given : "colonnade", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    picture::Session session(snapshot);
    View whole;
    whole.camera = snapshot->camera;
    whole.size = {1280, 720};
    const std::vector<Region> regions = {{{0, 0}, {640, 720}}, {{640, 0}, {640, 720}}};
    std::vector<picture::Slot> slots;
    for (const char* id : {"shadow-map", "shadow-volume-zfail"})
        slots.push_back(picture::Session::makeSlot(id));
    JudgeTask reduced = taskFor(session, slots, regions, whole, false);
    JudgeTask exact = taskFor(session, slots, regions, whole, true);
    BackgroundJudge judge;
    std::vector<double> submitting, stopping;
    const auto submit = [&](JudgeTask& task) { // another camera each time, or the truth would be known
        task.view.camera.positionWorld.x += 1e-3;
        submitting.push_back(elapsedMs([&] { judge.submit(task); }));
    };
    const auto stop = [&] {
        judge.forget();
        while (judge.busy())
            std::this_thread::sleep_for(std::chrono::microseconds(100));
    };
    const auto drawFrame = [&] {
        return elapsedMs([&] {
            for (std::size_t i = 0; i < slots.size(); ++i) {
                View view = whole;
                view.region = regions[i];
                session.render(slots[i], view);
            }
        });
    };

    std::vector<double> alone, besideReduced, besideExact, withVisibility;
    for (int round = 0; round < 41; ++round) {
        alone.push_back(drawFrame());
        submit(reduced);
        besideReduced.push_back(drawFrame());
        submit(exact);
        besideExact.push_back(drawFrame());
        stopping.push_back(elapsedMs(stop));
        withVisibility.push_back(elapsedMs([&] { taskFor(session, slots, regions, whole, false); }));
    }
    std::vector<double> answered;
    std::uint64_t newest = 0;
    const double movingMs = elapsedMs([&] {
        for (int frame = 0; frame < 60; ++frame) {
            submit(reduced);
            const auto answer = judge.newest();
            if (answer && answer->number > newest) newest = answer->number, answered.push_back(answer->ms);
            drawFrame();
        }
    });
    stop();
    submit(exact);
    const auto atRest = whenDone(judge);
    std::cout << "frame alone            " << shown(alone) << "\nbeside a reduced task  " << shown(besideReduced)
              << "\nbeside an exact task   " << shown(besideExact) << "\nwith visibility read   "
              << shown(withVisibility) << "\nwhile moving           "
              << 1000 * static_cast<double>(answered.size()) / movingMs << " answers a second, each " << shown(answered)
              << "\nsubmit                 " << shown(submitting) << "\nstop an exact task     " << shown(stopping)
              << "\nexact answer at rest   " << atRest->ms << " ms\n";
}

} // namespace
} // namespace shadowlab::lab
