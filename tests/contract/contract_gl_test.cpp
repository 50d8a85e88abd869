// What every registered technique must do, whatever it is. A new technique is held to this by existing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>

#include "app/session/picture.h"
#include "app/session/settings.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/params/param_json.h"
#include "techniques/foundation/scene/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{96, 64};

std::vector<std::string> ids() {
    std::vector<std::string> all;
    for (const RegisteredTechnique& technique : registeredTechniques())
        all.emplace_back(technique.info->id);
    return all;
}

class Contract : public testing::GlTest, public ::testing::WithParamInterface<std::string> {
protected:
    static View viewOf(const scene::Snapshot& snapshot, ivec2 size = kSize) {
        View view;
        view.camera = snapshot->camera;
        view.size = size;
        return view;
    }
    image::Image picture(session::Session& session, session::Slot& slot, ivec2 size = kSize) {
        session.render(slot, viewOf(session.snapshot(), size));
        return session::PictureEncoder().encode(slot.target.color, session.snapshot()->exposure);
    }
    image::Image picture(const scene::Scene& scene, const std::vector<std::string>& settings = {}, ivec2 size = kSize) {
        session::Session session(testing::snapshot(scene));
        std::vector<session::Slot> slots;
        slots.push_back(session::Session::makeSlot(GetParam()));
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back(GetParam() + "." + setting);
        session::applySettings(slots, full);
        return picture(session, slots[0], size);
    }
    void expectNoNaN(const session::Slot& slot) {
        for (const vec4& texel : gl::readTexels(slot.target.color))
            ASSERT_TRUE(std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b));
    }
};

scene::Scene twoLights() {
    scene::Scene scene = testing::simpleScene();
    scene.lights[0].intensity = 20; // bright, and below clipping
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    scene.lights.back().intensity = 0.6;
    return scene;
}

int differingPixels(const image::Image& a, const image::Image& b, int levels) {
    int count = 0;
    for (std::size_t p = 0; p < a.rgba.size(); p += 4) {
        int largest = 0;
        for (std::size_t c = 0; c < 4; ++c)
            largest = std::max(largest, std::abs(a.rgba[p + c] - b.rgba[p + c]));
        count += largest > levels;
    }
    return count;
}

TEST_P(Contract, SameInputSameBytes) {
    const image::Image first = picture(twoLights()), second = picture(twoLights());
    EXPECT_EQ(first, second);
    std::set<std::uint8_t> levels(first.rgba.begin(), first.rgba.end());
    EXPECT_GE(levels.size(), 2u) << "an empty picture proves nothing";
}

TEST_P(Contract, AnotherTechniqueInBetweenChangesNothing) {
    session::Session session(testing::snapshot(twoLights()));
    session::Slot slot = session::Session::makeSlot(GetParam());
    const image::Image before = picture(session, slot);
    for (const std::string& id : ids()) {
        session::Slot other = session::Session::makeSlot(id);
        picture(session, other);
    }
    EXPECT_EQ(picture(session, slot), before);
}

TEST_P(Contract, ResizingThereAndBackGivesTheFirstPicture) {
    session::Session session(testing::snapshot(twoLights()));
    session::Slot slot = session::Session::makeSlot(GetParam());
    const image::Image before = picture(session, slot);
    for (const ivec2 size : {ivec2(1, 1), ivec2(17, 200), ivec2(301, 3)})
        EXPECT_EQ(picture(session, slot, size).width, size.x);
    EXPECT_EQ(picture(session, slot), before);
}

TEST_P(Contract, UnusualScenesAreDrawnWithoutFaults) {
    std::vector<scene::Scene> scenes(6, testing::simpleScene());
    scenes[0].objects.clear();
    scenes[1].lights.clear();
    scenes[2].camera.positionWorld = {0.25, 0.25, 0.6}; // in the sphere's shadow
    scenes[3].lights[0].positionWorld = {0, 1, 100};    // behind the camera and everything
    scenes[4].camera.positionWorld = {1.25, 1, 0.25};   // inside the torus
    scenes[4].lights[0].positionWorld = {2, 1, -0.5};   // so is the light
    scenes[5].objects[1].castsShadow = false;
    scenes[5].objects[0].receivesShadow = false;
    for (const scene::Scene& scene : scenes) {
        session::Session session(testing::snapshot(scene));
        session::Slot slot = session::Session::makeSlot(GetParam());
        picture(session, slot);
        expectNoNaN(slot);
    }
}

