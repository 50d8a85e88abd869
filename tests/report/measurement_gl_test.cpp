// Measuring techniques whose errors are known beforehand: one that paints the truth with so many pixels turned over,
// one that forgets a caster, and every technique of the registry with its faults switched on.
// SPDX-License-Identifier: MIT
#include "app/report/measurement.h"

#include <cmath>

#include "app/lab/settings.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/area_lights.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab::report {
namespace {

using judge::Counts, judge::Judgement, judge::judge, judge::Truth, judge::Verdict;
using Result = TechniqueErrors;
using trace::Visibility;

constexpr ivec2 kSize{320, 240};

void timeAll(Measurement& measurement) {
    for (int turn = 0; turn < measurement.turns(); ++turn)
        measurement.timeTurn(turn);
}

class MeasurementTest : public testing::GlTest {
protected:
    static std::vector<picture::Slot> slots(const std::vector<std::string>& ids, const std::vector<std::string>& settings = {}) {
        std::vector<picture::Slot> slots;
        for (const std::string& id : ids)
            slots.push_back(picture::Session::makeSlot(id));
        lab::applySettings(slots, settings);
        return slots;
    }
    static std::vector<Result> measure(const scene::Snapshot& snapshot, std::vector<picture::Slot> slots,
                                       const film::Motion& motion = {}, int light = 0) {
        picture::Session session(snapshot);
        Measurement measurement(session, slots, light, kSize);
        for (int frame = 0; frame < motion.frames; ++frame)
            measurement.addFrame(film::momentAt(motion, snapshot, frame));
        timeAll(measurement);
        return measurement.results();
    }
    static Result measure(const scene::Scene& scene, const std::string& id,
                          const std::vector<std::string>& settings = {}) {
        return measure(testing::snapshot(scene), slots({id}, settings))[0];
    }
    /// The counts add up, and there was something to be wrong about.
    static void expectSound(const Result& result) {
        const Counts& counts = result.counts;
        EXPECT_EQ(counts.pixels, counts.lit + counts.shadowed + counts.turnedAway + counts.ties) << result.technique;
        EXPECT_GT(counts.lit, 500);
        EXPECT_GT(counts.shadowed, 500);
        EXPECT_LT(counts.ties, counts.pixels / 200);
        EXPECT_LE(result.coreErrors, counts.wrong());
        EXPECT_FALSE(result.times.passMs().empty());
        EXPECT_GT(result.times.frameMs(), 0);
    }
};

/// Paints the truth of a light, as far as the test lets it.
class Painted final : public Technique {
public:
    using Change = std::function<float(const Truth&, ivec2 pixel)>; ///< the visibility to paint there
    explicit Painted(Change change, judge::TruthOf of) : change_(std::move(change)), of_(of) {}
    [[nodiscard]] bool samplesArea(const scene::Scene&, int) const override { return of_ == judge::TruthOf::area; }
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        tracer_.advance(snapshot, deadline);
        return {};
    }
    Progress render(Frame& frame) override {
        static const PassInfo kPass{"paint", "Paint", "As the test says.", "none", false};
        frame.pass(kPass, [&] { glClear(GL_COLOR_BUFFER_BIT); });
        if (!frame.wants("visibility", 0)) return {};
        const ivec2 size = frame.view().size;
        const Truth truth = judge::truthAtCentres(tracer_, frame.view().camera, size, 0, {}, of_);
        std::vector<vec2> texels(truth.visibility.size());
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const std::size_t i = truth.index(x, y);
                const bool covered = truth.visibility[i] != Visibility::noSurface;
                texels[truth.index(x, size.y - 1 - y)] = covered ? vec2(change_(truth, {x, y}), 1) : vec2(0);
            }
        gl::Texture2D texture(GL_RG32F, size, "painted");
        texture.bind(0);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RG, GL_FLOAT, texels.data());
        frame.publish("visibility", 0, std::move(texture));
        return {};
    }
    static picture::Slot slot(Change change, judge::TruthOf of) {
        static const TechniqueInfo info = [] {
            TechniqueInfo info;
            info.id = "painted";
            info.stages = {{"visibility", "As the test says", StageKind::visibility, true}};
            return info;
        }();
        return {&info, std::make_unique<Painted>(std::move(change), of), {}, {}};
    }

