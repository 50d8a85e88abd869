// The judge beside the window: right numbers, no answer that comes too late, an end that does not wait.
//
// A technique is stood in for by the truth with some pixels turned over. Nothing is timed: where work is to be dropped,
// it is so much that a judge who went on with it would make these tests take minutes.
// SPDX-License-Identifier: MIT
#include "app/lab/errors/background_judge.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab::lab {
namespace {

using judge::Counts;
using trace::Visibility;
using Answer = std::shared_ptr<const JudgeAnswer>;

constexpr ivec2 kSize{162, 121};
constexpr Region kLeft{{0, 0}, {70, 121}}, kRight{{70, 0}, {92, 121}};
constexpr judge::Rasterised kRasterised{1.0 / 64, {}};

/// The truth of the scene's own camera.
judge::Truth truthOf(const scene::Snapshot& snapshot, bool exact) {
    trace::SceneTracer tracer;
    tracer.advance(snapshot, Deadline::max());
    return exact ? judge::exactTruth(tracer, snapshot->camera, kSize, 0, kRasterised)
                 : judge::truthAtCentres(tracer, snapshot->camera, kSize, 0);
}

/// The truth, with each seventh pixel of it turned over.
picture::VisibilityImage turnedOver(const judge::Truth& truth, const Region& region = {}) {
    const auto [corner, size] = judge::shownPart(region, truth.size);
    picture::VisibilityImage image{size.x, size.y, {}};
    for (int y = corner.y; y < corner.y + size.y; ++y)
        for (int x = corner.x; x < corner.x + size.x; ++x) {
            const Visibility exact = truth.visibility[truth.index(x, y)];
            const bool lit = (exact == Visibility::lit) != ((x + 3 * y) % 7 == 0);
            const bool covered = exact != Visibility::noSurface;
            image.greyAlpha.push_back(covered && lit ? 255 : 0);
            image.greyAlpha.push_back(covered ? 255 : 0);
        }
    return image;
}

JudgeTask taskFor(const scene::Snapshot& snapshot, bool exact, const std::vector<Region>& regions = {{}}) {
    JudgeTask task;
    task.snapshot = snapshot;
    task.view.camera = snapshot->camera;
    task.view.size = kSize;
    task.exact = exact;
    task.rasterised = kRasterised;
    const judge::Truth truth = truthOf(snapshot, false);
    for (const Region& region : regions)
        task.slots.push_back({.visibility = turnedOver(truth, region), .region = region});
    return task;
}

/// An exact task with nothing to judge; of 2048 pixels a side it takes many seconds.
JudgeTask large(const scene::Snapshot& snapshot, int side = 2048) {
    JudgeTask task;
    task.snapshot = snapshot;
    task.view.camera = snapshot->camera;
    task.view.size = ivec2(side);
    task.exact = true;
    task.rasterised = kRasterised;
    return task;
}

scene::Snapshot someScene(unsigned number = 5) {
    return testing::snapshot(testing::hardScene(testing::HardClass::soup, number, false));
}

void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

Answer whenDone(BackgroundJudge& judge) {
    while (judge.busy())
        rest();
    return judge.newest();
}

void expectEqual(const Counts& a, const Counts& b) {
    EXPECT_EQ(a.pixels, b.pixels);
    EXPECT_EQ(a.lit, b.lit);
    EXPECT_EQ(a.shadowed, b.shadowed);
    EXPECT_EQ(a.turnedAway, b.turnedAway);
    EXPECT_EQ(a.ties, b.ties);
    EXPECT_EQ(a.falseLit, b.falseLit);
    EXPECT_EQ(a.falseShadow, b.falseShadow);
    EXPECT_EQ(a.stray, b.stray);
    EXPECT_EQ(a.rmse, b.rmse);
}

TEST(BackgroundJudge, FindsWhatMeasuringFinds) {
    BackgroundJudge judge;
    for (const unsigned number : {5U, 6U})
        for (const bool exact : {false, true}) {
            const scene::Snapshot snapshot = someScene(number);
            JudgeTask task = taskFor(snapshot, exact);
            task.slots[0].wantsCore = true;
            const judge::Truth truth = truthOf(snapshot, exact);
            const auto boundary = judge::trueBoundary(truth);
            const judge::SlotErrors expected =
                judge::slotErrors(truth, boundary, task.slots[0].visibility.greyAlpha);
            const int core = judge::coreErrors(truth, expected.judgement,
                                                 judge::distanceToBoundary(boundary, kSize), std::nullopt);
            const std::uint64_t asked = judge.submit(std::move(task));
            const Answer answer = whenDone(judge);
            ASSERT_TRUE(answer);
            EXPECT_EQ(answer->number, asked);
            EXPECT_EQ(answer->exact, exact);
            EXPECT_EQ(answer->truth->visibility, truth.visibility);
            EXPECT_EQ(answer->truth->ties, truth.ties);
            const SlotAnswer& slot = answer->slots.at(0).value();
            expectEqual(slot.judgement.counts, expected.judgement.counts);
            EXPECT_EQ(slot.judgement.verdicts, expected.judgement.verdicts);
            EXPECT_EQ(slot.edgeErrorPx.value(), expected.edgeErrorPx.value());
            EXPECT_EQ(slot.coreErrors, exact ? std::optional(core) : std::nullopt);
            EXPECT_GT(core, 100);
            EXPECT_GT(slot.judgement.counts.lit, 1000);
            EXPECT_GT(slot.judgement.counts.shadowed, 1000);
            EXPECT_GT(slot.judgement.counts.falseLit, 100);
            EXPECT_GT(slot.judgement.counts.falseShadow, 100);
            EXPECT_EQ(slot.judgement.counts.ties > 0, exact);
        }
}

TEST(BackgroundJudge, TwoHalvesAddUpToTheWhole) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    judge.submit(taskFor(snapshot, true, {{}, kLeft, kRight}));
    const Answer answer = whenDone(judge);
    ASSERT_EQ(answer->slots.size(), 3U);
    const auto counts = [&](std::size_t slot) { return answer->slots[slot]->judgement.counts; };
    const Counts whole = counts(0);
    for (const auto field : {&Counts::pixels, &Counts::lit, &Counts::shadowed, &Counts::turnedAway, &Counts::ties,
                             &Counts::falseLit, &Counts::falseShadow})
        EXPECT_EQ(whole.*field, counts(1).*field + counts(2).*field);
    const auto boundary = judge::trueBoundary(*answer->truth);
    const double left = judge::lengthPx(boundary, kLeft, kSize), right = judge::lengthPx(boundary, kRight, kSize);
    EXPECT_GT(left, 50);
    EXPECT_GT(right, 50);
    EXPECT_DOUBLE_EQ(left + right, judge::lengthPx(boundary));
    EXPECT_DOUBLE_EQ(*answer->slots[1]->edgeErrorPx, counts(1).wrong() / left);
    EXPECT_GT(counts(1).wrong(), 100);
    EXPECT_GT(counts(2).wrong(), 100);
    int judgedOutside = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 70; x < kSize.x; ++x)
            judgedOutside +=
                answer->slots[1]->judgement.verdicts[answer->truth->index(x, y)] != judge::Verdict::background;
    EXPECT_EQ(judgedOutside, 0);
}