TEST_P(Contract, EveryLightTypeIsDrawnWithoutFaults) {
    for (const scene::LightType type : findTechnique(GetParam()).lightTypes) {
        scene::Scene scene = testing::simpleScene();
        scene.lights[0].type = type;
        scene.lights[0].directionWorld = glm::normalize(dvec3(-0.4, -1, -0.6));
        scene.lights[0].edgeDegrees = 5;
        session::Session session(testing::snapshot(scene));
        session::Slot slot = session::Session::makeSlot(GetParam());
        picture(session, slot);
        expectNoNaN(slot);
    }
}

TEST_P(Contract, EveryParameterWorksAtBothEndsOfItsRange) {
    const auto snapshot = testing::snapshot(twoLights());
    session::Slot described = session::Session::makeSlot(GetParam());
    for (std::size_t p = 0; p < described.params.size(); ++p)
        for (const bool maximum : {false, true}) {
            session::Session session(snapshot);
            session::Slot slot = session::Session::makeSlot(GetParam());
            params::Param& param = slot.params[p];
            param.set(maximum ? param.maximum : param.minimum);
            picture(session, slot);
            expectNoNaN(slot);
            EXPECT_EQ(gl::takeDebugMessages(), "") << param.id << "=" << params::valueText(param);
        }
}

TEST_P(Contract, ParametersSurviveTheWayThroughText) {
    session::Slot slot = session::Session::makeSlot(GetParam());
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
    session::Slot slot = session::Session::makeSlot(GetParam()), copy = session::Session::makeSlot(GetParam());
    for (params::Param& param : slot.params)
        param.set(param.maximum);
    params::setFromJson(copy.params, params::toJson(slot.params), GetParam());
    for (std::size_t i = 0; i < slot.params.size(); ++i)
        EXPECT_EQ(copy.params[i].get(), slot.params[i].get());
    EXPECT_THROW(params::setFromJson(copy.params, {{"no-such-parameter", 1}}, GetParam()), Error);
    for (std::size_t i = 0; i < slot.params.size(); ++i)
        EXPECT_EQ(copy.params[i].get(), slot.params[i].get());
}

TEST_P(Contract, EveryChangeOfTheSceneIsSeen) {
    const scene::Scene first = twoLights();
    session::Session session(testing::snapshot(first));
    session::Slot slot = session::Session::makeSlot(GetParam());
    picture(session, slot);
    // Each step changes one thing of the scene before it and says so; what is cached must not outlive it.
    scene::Scene scene = first;
    const std::vector<std::function<void()>> changes = {
        [&] {
            scene.lights[0].positionWorld.x -= 3;
            scene.revisions.lights = scene::newRevision();
        },
        [&] {
            scene.lights[0].positionWorld.z -= 3;
            scene.revisions.lights = scene::newRevision();
        },
        [&] {
            scene.objects[3].worldFromObject[3].x -= 1;
            scene.revisions.transforms = scene::newRevision();
        },
        [&] {
            scene.objects.erase(scene.objects.begin() + 1);
            scene.revisions.geometry = scene::newRevision();
        },
        [&] {
            scene.lights.pop_back();
            scene.revisions.lights = scene::newRevision();
        },
        [&] {
            scene = testing::floorScene();
            scene.lights.push_back(testing::pointLight({1, 2, 3}));
        },
    };
    for (const auto& change : changes) {
        change();
        session.setScene(testing::snapshot(scene));
        EXPECT_EQ(picture(session, slot), picture(scene));
    }
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
    }
}