private:
    Change change_;
    judge::TruthOf of_;
    trace::SceneTracer tracer_;
};

float exactly(const Truth& truth, ivec2 pixel) {
    return truth.visibility[truth.index(pixel.x, pixel.y)] == Visibility::lit ? 1.0f : 0.0f;
}

Result measurePainted(const scene::Snapshot& snapshot, const Painted::Change& change, const film::Motion& motion = {},
                      judge::TruthOf of = judge::TruthOf::centre) {
    std::vector<picture::Slot> slots;
    slots.push_back(Painted::slot(change, of));
    picture::Session session(snapshot);
    Measurement measurement(session, slots, 0, kSize);
    for (int frame = 0; frame < motion.frames; ++frame)
        measurement.addFrame(film::momentAt(motion, snapshot, frame));
    timeAll(measurement);
    return measurement.results()[0];
}

TEST_F(MeasurementTest, PaintedTruthHasNoError) {
    const Result result = measurePainted(testing::snapshot(testing::simpleScene()), exactly);
    expectSound(result);
    EXPECT_EQ(result.counts.wrong(), 0);
    EXPECT_EQ(result.counts.stray, 0);
    EXPECT_EQ(result.counts.rmse, 0);
    EXPECT_EQ(*result.edgeErrorPx, 0);
    EXPECT_EQ(result.boundaryPx->max, 0);
}

/// The simple scene under one panel.
scene::Scene panelScene() {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5})};
    return scene;
}

TEST_F(MeasurementTest, PaintedSharesHaveNoErrorAndDoNotFlicker) {
    const Result result = measurePainted(
        testing::snapshot(panelScene()),
        [](const Truth& truth, ivec2 p) { return static_cast<float>(truth.share(truth.index(p.x, p.y))); },
        {3, 2.0, {}, {}}, judge::TruthOf::area);
    expectSound(result);
    EXPECT_EQ(result.truth, judge::TruthOf::area);
    // A byte is cut at 127.5 / 255, the truth at one half: nothing lies between but what is rounded.
    EXPECT_EQ(result.counts.wrong(), 0);
    EXPECT_GT(result.counts.rmse, 0);
    EXPECT_LT(result.counts.rmse, 0.5 / 255);
    EXPECT_EQ(result.boundaryPx->max, 0);
    EXPECT_EQ(*result.excessFlipRate, 0);
}

TEST_F(MeasurementTest, EachTechniqueIsHeldAgainstTheTruthItAnswersTo) {
    const scene::Snapshot snapshot = testing::snapshot(panelScene());
    std::vector<picture::Slot> few = slots({"shadow-volume-zfail", "shadow-map", "shadow-map"},
                                  {"2:shadow-map.light-samples=4", "3:shadow-map.light-samples=64"});
    const std::vector<Result> results = measure(snapshot, std::move(few));
    EXPECT_EQ(results[0].truth, judge::TruthOf::centre);
    EXPECT_EQ(results[1].truth, judge::TruthOf::area);
    EXPECT_EQ(results[0].counts.wrong(), 0);
    EXPECT_EQ(results[0].counts.rmse, 0) << "a sharp shadow is right for a point";
    EXPECT_GT(results[1].counts.rmse, 2 * results[2].counts.rmse);
    EXPECT_LT(results[2].counts.rmse, 0.02);
    EXPECT_EQ(results[1].counts.lit, results[2].counts.lit);
    EXPECT_NE(results[0].counts.lit, results[2].counts.lit);
}