TEST(BackgroundJudge, ASlotWithoutVisibilityIsNotJudged) {
    BackgroundJudge judge;
    JudgeTask task = taskFor(someScene(), false);
    task.slots.insert(task.slots.begin(), SlotTask{});
    task.slots[1].wantsOverlay = true;
    task.wantsTruthPanel = true;
    judge.submit(std::move(task));
    const Answer answer = whenDone(judge);
    EXPECT_FALSE(answer->slots.at(0));
    ASSERT_TRUE(answer->slots.at(1));
    EXPECT_EQ(answer->truthPanel->picture, picture::truthPanel(*answer->truth, {}).picture);
    const image::Image& overlay = answer->slots[1]->overlay->picture;
    int painted = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            painted += overlay.at(x, y).a == 255;
    EXPECT_EQ(painted, answer->slots[1]->judgement.counts.wrong());
    EXPECT_GT(painted, 500);
}

TEST(BackgroundJudge, AnExactTaskAnswersTwice) {
    BackgroundJudge judge;
    const std::uint64_t asked = judge.submit(large(someScene(), 640));
    Answer answer;
    while (!(answer = judge.newest()))
        rest();
    EXPECT_EQ(answer->number, asked);
    EXPECT_FALSE(answer->exact) << "sixteen seventeenths of the work are still to be done";
    answer = whenDone(judge);
    EXPECT_EQ(answer->number, asked);
    EXPECT_TRUE(answer->exact);
}

TEST(BackgroundJudge, AnExactTaskIsDroppedForTheNext) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    for (const bool exact : {true, false}) {
        judge.submit(large(snapshot));
        for (int i = 0; i < 20; ++i)
            rest(); // so that it has begun, most likely; all holds if it has not
        JudgeTask task = taskFor(snapshot, exact);
        task.view.camera.positionWorld.x += exact ? 0.0 : 0.01;
        const std::uint64_t next = judge.submit(std::move(task));
        const Answer answer = whenDone(judge);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->number, next);
        EXPECT_EQ(answer->exact, exact);
    }
}

TEST(BackgroundJudge, WhatIsDroppedIsNotFinished) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    JudgeTask task = large(snapshot, 1024);
    judge.submit(task);
    for (int i = 0; i < 5; ++i)
        rest();
    judge.forget();
    EXPECT_FALSE(whenDone(judge));
    task.exact = false;
    judge.submit(std::move(task));
    EXPECT_FALSE(whenDone(judge)->exact) << "the exact truth of this view would be at hand if it had been finished";
}

TEST(BackgroundJudge, AnAnswerThatNobodyFetchedIsTooLateForTheNextExactTask) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    const auto finishUnseen = [&] {
        judge.submit(taskFor(snapshot, false));
        while (judge.busy())
            rest();
    };
    finishUnseen();
    judge.submit(large(snapshot));
    EXPECT_FALSE(judge.newest());
    finishUnseen();
    judge.forget();
    EXPECT_FALSE(judge.newest());
}