TEST_P(Contract, EveryStageIsPublishedWhenWantedAndOnlyThen) {
    const auto snapshot = testing::snapshot(twoLights());
    const TechniqueInfo& info = findTechnique(GetParam());
    session::Session session(snapshot);
    session::Slot slot = session::Session::makeSlot(GetParam());
    const image::Image plain = picture(session, slot);
    for (const StageInfo& stage : info.stages)
        for (int light = 0; light < (stage.perLight ? 2 : 1); ++light) {
            const StageKey key{std::string(stage.id), stage.perLight ? light : kNoLight};
            FrameRequest request;
            request.stages = {key};
            const session::RenderedFrame frame = session.render(slot, viewOf(snapshot), request);
            ASSERT_EQ(frame.result.stages.size(), 1u) << stage.id;
            const Stage& published = session::findStage(frame, key);
            EXPECT_GT(published.texture.size().x, 0);
            if (stage.kind == StageKind::scalar || stage.kind == StageKind::count) {
                EXPECT_LT(published.display.minimum, published.display.maximum) << stage.id;
                EXPECT_FALSE(published.display.unit.empty()) << stage.id;
            }
            for (const vec4& texel : gl::readTexels(published.texture))
                ASSERT_TRUE(std::isfinite(texel.r)) << stage.id;
            // Looking on does not change the picture.
            EXPECT_EQ(session::PictureEncoder().encode(slot.target.color, snapshot->exposure), plain) << stage.id;
        }
    EXPECT_TRUE(session.render(slot, viewOf(snapshot)).result.stages.empty());
}

TEST_P(Contract, StepModeStopsAfterEachPassThatRuns) {
    const auto snapshot = testing::snapshot(twoLights());
    const TechniqueInfo& info = findTechnique(GetParam());
    session::Session session(snapshot);
    session::Slot slot = session::Session::makeSlot(GetParam());
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

TEST_P(Contract, EveryTechniqueCoversTheSamePixels) {
    const auto snapshot = testing::snapshot(twoLights());
    FrameRequest request;
    request.stages = {{"visibility", 1}};
    const auto coverage = [&](const std::string& id) {
        session::Session session(snapshot);
        session::Slot slot = session::Session::makeSlot(id);
        const auto frame = session.render(slot, viewOf(snapshot), request);
        const auto image = session::readVisibility(session::findStage(frame, request.stages[0]));
        std::vector<std::uint8_t> alpha;
        for (std::size_t i = 1; i < image.greyAlpha.size(); i += 2)
            alpha.push_back(image.greyAlpha[i]);
        return alpha;
    };
    const auto reference = coverage("unshadowed");
    EXPECT_GT(std::ranges::count(reference, 255), 1000);
    EXPECT_GT(std::ranges::count(reference, 0), 500);
    EXPECT_EQ(coverage(GetParam()), reference);
}

TEST_P(Contract, LightsAddUpAndAmbientIsCountedOnce) {
    scene::Scene both = twoLights(), first = both, second = both, none = both;
    first.lights.pop_back();
    second.lights.erase(second.lights.begin());
    none.lights.clear();
    const auto radiance = [&](const scene::Scene& scene) {
        session::Session session(testing::snapshot(scene));
        session::Slot slot = session::Session::makeSlot(GetParam());
        session.render(slot, viewOf(session.snapshot()));
        return gl::readTexels(slot.target.color);
    };
    const auto sum = radiance(both), a = radiance(first), b = radiance(second), dark = radiance(none);
    // Half floats hold 11 bits: three roundings of values below 2 are at most 3/1024.
    for (std::size_t i = 0; i < sum.size(); ++i)
        ASSERT_NEAR(sum[i].g, a[i].g + b[i].g - dark[i].g, 3.0 / 1024) << i;
}

TEST_P(Contract, CullingChangesNoByte) {
    session::Slot slot = session::Session::makeSlot(GetParam());
    if (std::ranges::none_of(slot.params, [](const params::Param& p) { return p.id == "cull"; }))
        GTEST_SKIP() << GetParam() << " leaves nothing out";
    scene::Scene scene = twoLights();
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 50, 0}));  // shadows the floor
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 3, 200})); // far behind the eye
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({400, 3, 0})); // far beside the view
    EXPECT_EQ(picture(scene, {"cull=true"}), picture(scene, {"cull=false"}));
}