TEST_F(MeasurementTest, CountsExactlyThePixelsThatWereTurnedOver) {
    // A square in the shadowed part and one in the lit part turned over, and everything turned away lit in one more.
    const auto snapshot = testing::snapshot(testing::simpleScene());
    int lit = 0, dark = 0;
    const auto turnedOver = [](const Truth& truth, ivec2 p) {
        return truth.visibility[truth.index(p.x, p.y)] == Visibility::lit ? p.x % 16 == 3 && p.y % 16 == 5
                                                                          : p.x % 4 == 1 && p.y % 4 == 2;
    };
    const Result result = measurePainted(snapshot, [&](const Truth& truth, ivec2 p) {
        const float exact = exactly(truth, p);
        if (!turnedOver(truth, p)) return exact;
        ++(exact > 0.5f ? lit : dark);
        return 1.0f - exact;
    });
    // Some of them may be ties, which are not judged; painting happens once, for the one frame that is judged.
    ASSERT_GT(lit, 100);
    ASSERT_GT(dark, 100);
    EXPECT_LE(result.counts.falseShadow, lit);
    EXPECT_GE(result.counts.falseShadow, lit - result.counts.ties);
    EXPECT_LE(result.counts.falseLit, dark);
    EXPECT_GE(result.counts.falseLit, dark - result.counts.ties);
    const int judged = result.counts.lit + result.counts.shadowed + result.counts.turnedAway;
    EXPECT_NEAR(result.counts.rmse, std::sqrt(double(result.counts.wrong()) / judged), 1e-12);
    EXPECT_GT(result.coreErrors, result.counts.wrong() / 2);
}

// Grey for everything: nothing is more than half visible, so all that is lit is wrong, and the error of visibility is
// that of 127/255 to 0 and to 1.
TEST_F(MeasurementTest, RmseIsThatOfVisibilityNotOfVerdicts) {
    const Result result =
        measurePainted(testing::snapshot(testing::simpleScene()), [](const Truth&, ivec2) { return 127.0f / 255.0f; });
    const Counts& counts = result.counts;
    EXPECT_EQ(counts.falseShadow, counts.lit);
    EXPECT_EQ(counts.falseLit, 0);
    const double dark = counts.shadowed + counts.turnedAway, low = 127.0 / 255, high = 128.0 / 255;
    EXPECT_NEAR(counts.rmse, std::sqrt((dark * low * low + counts.lit * high * high) / (dark + counts.lit)), 1e-12);
}

// The wrong side of every triangle: what faces the light is dark, what is turned away is lit.
TEST_F(MeasurementTest, AFlippedFacingSignShows) {
    const Result result = measurePainted(testing::snapshot(testing::simpleScene()), [](const Truth& truth, ivec2 p) {
        return truth.visibility[truth.index(p.x, p.y)] == Visibility::turnedAway ? 1.0f : 0.0f;
    });
    EXPECT_EQ(result.counts.falseLit, result.counts.turnedAway);
    EXPECT_EQ(result.counts.falseShadow, result.counts.lit);
    EXPECT_GT(result.counts.turnedAway, 200);
}

TEST_F(MeasurementTest, AHoleIsWrongWhateverTheTruth) {
    Truth truth;
    truth.size = {4, 1};
    truth.visibility = {Visibility::lit, Visibility::shadowed, Visibility::turnedAway, Visibility::noSurface};
    truth.objects = {0, 0, 0, trace::kNoPrimitive};
    truth.ties = {0, 0, 0, 0};
    const Judgement holes = judge(truth, std::vector<std::uint8_t>(8, 0));
    EXPECT_EQ(holes.verdicts,
              (std::vector{Verdict::falseShadow, Verdict::falseLit, Verdict::falseLit, Verdict::background}));
    const Judgement full = judge(truth, std::vector<std::uint8_t>(8, 255));
    EXPECT_EQ(full.verdicts, (std::vector{Verdict::correct, Verdict::falseLit, Verdict::falseLit, Verdict::stray}));
    EXPECT_EQ(full.counts.stray, 1);
    EXPECT_EQ(full.counts.pixels, 3);
    truth.ties = {1, 1, 1, 1};
    const Judgement ties = judge(truth, std::vector<std::uint8_t>(8, 255));
    EXPECT_EQ(ties.counts.wrong() + ties.counts.stray, 0);
    EXPECT_EQ(ties.counts.ties, 3);
}

