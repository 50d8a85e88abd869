// What every registered technique must do, whatever it is: parameters, descriptions, stages, steps, probe. The suite is
// instantiated in contract_gl_test.cpp, for the tests of both files.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <set>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/params/param_json.h"
#include "tests/contract/contract_fixture.h"

namespace shadowlab {
namespace {

using testing::Contract;
using testing::kSize;
using testing::twoLights;

TEST_P(Contract, EveryParameterWorksAtBothEndsOfItsRange) {
    const ivec2 size = kSize / 4;                  // some of the upper ends are thousands of rays for each pixel
    constexpr std::chrono::seconds kLongEnough{2}; // and some hours of work: faults show before
    const auto snapshot = testing::snapshot(twoLights());
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    for (params::Param& param : slot.params)
        for (const bool maximum : {false, true}) {
            param.set(maximum ? param.maximum : param.minimum);
            FrameRequest request;
            request.deadline = std::chrono::steady_clock::now() + kLongEnough;
            try {
                session.render(slot, viewOf(snapshot, size), request);
                expectNoNaN(slot);
                EXPECT_EQ(gl::takeDebugMessages(), "") << param.id << "=" << params::valueText(param);
            } catch (const Error& error) { // more than this driver can do: said so, and which it can
                EXPECT_EQ(error.status(), ExitStatus::overLimit) << error.what();
                EXPECT_NE(std::string(error.what()).find("this OpenGL driver allows"), std::string::npos);
            }
            param.set(param.initial);
        }
}

TEST_P(Contract, ParametersSurviveTheWayThroughText) {
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    std::set<std::string> seen;
    for (params::Param& param : slot.params) {
        EXPECT_TRUE(seen.insert(param.id).second) << param.id << " twice";
        EXPECT_FALSE(param.help.empty()) << param.id;
        EXPECT_EQ(params::valueText(param), params::initialText(param));
        for (const double value : {param.minimum, param.maximum, param.initial}) {
            param.set(value);
            const std::string text = params::valueText(param);
            param.set(param.minimum);
            params::setFromText(param, text, GetParam());
            EXPECT_EQ(param.get(), value) << param.id;
        }
    }
}

TEST_P(Contract, ParametersSurviveTheWayThroughJson) {
    picture::Slot slot = picture::Session::makeSlot(GetParam()), copy = picture::Session::makeSlot(GetParam());
    for (params::Param& param : slot.params)
        param.set(param.maximum);
    params::setFromJson(copy.params, params::toJson(slot.params), GetParam());
    for (std::size_t i = 0; i < slot.params.size(); ++i)
        EXPECT_EQ(copy.params[i].get(), slot.params[i].get());
    EXPECT_THROW(params::setFromJson(copy.params, {{"no-such-parameter", 1}}, GetParam()), Error);
    for (std::size_t i = 0; i < slot.params.size(); ++i)
        EXPECT_EQ(copy.params[i].get(), slot.params[i].get());
}

TEST_P(Contract, DescriptionsAreCompleteAndUnique) {
    const TechniqueInfo& info = findTechnique(GetParam());
    const auto kebab = [](std::string_view id) {
        return !id.empty() && std::ranges::all_of(id, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        });
    };
    EXPECT_TRUE(kebab(info.id));
    EXPECT_FALSE(info.title.empty() || info.paper.empty() || info.getsWrong.empty());
    std::set<std::string_view> stages, passes;
    for (const StageInfo& stage : info.stages) {
        EXPECT_TRUE(kebab(stage.id)) << stage.id;
        EXPECT_TRUE(stages.insert(stage.id).second) << stage.id << " twice";
        EXPECT_FALSE(stage.caption.empty());
        EXPECT_NE(stage.id, "truth");
        EXPECT_NE(stage.id, "error");
    }
    EXPECT_TRUE(stages.contains("visibility"));
    for (const PassInfo& pass : info.passes) {
        EXPECT_TRUE(kebab(pass.id)) << pass.id;
        EXPECT_TRUE(passes.insert(pass.id).second) << pass.id << " twice";
        EXPECT_FALSE(pass.title.empty() || pass.why.empty() || pass.glState.empty()) << pass.id;
        EXPECT_TRUE(pass.shownBy.empty() || stages.contains(pass.shownBy)) << pass.id;
    }
}

TEST_P(Contract, EveryStageIsPublishedWhenWantedAndOnlyThen) {
    const auto snapshot = testing::snapshot(twoLights());
    const TechniqueInfo& info = findTechnique(GetParam());
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    const image::Image plain = picture(session, slot);
    for (const StageInfo& stage : info.stages)
        for (int light = 0; light < (stage.perLight ? 2 : 1); ++light) {
            const StageKey key{std::string(stage.id), stage.perLight ? light : kNoLight};
            FrameRequest request;
            request.stages = {key};
            const picture::RenderedFrame frame = session.render(slot, viewOf(snapshot), request);
            ASSERT_EQ(frame.result.stages.size(), 1u) << stage.id;
            const Stage& published = picture::findStage(frame, key);
            EXPECT_GT(published.texture.size().x, 0);
            if (stage.kind == StageKind::scalar || stage.kind == StageKind::count) {
                EXPECT_LT(published.display.minimum, published.display.maximum) << stage.id;
                EXPECT_FALSE(published.display.unit.empty()) << stage.id;
            }
            for (const vec4& texel : gl::readTexels(published.texture))
                ASSERT_TRUE(std::isfinite(texel.r)) << stage.id;
            // Looking on does not change the picture.
            const image::Image again = picture::PictureEncoder().encode(slot.target.color, snapshot->exposure);
            EXPECT_EQ(testing::differingPixels(again, plain, 0), 0)
                << stage.id << "; by more than a level " << testing::differingPixels(again, plain, 1);
        }
    EXPECT_TRUE(session.render(slot, viewOf(snapshot)).result.stages.empty());
}

TEST_P(Contract, StepModeStopsAfterEachPassThatRuns) {
    const auto snapshot = testing::snapshot(twoLights());
    const TechniqueInfo& info = findTechnique(GetParam());
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    const std::vector<StageKey> passes = session.render(slot, viewOf(snapshot)).result.passes;
    ASSERT_FALSE(passes.empty());
    for (std::size_t i = 0; i < passes.size(); ++i) {
        EXPECT_TRUE(std::ranges::any_of(info.passes, [&](const PassInfo& pass) { return pass.id == passes[i].id; }))
            << passes[i].id;
        FrameRequest request;
        request.stopAfter = passes[i];
        const auto ran = session.render(slot, viewOf(snapshot), request).result.passes;
        EXPECT_EQ(ran, std::vector<StageKey>(passes.begin(), passes.begin() + static_cast<std::ptrdiff_t>(i) + 1));
    }
}

TEST_P(Contract, PrepareIsResumable) {
    const auto snapshot = testing::snapshot(twoLights());
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    int calls = 1;
    while (!slot.technique->prepare(snapshot, Deadline::min()).converged && calls < 1000)
        ++calls;
    EXPECT_LT(calls, 1000) << "no progress under a deadline that has passed";
}

TEST_P(Contract, AnInterruptedFrameIsTakenUpAgain) {
    picture::Session session(testing::snapshot(twoLights()));
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    FrameRequest request;
    request.deadline = std::chrono::steady_clock::now();
    for (int i = 0; i < 1000 && !session.render(slot, viewOf(session.snapshot()), request).converged; ++i) {
    }
    const image::Image interrupted = picture::PictureEncoder().encode(slot.target.color, 1);
    EXPECT_EQ(interrupted, picture(twoLights()));
}

TEST_P(Contract, TheProbesShadowRayPointsToTheLight) {
    const auto snapshot = testing::snapshot(twoLights());
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    for (const int light : {0, 1}) {
        const Probe probe = slot.technique->probe(snapshot, viewOf(snapshot), {kSize.x / 2, kSize.y * 3 / 4}, light);
        const auto ray = std::ranges::find(probe.geometry, "shadow ray", &Probe::Segment::label);
        ASSERT_NE(ray, probe.geometry.end());
        const dvec4 lightWorld = scene::homogeneousPositionWorld(snapshot->light(light));
        const dvec3 toLight = glm::normalize(dvec3(lightWorld) - ray->fromWorld * lightWorld.w);
        EXPECT_GT(glm::dot(glm::normalize(ray->toWorld - ray->fromWorld), toLight), 1 - 1e-12);
    }
}

TEST_P(Contract, ProbeTellsSomethingOnEveryKindOfPixel) {
    const auto snapshot = testing::snapshot(twoLights());
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    for (const ivec2 pixel : {ivec2(0, 0), ivec2(kSize.x / 2, kSize.y / 2), ivec2(kSize.x - 1, kSize.y - 1)})
        EXPECT_FALSE(slot.technique->probe(snapshot, viewOf(snapshot), pixel, 1).facts.empty());
}

} // namespace
} // namespace shadowlab
