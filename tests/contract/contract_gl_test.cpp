// What every registered technique must do, whatever it is: its pictures. A new technique is held to this by existing.
// SPDX-License-Identifier: MIT
#include <functional>
#include <set>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/contract/contract_fixture.h"

namespace shadowlab {
namespace {

using testing::Contract;
using testing::differingPixels;
using testing::kSize;
using testing::twoLights;

TEST_P(Contract, SameInputSameBytes) {
    const image::Image first = picture(twoLights()), second = picture(twoLights());
    EXPECT_EQ(first, second);
    std::set<std::uint8_t> levels(first.rgba.begin(), first.rgba.end());
    EXPECT_GE(levels.size(), 2u) << "an empty picture proves nothing";
}

TEST_P(Contract, AnotherTechniqueInBetweenChangesNothing) {
    picture::Session session(testing::snapshot(twoLights()));
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    const image::Image before = picture(session, slot);
    for (const std::string& id : testing::ids()) {
        picture::Slot other = picture::Session::makeSlot(id);
        picture(session, other);
    }
    EXPECT_EQ(picture(session, slot), before);
}

TEST_P(Contract, ResizingThereAndBackGivesTheFirstPicture) {
    picture::Session session(testing::snapshot(twoLights()));
    picture::Slot slot = picture::Session::makeSlot(GetParam());
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
        picture::Session session(testing::snapshot(scene));
        picture::Slot slot = picture::Session::makeSlot(GetParam());
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
        picture::Session session(testing::snapshot(scene));
        picture::Slot slot = picture::Session::makeSlot(GetParam());
        picture(session, slot);
        expectNoNaN(slot);
    }
}

TEST_P(Contract, EveryChangeOfTheSceneIsSeen) {
    const scene::Scene first = twoLights();
    picture::Session session(testing::snapshot(first));
    picture::Slot slot = picture::Session::makeSlot(GetParam());
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

TEST_P(Contract, EveryTechniqueCoversTheSamePixels) {
    const auto snapshot = testing::snapshot(twoLights());
    FrameRequest request;
    request.stages = {{"visibility", 1}};
    const auto coverage = [&](const std::string& id) {
        picture::Session session(snapshot);
        picture::Slot slot = picture::Session::makeSlot(id);
        const auto frame = session.render(slot, viewOf(snapshot), request);
        const auto image = picture::readVisibility(picture::findStage(frame, request.stages[0]));
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
        picture::Session session(testing::snapshot(scene));
        picture::Slot slot = picture::Session::makeSlot(GetParam());
        session.render(slot, viewOf(session.snapshot()));
        return gl::readTexels(slot.target.color);
    };
    const auto sum = radiance(both), a = radiance(first), b = radiance(second), dark = radiance(none);
    // Half floats hold 11 bits: three roundings of values below 2 are at most 3/1024.
    for (std::size_t i = 0; i < sum.size(); ++i)
        ASSERT_NEAR(sum[i].g, a[i].g + b[i].g - dark[i].g, 3.0 / 1024) << i;
}

TEST_P(Contract, CullingChangesNoByte) {
    picture::Slot slot = picture::Session::makeSlot(GetParam());
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

TEST_P(Contract, ARegionIsTheSamePictureThere) {
    const auto snapshot = testing::snapshot(twoLights());
    const image::Image whole = picture(twoLights());
    View view = viewOf(snapshot);
    view.region = {{17, 9}, {40, 31}};
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot(GetParam());
    session.render(slot, view);
    const image::Image part = picture::PictureEncoder().encode(slot.target.color, 1);
    const auto differing = [&](int levels) {
        int count = 0;
        for (int y = 9; y < 9 + 31; ++y)
            for (int x = 17; x < 17 + 40; ++x) {
                const image::Color8 here = part.at(x, y), there = whole.at(x, y);
                const int largest = std::max({std::abs(here.r - there.r), std::abs(here.g - there.g),
                                              std::abs(here.b - there.b), std::abs(here.a - there.a)});
                count += largest > levels;
            }
        return count;
    };
    EXPECT_EQ(differing(0), 0) << "by more than a level " << differing(1);
}

INSTANTIATE_TEST_SUITE_P(All, Contract, ::testing::ValuesIn(testing::ids()), testing::testName);

} // namespace
} // namespace shadowlab