TEST_F(MeasurementTest, WithoutShadowsEveryShadowedPixelIsFalseLit) {
    const Result result = measure(testing::simpleScene(), "unshadowed");
    expectSound(result);
    EXPECT_EQ(result.counts.falseLit, result.counts.shadowed);
    EXPECT_EQ(result.counts.falseShadow, 0);
    EXPECT_GT(result.coreErrors, result.counts.shadowed / 2);
}

TEST_F(MeasurementTest, ExactTechniquesAreMeasuredExact) {
    for (const char* id : {"ray-traced", "shadow-volume-zfail"}) {
        const Result result = measure(testing::simpleScene(), id);
        expectSound(result);
        EXPECT_EQ(result.counts.wrong(), 0) << id;
        EXPECT_EQ(result.coreErrors, 0) << id;
        EXPECT_EQ(*result.edgeErrorPx, 0) << id;
        EXPECT_TRUE(std::isinf(result.picture.psnr) || result.picture.psnr > 30) << id;
    }
    const Result traced = measure(testing::simpleScene(), "ray-traced");
    EXPECT_TRUE(std::isinf(traced.picture.psnr));
    EXPECT_DOUBLE_EQ(traced.picture.ssim, 1);
    EXPECT_EQ(traced.picture.flip, 0);
}

TEST_F(MeasurementTest, AShadowMapErrsAtEdgesAndLessWithMoreTexels) {
    const Result coarse = measure(testing::simpleScene(), "shadow-map", {"shadow-map.resolution=64"});
    const Result fine = measure(testing::simpleScene(), "shadow-map", {"shadow-map.resolution=2048"});
    for (const Result& result : {coarse, fine})
        expectSound(result);
    EXPECT_GT(*coarse.edgeErrorPx, 4 * *fine.edgeErrorPx);
    EXPECT_GT(coarse.boundaryPx->mean, fine.boundaryPx->mean);
    EXPECT_GT(coarse.counts.wrong(), 50);
}

// Every one of these must be seen, or the zeros above prove nothing.
TEST_F(MeasurementTest, BiasZeroShowsAsAcne) {
    const std::vector<std::string> noBias = {"shadow-map.bias-mode=none", "shadow-map.filter=hard"};
    const Result bare = measure(testing::simpleScene(), "shadow-map", noBias);
    const Result biased = measure(testing::simpleScene(), "shadow-map", {"shadow-map.filter=hard"});
    EXPECT_GT(bare.counts.falseShadow, 20 * (biased.counts.falseShadow + 10));
    EXPECT_GT(bare.coreErrors, 1000);
}

TEST_F(MeasurementTest, NaiveShadowVolumesShow) {
    for (const char* naive : {"caps=false", "depth-test=lequal", "wrap=false"}) {
        int wrong = 0;
        for (const testing::HardClass hardClass : {testing::HardClass::soup, testing::HardClass::torus})
            for (unsigned number = 0; number < 3; ++number)
                wrong += measure(testing::hardScene(hardClass, number, false), "shadow-volume-zfail",
                                 {"shadow-volume-zfail." + std::string(naive)})
                             .counts.wrong();
        EXPECT_GT(wrong, 100) << naive;
    }
}

/// Draws shadow volumes of a scene in which one object has been forgotten.
class Forgetful final : public Technique {
public:
    explicit Forgetful(std::size_t object) : object_(object) {}
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        auto scene = std::make_shared<scene::Scene>(*snapshot);
        scene->objects[object_].castsShadow = false;
        scene->revisions = {};
        without_ = scene;
        return volumes_->prepare(without_, deadline);
    }
    Progress render(Frame& frame) override {
        FrameRequest request;
        request.stages = {{"visibility", 0}};
        Frame inner(without_, frame.view(), frame.buffers(), frame.target(), request);
        volumes_->render(inner);
        frame.publish("visibility", 0, std::move(inner.takeResult().stages[0].texture));
        return {};
    }