TEST(BackgroundJudge, NumbersNeverFall) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    const JudgeTask moving = taskFor(snapshot, false), resting = taskFor(snapshot, true);
    std::uint64_t newest = 0, welcome = 0, asked = 0;
    int answers = 0;
    const auto look = [&] {
        const Answer answer = judge.newest();
        if (!answer || answer->number == newest) return;
        ++answers;
        EXPECT_GT(answer->number, newest);
        EXPECT_GE(answer->number, welcome) << "older than the last exact task";
        newest = answer->number;
    };
    for (int i = 0; i < 200; ++i) {
        JudgeTask task = i % 10 == 9 ? resting : moving;
        task.view.camera.positionWorld.x += 0.001 * i;
        const bool exact = task.exact;
        asked = judge.submit(std::move(task));
        if (exact) welcome = asked;
        look();
        if (i % 3 == 0) rest();
        while (i % 50 == 49 && judge.busy())
            rest();
        look();
    }
    EXPECT_EQ(newest, asked) << "the last one is always answered";
    EXPECT_GE(answers, 4);
}

TEST(BackgroundJudge, AStreamOfReducedTasksIsAnsweredNowAndThen) {
    JudgeTask moving = large(someScene(), 512); // longer than it takes for the next one to come
    moving.exact = false;
    BackgroundJudge judge;
    std::uint64_t newest = 0;
    int answers = 0;
    for (int submitted = 0; answers < 3; ++submitted) {
        ASSERT_LT(submitted, 20'000) << "if each task drops the one before, hardly any is answered";
        moving.view.camera.positionWorld.x += 1e-6;
        judge.submit(moving);
        rest();
        const Answer answer = judge.newest();
        if (answer && answer->number > newest) newest = answer->number, ++answers;
    }
}

TEST(BackgroundJudge, ForgetsWhatWasSubmitted) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    judge.submit(taskFor(snapshot, false));
    ASSERT_TRUE(whenDone(judge));
    judge.submit(large(snapshot));
    judge.forget();
    EXPECT_FALSE(judge.newest());
    EXPECT_FALSE(whenDone(judge));
    const std::uint64_t next = judge.submit(taskFor(snapshot, false));
    EXPECT_EQ(whenDone(judge)->number, next);
}

TEST(BackgroundJudge, EndsInTheMiddleOfItsWork) {
    const scene::Snapshot snapshot = someScene();
    for (const int ms : {0, 20, 40}) { // before it has begun, most likely, and in the middle
        BackgroundJudge judge;
        judge.submit(large(snapshot));
        for (int i = 0; i < ms; ++i)
            rest();
    }
    const BackgroundJudge idle;
}

TEST(BackgroundJudge, KeepsTheTruthWhileOnlyTheTechniqueChanges) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    judge.submit(taskFor(snapshot, true));
    const Answer first = whenDone(judge);
    JudgeTask changed = taskFor(snapshot, false);
    changed.slots[0].visibility.greyAlpha[0] = 255;
    judge.submit(std::move(changed));
    const Answer second = whenDone(judge);
    EXPECT_GT(second->number, first->number);
    EXPECT_EQ(second->truth, first->truth) << "the same one, not an equal one";
    EXPECT_TRUE(second->exact);
}

TEST(BackgroundJudge, SaysWhatWentWrongAndGoesOn) {
    const scene::Snapshot snapshot = someScene();
    BackgroundJudge judge;
    JudgeTask wrong = taskFor(snapshot, false);
    wrong.slots[0].visibility.greyAlpha.pop_back();
    judge.submit(std::move(wrong));
    EXPECT_THROW(whenDone(judge), std::logic_error);
    EXPECT_FALSE(judge.newest());
    JudgeTask noSuchLight = taskFor(snapshot, false);
    noSuchLight.light = 1;
    EXPECT_THROW(judge.submit(std::move(noSuchLight)), std::logic_error);
    const std::uint64_t right = judge.submit(taskFor(snapshot, false));
    EXPECT_EQ(whenDone(judge)->number, right);
}

TEST(BackgroundJudge, SameForAnyNumberOfThreads) {
    const scene::Snapshot snapshot = someScene();
    std::vector<Answer> answers;
    for (const char* threads : {"1", "3"}) {
        setenv("SHADOWLAB_THREADS", threads, 1); // nobody reads it now: the judge has not begun
        BackgroundJudge judge;
        judge.submit(taskFor(snapshot, true));
        answers.push_back(whenDone(judge));
    }
    unsetenv("SHADOWLAB_THREADS");
    EXPECT_EQ(answers[0]->truth->visibility, answers[1]->truth->visibility);
    EXPECT_EQ(answers[0]->truth->ties, answers[1]->truth->ties);
    EXPECT_EQ(answers[0]->slots[0]->judgement.verdicts, answers[1]->slots[0]->judgement.verdicts);
    EXPECT_GT(answers[0]->slots[0]->judgement.counts.wrong(), 500);
}

} // namespace
} // namespace shadowlab::lab
