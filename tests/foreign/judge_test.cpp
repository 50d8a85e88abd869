// Pictures of a renderer of another make (foreign_renderer.h) held against the truth: right ones have no wrong pixel, and each mistake is
// called by its name, in visibility images and in shaded pictures, on every scene.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/base/error.h"
#include "tests/foreign/staged_pictures.h"

#include <memory>
#include <tuple>

namespace shadowlab::foreign {
namespace {

using foreign_renderer::Curve;
using foreign_renderer::Method;

struct Mistake {
    const char* name;
    const char* cause; ///< id of what is to be named first
    Settings settings;
};

/// Bias 0, bias 10 cm, no front cap, light shifted by 1 cm, half-pixel shift, flipped picture, 128 texels, back faces missing, wrong
/// winding; the wrong gamma has a test of its own.
std::vector<Mistake> mistakes() {
    Settings acne, bias, cap, light, half, flipped, coarse, backs, winding;
    acne.method = Method::map;
    bias.method = Method::map, bias.bias = 0.1, bias.texels = 2048;
    cap.method = Method::zfail, cap.frontCap = false;
    light.lightOffset = {0.01, 0, 0};
    half.centre = 0;
    flipped.flipRows = true;
    coarse.method = Method::map, coarse.texels = 128, coarse.bias = 0.03;
    backs.cullsCasters = true;
    winding.cullsCasters = true, winding.cullsView = true, winding.reversed = true;
    return {{"bias 0", "acne", acne}, {"bias 10 cm", "peter-panning", bias}, {"no front cap", "missing-front-cap", cap},
            {"light shifted by 1 cm", "light-displaced", light}, {"half a pixel", "shift", half}, {"flipped", "flipped", flipped},
            {"128 texels", "resolution", coarse}, {"back faces missing", "back-faces-missing", backs}, {"wrong winding", "wrong-winding", winding}};
}

/// A picture without front caps may be black all over, which has other causes as well: then it is the second to be named.
bool isBlack(const JudgedPicture& judged) { return judged.errors.judgement.counts.falseLit == 0 && judged.errors.judgement.counts.falseShadow == judged.errors.judgement.counts.lit; }

void expectNamed(const JudgedPicture& judged, const char* cause, const std::string& where) {
    ASSERT_FALSE(judged.diagnosis.causes.empty()) << where << "\n" << said(judged);
    if (std::string_view(cause) == "missing-front-cap" && judged.diagnosis.causes.front().id == "all-dark") {
        EXPECT_TRUE(isBlack(judged)) << where;
        ASSERT_EQ(judged.diagnosis.causes.size(), 2u) << where;
        EXPECT_EQ(judged.diagnosis.causes[1].id, cause) << where;
        return;
    }
    EXPECT_EQ(judged.diagnosis.causes.front().id, cause) << where << "\n" << said(judged);
    EXPECT_TRUE(judged.diagnosis.region);
    EXPECT_FALSE(judged.isRight());
}

TEST(ForeignJudgeTest, TheRightRendererHasNoWrongPixelOutsideTies) {
    int cases = 0;
    for (const Staged& stage : staged())
        for (const Method method : {Method::rays, Method::zfail}) {
            Settings settings;
            settings.method = method;
            const Pictures pictures = foreign_renderer::render(stage.own, settings);
            for (const JudgedPicture& judged : {judgedVisibility(stage, pictures), judgedPair(stage, pictures)}) {
                EXPECT_TRUE(judged.isRight()) << stage.own.name << "\n" << said(judged);
                EXPECT_GT(judged.errors.judgement.counts.lit, 5000);
                EXPECT_GT(judged.errors.judgement.counts.shadowed, 1000);
                EXPECT_LT(judged.errors.judgement.counts.ties, 300);
                ++cases;
            }
        }
    EXPECT_EQ(cases, 12);
}

TEST(ForeignJudgeTest, EachMistakeIsNamedInVisibilityImages) {
    int cases = 0;
    for (const Staged& stage : staged())
        for (const Mistake& mistake : mistakes()) {
            expectNamed(judgedVisibility(stage, foreign_renderer::render(stage.own, mistake.settings)), mistake.cause, stage.own.name + ", " + mistake.name);
            ++cases;
        }
    EXPECT_EQ(cases, 27);
}

TEST(ForeignJudgeTest, EachMistakeIsNamedInShadedPictures) {
    int cases = 0;
    for (const Staged& stage : staged())
        for (const Mistake& mistake : mistakes()) {
            expectNamed(judgedPair(stage, foreign_renderer::render(stage.own, mistake.settings)), mistake.cause, stage.own.name + ", " + mistake.name);
            ++cases;
        }
    EXPECT_EQ(cases, 27);
}

/// Mistakes beyond the usual ten, each on one scene.
TEST(ForeignJudgeTest, FurtherMistakesAreNamed) {
    Settings zpass, backCap, oneSided, missing, columns, parts, unlit, steps, greater, backSides, caps, nearPlane, farPlane;
    zpass.method = Method::zpass;
    backCap.method = Method::zfail, backCap.backCap = false;
    oneSided.method = Method::zpass, oneSided.onlyFrontSides = true;
    missing.withoutThing = 4;
    columns.flipColumns = true;
    parts.centre = 0.2;
    unlit.normalsToViewer = false;
    steps.samples = 3;
    greater.method = Method::zfail, greater.frontCap = false, greater.asksGreaterZero = true;
    backSides.method = Method::zpass, backSides.onlyBackSides = true;
    caps.method = Method::zfail, caps.frontCap = caps.backCap = false;
    nearPlane.lightNear = 1.5;
    farPlane.lightFar = 1.95;
    int cases = 0;
    for (const auto& [scene, cause, settings] :
         {std::tuple(1, "eye-in-shadow", zpass), std::tuple(0, "missing-back-cap", backCap), std::tuple(2, "back-faces-missing", oneSided), std::tuple(2, "caster-missing", missing),
          std::tuple(2, "flipped", columns), std::tuple(1, "shift", parts), std::tuple(0, "back-faces-missing", unlit), std::tuple(0, "soft-edges", steps),
          std::tuple(0, "missing-front-cap", greater), std::tuple(0, "front-faces-missing", backSides), std::tuple(0, "missing-caps", caps),
          std::tuple(0, "near-plane-of-light", nearPlane), std::tuple(0, "range-of-light", farPlane)}) {
        const Staged& stage = staged()[static_cast<std::size_t>(scene)];
        expectNamed(judgedVisibility(stage, foreign_renderer::render(stage.own, settings)), cause, stage.own.name + ", " + cause);
        ++cases;
    }
    EXPECT_EQ(cases, 13);
}

TEST(ForeignJudgeTest, AnInvertedPictureIsNamed) {
    int cases = 0, alone = 0;
    for (const Staged& stage : staged()) {
        image::Image picture = imageOf(foreign_renderer::render(stage.own, {}).visibility);
        for (std::size_t i = 0; i < picture.rgba.size(); ++i)
            if (i % 4 != 3) picture.rgba[i] = static_cast<std::uint8_t>(255 - picture.rgba[i]);
        const JudgedPicture judged = judgePicture(stage.scene, 0, truthOfLight(stage.scene->light(0)), picture, nullptr);
        // Where the eye stands in shadow, a count that does not know it gives the same picture: both are named.
        const std::vector<NamedCause>& causes = judged.diagnosis.causes;
        if (causes.size() == 2 && causes.front().id == "eye-in-shadow")
            EXPECT_EQ(causes[1].id, "inverted") << stage.own.name << "\n" << said(judged);
        else
            expectNamed(judged, "inverted", stage.own.name), ++alone;
        ++cases;
    }
    EXPECT_EQ(cases, 3);
    EXPECT_EQ(alone, 2); // the eye of one scene stands in shadow
}

/// The scene's light is a spot that lights a part of the picture, and the picture is drawn without its cone.
TEST(ForeignJudgeTest, AMissingConeIsNamed) {
    int cases = 0;
    for (const Staged& stage : staged()) {
        if (stage.own.isSun) continue;
        const Staged other = underASpot(stage);
        expectNamed(judgedVisibility(other, foreign_renderer::render(stage.own, {})), "cone", stage.own.name);
        ++cases;
    }
    EXPECT_EQ(cases, 2);
}

/// The scene has a second light, and the picture shows the shadows of that one.
TEST(ForeignJudgeTest, TheShadowsOfAnotherLightAreNamed) {
    int cases = 0;
    for (const Staged& stage : staged()) {
        if (stage.own.isSun) continue;
        auto two = std::make_shared<scene::Scene>(*stage.scene);
        two->lights.push_back(two->lights[0]);
        two->lights[1].name = "other";
        two->lights[0].positionWorld += dvec3(1.2, 0.3, -0.9); // far from the other, so that its shadows lie elsewhere
        const Staged other{stage.own, two};
        const JudgedPicture judged = judgedVisibility(other, foreign_renderer::render(stage.own, {}));
        expectNamed(judged, "other-light", stage.own.name);
        EXPECT_NE(judged.diagnosis.causes.front().what.find("'other'"), std::string::npos) << said(judged);
        ++cases;
    }
    EXPECT_EQ(cases, 2);
}

TEST(ForeignJudgeTest, AWrongGammaIsSeenInShadedPictures) {
    int cases = 0;
    for (const Staged& stage : staged())
        for (const auto& [curve, named] : {std::pair(Curve::linear, ToneCurve::linear), std::pair(Curve::twice, ToneCurve::doubleSrgb)}) {
            Settings settings;
            settings.curve = curve;
            const JudgedPicture judged = judgedPair(stage, foreign_renderer::render(stage.own, settings));
            ASSERT_TRUE(judged.encoding) << stage.own.name << "\n" << said(judged);
            EXPECT_EQ(judged.encoding->curve, named) << stage.own.name;
            EXPECT_FALSE(judged.isRight());
            // Read with the curve that was found, the shadows are right.
            EXPECT_EQ(judged.errors.judgement.counts.wrong(), 0) << stage.own.name << "\n" << said(judged);
            ++cases;
        }
    EXPECT_EQ(cases, 6);
}

/// It differs from sRGB by a few levels in the dark alone: the board shows it always, a picture only with much that is dark. Shadows are right
/// either way.
TEST(ForeignJudgeTest, AGammaOf22SpoilsNoShadow) {
    Settings settings;
    settings.curve = Curve::power22;
    int cases = 0;
    for (const Staged& stage : staged()) {
        const JudgedPicture judged = judgedPair(stage, foreign_renderer::render(stage.own, settings));
        EXPECT_EQ(judged.errors.judgement.counts.wrong(), 0) << stage.own.name << "\n" << said(judged);
        EXPECT_FALSE(judged.encoding) << stage.own.name; // too little is dark in these pictures
        EXPECT_GT(judged.errors.judgement.counts.shadowed, 1000);
        ++cases;
    }
    EXPECT_EQ(cases, 3);
}

image::Image constantImage(std::uint8_t grey, std::uint8_t alpha) {
    const Settings usual;
    return {usual.width, usual.height, {grey, grey, grey, alpha}};
}

JudgedPicture judgedImage(const Staged& stage, const image::Image& picture, const image::Image* reference = nullptr) {
    return judgePicture(stage.scene, 0, truthOfLight(stage.scene->light(0)), picture, reference);
}

TEST(ForeignJudgeTest, APictureOfOneKindIsNothingElse) {
    int cases = 0;
    for (const Staged& stage : staged())
        for (const auto& [grey, cause] : {std::pair<std::uint8_t, const char*>(0, "all-dark"), std::pair<std::uint8_t, const char*>(255, "no-shadows")}) {
            const JudgedPicture judged = judgedImage(stage, constantImage(grey, 255));
            ASSERT_FALSE(judged.diagnosis.causes.empty()) << stage.own.name;
            EXPECT_EQ(judged.diagnosis.causes.front().id, cause) << stage.own.name << said(judged);
            for (std::size_t i = 1; i < judged.diagnosis.causes.size(); ++i)
                EXPECT_EQ(judged.diagnosis.causes[i].id, "missing-front-cap") << stage.own.name << said(judged);
            ++cases;
        }
    EXPECT_EQ(cases, 6);
}

TEST(ForeignJudgeTest, AWhiteThatIsNot255IsSaid) {
    const Staged& stage = staged()[0];
    int cases = 0;
    for (const int white : {1, 128}) {
        image::Image picture = imageOf(foreign_renderer::render(stage.own, {}).visibility);
        for (std::size_t i = 0; i < picture.rgba.size(); ++i)
            if (i % 4 != 3) picture.rgba[i] = picture.rgba[i] > 127 ? static_cast<std::uint8_t>(white) : 0;
        const JudgedPicture judged = judgedImage(stage, picture);
        EXPECT_EQ(judged.white, white);
        EXPECT_EQ(judged.errors.judgement.counts.wrong(), 0) << said(judged);
        EXPECT_FALSE(judged.isRight());
        ++cases;
    }
    EXPECT_EQ(cases, 2);
}

TEST(ForeignJudgeTest, PicturesThatCannotBeJudgedAreRefused) {
    const Staged& stage = staged()[0];
    const Pictures pictures = foreign_renderer::render(stage.own, {});
    const image::Image shaded = imageOf(pictures.shaded), reference = imageOf(pictures.unshadowed);
    EXPECT_THROW((void)judgedImage(stage, constantImage(255, 0)), Error);
    EXPECT_THROW((void)judgedImage(stage, reference, &shaded), Error); // exchanged
    image::Image partly = imageOf(pictures.visibility);
    for (std::size_t i = 3; i < partly.rgba.size() / 2; i += 4)
        partly.rgba[i] = 0;
    EXPECT_NE(judgedImage(stage, partly).remark.find("transparent"), std::string::npos);
    EXPECT_TRUE(judgedImage(stage, shaded, &reference).remark.empty());
}

// Its shadows are right: brighter or flatter light must not make wrong ones, and white says nothing.
TEST(ForeignJudgeTest, AnOverexposedPairHasNoWrongShadows) {
    int cases = 0;
    for (const Staged& stage : staged())
        for (const double brighter : {3.0, 8.0}) {
            Staged bright{stage.own, stage.scene};
            bright.own.intensity *= brighter, bright.own.ambient *= brighter;
            const JudgedPicture judged = judgedPair(bright, foreign_renderer::render(bright.own, {}));
            EXPECT_EQ(judged.errors.judgement.counts.wrong(), 0) << stage.own.name << brighter << "\n" << said(judged);
            ++cases;
        }
    EXPECT_EQ(cases, 6);
}

TEST(ForeignJudgeTest, ANegatedCoordinateOfTheLightIsSaid) {
    int cases = 0;
    for (const Staged& stage : staged()) {
        if (stage.own.isSun) continue;
        Settings settings;
        settings.lightOffset = {-2 * stage.own.light.x, 0, 0};
        const JudgedPicture negated = judgedVisibility(stage, foreign_renderer::render(stage.own, settings));
        ASSERT_FALSE(negated.diagnosis.causes.empty());
        EXPECT_NE(negated.diagnosis.causes.front().what.find("x is negated"), std::string::npos) << said(negated);
        ++cases;
    }
    EXPECT_GE(cases, 1);
}

// Some pixels may fit a rule by chance.
TEST(ForeignJudgeTest, ACauseOfFewPixelsSaysSo) {
    const Staged& stage = staged()[0];
    Settings settings;
    settings.lightOffset = {0.001, 0, 0};
    const JudgedPicture judged = judgedVisibility(stage, foreign_renderer::render(stage.own, settings));
    ASSERT_GE(judged.errors.judgement.counts.wrong(), 1);
    ASSERT_LT(judged.errors.judgement.counts.wrong(), 10);
    for (const NamedCause& cause : judged.diagnosis.causes)
        EXPECT_NE(cause.what.find("this rests on"), std::string::npos) << cause.what;
    EXPECT_FALSE(judged.diagnosis.causes.empty());
}

} // namespace
} // namespace shadowlab::foreign