private:
    std::size_t object_;
    scene::Snapshot without_;
    std::unique_ptr<Technique> volumes_ = findTechnique("shadow-volume-zfail").make();
};

TEST_F(MeasurementTest, AForgottenCasterShows) {
    static const TechniqueInfo info = [] {
        TechniqueInfo info = findTechnique("shadow-volume-zfail");
        info.id = "forgetful";
        return info;
    }();
    const auto snapshot = testing::snapshot(testing::simpleScene());
    for (std::size_t object = 1; object < snapshot->objects.size(); ++object) {
        std::vector<picture::Slot> slots;
        slots.push_back({&info, std::make_unique<Forgetful>(object), {}, {}});
        picture::Session session(snapshot);
        Measurement measurement(session, slots, 0, kSize);
        measurement.addFrame({snapshot, snapshot->camera});
        const Result result = measurement.results()[0];
        EXPECT_GT(result.counts.falseLit, 200) << snapshot->objects[object].name;
        EXPECT_GT(result.coreErrors, 100) << snapshot->objects[object].name;
        EXPECT_EQ(result.counts.falseShadow, 0);
    }
}

TEST_F(MeasurementTest, FlipsOfExactTechniquesFollowTheTruth) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    film::Motion motion;
    motion.frames = 6;
    motion.orbitLightDegrees = 6.0;
    auto measured = slots({"ray-traced", "shadow-map", "shadow-volume-zfail"}, {"shadow-map.resolution=128"});
    const std::vector<Result> results = measure(snapshot, std::move(measured), motion);
    EXPECT_EQ(*results[0].excessFlipRate, 0);
    EXPECT_GT(*results[1].excessFlipRate, 0.01);
    EXPECT_EQ(*results[2].excessFlipRate, 0);
    EXPECT_EQ(results[0].times.frames(), 6u);
    // What stands still does not flicker, whatever draws it.
    film::Motion still;
    still.frames = 3;
    for (const Result& result : measure(snapshot, slots({"shadow-map", "shadow-volume-zfail"}), still))
        EXPECT_EQ(*result.excessFlipRate, 0) << result.technique;
}

TEST_F(MeasurementTest, FlickerIsCountedPerPixelOfBoundary) {
    // Every 16th pixel in both directions goes on and off from frame to frame.
    int frame = 0, flickering = 0, before = kSize.y;
    film::Motion still;
    still.frames = 4;
    const Result result = measurePainted(
        testing::snapshot(testing::simpleScene()),
        [&](const Truth& truth, ivec2 p) {
            frame += p.y < before; // rows from the top: a new frame
            before = p.y;
            if (p.x % 16 != 0 || p.y % 16 != 0) return exactly(truth, p);
            flickering += frame == 1;
            return frame % 2 ? 1.0f : 0.0f;
        },
        still);
    ASSERT_EQ(frame, 4);
    ASSERT_GT(flickering, 100);
    const double boundary = result.counts.wrong() / *result.edgeErrorPx; // of the first frame, and so of each
    EXPECT_NEAR(*result.excessFlipRate, flickering / boundary, 1e-9);    // 3 changes over 3 boundaries
}

TEST_F(MeasurementTest, SaysWhenNothingIsProved) {
    scene::Scene open = testing::floorScene();
    open.lights.push_back(testing::pointLight({0, 5, 0}));
    EXPECT_TRUE(measure(open, "ray-traced").counts.provesNothing());
    EXPECT_FALSE(measure(testing::simpleScene(), "ray-traced").counts.provesNothing());
}

} // namespace
} // namespace shadowlab::report