TEST_P(Contract, MovedByAHundredThousandItIsTheSamePicture) {
    const ivec2 size{320, 240};
    const image::Image here = picture(twoLights(), {}, size);
    for (const dvec3 offset : {dvec3(1e5, 0, 0), dvec3(-1e5, 1e5, 1e5), dvec3(1e6, 0, -1e6)}) {
        const image::Image there = picture(testing::moved(twoLights(), offset), {}, size);
        // One pixel in ten thousand may lie within rounding of an edge or of a texel's border.
        EXPECT_LE(differingPixels(here, there, 2), size.x * size.y * 1e-4) << offset.x;
    }
}

TEST_P(Contract, PrepareIsResumable) {
    const auto snapshot = testing::snapshot(twoLights());
    session::Slot slot = session::Session::makeSlot(GetParam());
    int calls = 1;
    while (!slot.technique->prepare(snapshot, Deadline::min()).converged && calls < 1000)
        ++calls;
    EXPECT_LT(calls, 1000) << "no progress under a deadline that has passed";
}

TEST_P(Contract, AnInterruptedFrameIsTakenUpAgain) {
    session::Session session(testing::snapshot(twoLights()));
    session::Slot slot = session::Session::makeSlot(GetParam());
    FrameRequest request;
    request.deadline = std::chrono::steady_clock::now();
    for (int i = 0; i < 1000 && !session.render(slot, viewOf(session.snapshot()), request).converged; ++i) {
    }
    const image::Image interrupted = session::PictureEncoder().encode(slot.target.color, 1);
    EXPECT_EQ(interrupted, picture(twoLights()));
}

TEST_P(Contract, ARegionIsTheSamePictureThere) {
    const auto snapshot = testing::snapshot(twoLights());
    const image::Image whole = picture(twoLights());
    View view = viewOf(snapshot);
    view.region = {{17, 9}, {40, 31}};
    session::Session session(snapshot);
    session::Slot slot = session::Session::makeSlot(GetParam());
    session.render(slot, view);
    const image::Image part = session::PictureEncoder().encode(slot.target.color, 1);
    for (int y = 9; y < 9 + 31; ++y)
        for (int x = 17; x < 17 + 40; ++x) ASSERT_EQ(part.at(x, y), whole.at(x, y)) << x << "," << y;
}

TEST_P(Contract, TheProbesShadowRayPointsToTheLight) {
    const auto snapshot = testing::snapshot(twoLights());
    session::Slot slot = session::Session::makeSlot(GetParam());
    for (const int light : {0, 1}) {
        const Probe probe = slot.technique->probe(snapshot, viewOf(snapshot), {kSize.x / 2, kSize.y * 3 / 4}, light);
        const auto ray = std::ranges::find(probe.geometry, "shadow ray", &Probe::Segment::label);
        ASSERT_NE(ray, probe.geometry.end());
        const dvec4 lightWorld = scene::homogeneousPositionWorld(snapshot->lights[static_cast<std::size_t>(light)]);
        const dvec3 toLight = glm::normalize(dvec3(lightWorld) - ray->fromWorld * lightWorld.w);
        EXPECT_GT(glm::dot(glm::normalize(ray->toWorld - ray->fromWorld), toLight), 1 - 1e-12);
    }
}

TEST_P(Contract, ProbeTellsSomethingOnEveryKindOfPixel) {
    const auto snapshot = testing::snapshot(twoLights());
    session::Slot slot = session::Session::makeSlot(GetParam());
    for (const ivec2 pixel : {ivec2(0, 0), ivec2(kSize.x / 2, kSize.y / 2), ivec2(kSize.x - 1, kSize.y - 1)})
        EXPECT_FALSE(slot.technique->probe(snapshot, viewOf(snapshot), pixel, 1).facts.empty());
}

INSTANTIATE_TEST_SUITE_P(All, Contract, ::testing::ValuesIn(ids()), [](const auto& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

} // namespace
} // namespace shadowlab
