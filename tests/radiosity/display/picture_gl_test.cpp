// Radiosity as the session draws it.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include <glm/gtc/constants.hpp>

#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using RadiosityPictureTest = testing::GlTest;

scene::Snapshot builtIn(const char* name) {
    return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

struct Drawing {
    explicit Drawing(const scene::Snapshot& snapshot, const std::vector<std::string>& settings = {},
                     const std::string& technique = "radiosity", ivec2 size = {64, 48})
        : session(snapshot) {
        slots.push_back(picture::Session::makeSlot(technique));
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back(technique + "." + setting);
        lab::applySettings(slots, full);
        view.camera = snapshot->camera;
        view.size = size;
    }
    picture::RenderedFrame render(const FrameRequest& request = {}) { return session.render(slots[0], view, request); }
    std::vector<vec4> texels() {
        EXPECT_TRUE(render().converged);
        return gl::readTexels(slots[0].target.color);
    }
    picture::Session session;
    std::vector<picture::Slot> slots;
    View view;
};

double counted(const picture::RenderedFrame& frame, std::string_view id) {
    const auto found = std::ranges::find(frame.result.counters, id, &Counter::id);
    return found == frame.result.counters.end() ? -1 : found->built;
}

/// A room of which every wall emits and reflects alike, seen from inside.
scene::Scene uniformRoom(double emission, double reflectance) {
    scene::Scene scene = testing::emptyRoom({3, 2, 4});
    scene.materials[0].emission = vec3(static_cast<float>(emission));
    scene.materials[0].diffuse = vec3(static_cast<float>(reflectance));
    scene.camera.positionWorld = {0.3, 1.2, 3.6};
    scene.camera.targetWorld = {2, 0.7, 0};
    scene.camera.fovYDegrees = 80;
    return scene;
}

// In a uniform enclosure all is equally bright: E / (1 - rho), as if one looked at the light itself through fog.
TEST_F(RadiosityPictureTest, OfAUniformEnclosureEveryPixelIsAlike) {
    for (const char* display : {"display=flat", "direct=patches", "direct=light-map", "direct=pixels"})
        for (const char* formFactors : {"form-factors=analytic", "form-factors=hemicube"}) {
            Drawing drawing(testing::snapshot(uniformRoom(0.25, 0.5)),
                            {"patches=150", "tolerance=1e-6", display, formFactors});
            const std::vector<vec4> texels = drawing.texels();
            ASSERT_EQ(texels.size(), 64u * 48u);
            for (const vec4& texel : texels)
                ASSERT_NEAR(texel.g, 0.5, 0.5 / 1024) << display; // a half float has 11 bits; rows are scaled to 1
        }
}

TEST_F(RadiosityPictureTest, AClosedRoomThatReflectsEverythingIsRefused) {
    Drawing drawing(testing::snapshot(uniformRoom(0.25, 1)), {"patches=60"});
    try {
        drawing.render();
        ADD_FAILURE() << "there is no solution";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        EXPECT_NE(std::string(error.what()).find("reflect"), std::string::npos) << error.what();
    }
}

// The other technique that knows of light which was reflected more than once: rays followed from wall to wall by chance.
TEST_F(RadiosityPictureTest, AgreesWithPathsFollowedByChance) {
    const scene::Snapshot scene = builtIn("cornell-room");
    const ivec2 size{24, 14};
    Drawing traced(scene, {"samples=512", "interreflection=true", "depth=8", "cutoff=0", "antialias=false"},
                   "ray-traced", size);
    const std::vector<vec4> paths = traced.texels();
    for (const char* formFactors : {"form-factors=analytic", "form-factors=hemicube"}) {
        // Pixels are too large here to share what they gather, and by the usual rays each of them scatters by two hundredths.
        Drawing drawing(scene, {"patches=1200", "gather-samples=1024", formFactors}, "radiosity", size);
        const std::vector<vec4> patches = drawing.texels();
        double sum = 0, difference = 0;
        int compared = 0;
        for (std::size_t i = 0; i < paths.size(); ++i) {
            if (paths[i].g > 1) continue; // the lamp
            for (int c = 0; c < 3; ++c) {
                sum += static_cast<double>(paths[i][c]);
                difference += std::abs(static_cast<double>(paths[i][c]) - static_cast<double>(patches[i][c]));
            }
            ++compared;
        }
        EXPECT_GT(compared, 300);
        // Paths scatter by some hundredths each, after eight walls a thousandth is left; patches are 20 cm wide, and where two walls meet that shows.
        EXPECT_LT(difference / sum, 0.03) << formFactors;
    }
}

TEST_F(RadiosityPictureTest, APatchLooksAlikeFromEverywhere) {
    const scene::Snapshot scene = builtIn("cornell-room");
    Drawing drawing(scene, {"display=flat", "patches=100"}, "radiosity", {33, 33});
    const dvec3 aim(-1.38, 2.1, -1.5); // on the red wall, above the blocks
    std::vector<vec4> seen;
    for (const dvec3 eye :
         {dvec3(1.2, 2, -1.5), dvec3(-1.3, 2.2, -0.2), dvec3(0.2, 2.6, -1.4), dvec3(-1.2, 1.9, -1.6)}) {
        drawing.view.camera.positionWorld = eye;
        drawing.view.camera.targetWorld = aim;
        drawing.view.camera.near = 0.01;
        seen.push_back(drawing.texels()[16 * 33 + 16]);
    }
    EXPECT_GT(seen[0].r, 0.05f);
    for (const vec4& one : seen)
        EXPECT_EQ(one, seen[0]); // B = pi I, in whatever direction
}

// A chessboard of many small squares under an even sky: too many for patches of their own, so coarser triangles of the one colour
// or the other stand for it. Each pixel reflects by its own colour all the same; shown with the patches' colours, most of the
// squares would melt together.
TEST_F(RadiosityPictureTest, EachPixelReflectsByItsOwnMaterial) {
    constexpr int kSquares = 20;
    scene::Scene scene;
    scene.background = vec3(0.5f);
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.8f);
    scene.materials[1].diffuse = vec3(0.1f, 0.2f, 0.0f);
    scene::Mesh board;
    std::vector<uvec3> ofPart[2];
    for (int y = 0; y < kSquares; ++y)
        for (int x = 0; x < kSquares; ++x) {
            const auto first = static_cast<std::uint32_t>(board.positionsMesh.size());
            for (const ivec2 corner : {ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1)})
                board.positionsMesh.emplace_back(x + corner.x - kSquares / 2, y + corner.y - kSquares / 2, 0);
            ofPart[(x + y) % 2].emplace_back(first, first + 1, first + 2);
            ofPart[(x + y) % 2].emplace_back(first, first + 2, first + 3);
        }
    board.normalsMesh.assign(board.positionsMesh.size(), vec3(0, 0, 1));
    for (const auto& triangles : ofPart) {
        board.parts.push_back({"", static_cast<std::uint32_t>(board.triangles.size()),
                               static_cast<std::uint32_t>(triangles.size()), false});
        board.triangles.insert(board.triangles.end(), triangles.begin(), triangles.end());
    }
    testing::addObject(scene, std::move(board), dmat4(1));
    scene.objects[0].partMaterials = {0, 1};
    scene.camera.positionWorld = {0, 0, 12};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.fovYDegrees = 60;
    for (const char* display : {"direct=patches", "direct=light-map", "direct=pixels", "display=flat"}) {
        Drawing drawing(testing::snapshot(scene), {"patches=100", display}, "radiosity", {97, 97});
        const std::vector<vec4> texels = drawing.texels();
        const double metresOfPixel = 2 * 12 * std::tan(glm::radians(30.0)) / 97;
        int compared[2] = {0, 0}, wrong = 0;
        for (int y = 0; y < 97; ++y)
            for (int x = 0; x < 97; ++x) {
                const dvec2 at = metresOfPixel * dvec2(x - 48, 48 - y) + kSquares / 2.0, square = glm::floor(at);
                const dvec2 within = glm::abs(at - square - 0.5);
                if (std::max(within.x, within.y) > 0.45) continue; // a pixel may show two squares
                const int part = static_cast<int>(square.x + square.y) % 2;
                const vec3 expected = scene.materials[static_cast<std::size_t>(part)].diffuse * 0.5f;
                const vec3 off = glm::abs(vec3(texels[static_cast<std::size_t>(97 * y + x)]) - expected);
                wrong += std::max({off.r, off.g, off.b}) > 1e-3f; // half floats have 11 bits
                ++compared[part];
            }
        EXPECT_GT(std::min(compared[0], compared[1]), 2000);
        if (display == std::string("display=flat"))
            EXPECT_GT(wrong, 1000) << "patches have one colour each";
        else
            EXPECT_EQ(wrong, 0) << display;
    }
}

TEST_F(RadiosityPictureTest, AnEyeThatMovesSolvesNothingAgain) {
    Drawing drawing(builtIn("cornell-room"),
                    {"solver=shooting", "steps-per-picture=1", "tolerance=1e-9", "patches=100"});
    FrameRequest once;
    once.refine = false; // one picture at a time
    EXPECT_EQ(counted(drawing.render(once), "steps"), 1);
    for (int step = 2; step < 5; ++step) {
        drawing.view.camera.positionWorld.x += 0.1;
        EXPECT_EQ(counted(drawing.render(once), "steps"), step) << "it goes on where it was";
    }
}

TEST_F(RadiosityPictureTest, StepsStopTheSolver) {
    const scene::Snapshot scene = builtIn("cornell-room");
    double before = -1;
    for (const char* steps : {"steps=1", "steps=20", "steps=400"}) {
        Drawing drawing(scene, {"solver=southwell", steps, "tolerance=1e-9", "patches=100"});
        const auto frame = drawing.render();
        EXPECT_TRUE(frame.converged);
        EXPECT_EQ(counted(frame, "steps"), std::atof(steps + 6));
        double sum = 0;
        for (const vec4& texel : gl::readTexels(drawing.slots[0].target.color))
            sum += static_cast<double>(texel.g);
        EXPECT_GT(sum, before) << "the room brightens";
        before = sum;
    }
}

// With the ambient term the first picture of a room that is shot at is about as bright as the last; without, shots are seen.
TEST_F(RadiosityPictureTest, WithoutTheAmbientTermShotsBrightenTheRoom) {
    const scene::Snapshot scene = builtIn("cornell-room");
    const auto brightness = [&](const char* steps, const char* ambient) {
        Drawing drawing(scene, {"solver=shooting", steps, ambient, "tolerance=1e-9", "patches=100", "display=flat"});
        double sum = 0;
        for (const vec4& texel : drawing.texels())
            sum += static_cast<double>(texel.g);
        return sum;
    };
    const double first = brightness("steps=1", "ambient-term=false"),
                 some = brightness("steps=30", "ambient-term=false"),
                 most = brightness("steps=2000", "ambient-term=false"),
                 guessed = brightness("steps=1", "ambient-term=true");
    EXPECT_GT(some, 1.02 * first);
    EXPECT_GT(most, 1.02 * some);
    EXPECT_NEAR(guessed / most, 1, 0.1) << "an estimate: evenly spread it is not";
    EXPECT_LT(first / most, 0.85);
}

// What a lamp in a closed room sends is 4 pi I, and all of it is absorbed.
TEST_F(RadiosityPictureTest, TellsWhereThePowerGoes) {
    scene::Scene scene = uniformRoom(0, 0.5);
    scene::Light lamp;
    lamp.name = "lamp";
    lamp.type = scene::LightType::point;
    lamp.positionWorld = {1.4, 1.1, 2.2};
    lamp.intensity = 0.25;
    scene.lights.push_back(lamp);
    Drawing drawing(testing::snapshot(scene), {"patches=200", "tolerance=1e-6"});
    const auto frame = drawing.render();
    const auto note = std::ranges::find(frame.result.notes, "power", &Note::label);
    ASSERT_NE(note, frame.result.notes.end());
    double sent = 0, red = 0, absorbed = 0; // of each list of three, the first and the last
    ASSERT_EQ(
        std::sscanf(note->text.c_str(), "%lf, %*f, %lf W from lights and surroundings, %lf", &red, &sent, &absorbed), 3)
        << note->text;
    EXPECT_NEAR(sent, glm::pi<double>(), 1e-4)
        << "lines to the lamp are tried where it is hidden in part; here it is not";
    EXPECT_NEAR(absorbed, sent, 1e-4) << note->text;
}

TEST_F(RadiosityPictureTest, ALampThatMovesGivesWhatANewSceneGives) {
    const scene::Snapshot scene = builtIn("cornell-room");
    Drawing moving(scene, {"patches=100"});
    moving.texels();
    for (const double x : {0.5, -0.7, 0.1}) {
        std::vector<scene::Light> lights = scene->lights;
        lights[0].positionWorld.x = x;
        lights[0].intensity *= 1 + x;
        const scene::Snapshot moved = scene::withLights(scene, lights);
        moving.session.setScene(moved);
        Drawing fresh(moved, {"patches=100"});
        EXPECT_EQ(moving.texels(), fresh.texels()) << x;
    }
}

// Two rooms with a wall between them that stands in the middle of patches: not a trace of light gets through.
TEST_F(RadiosityPictureTest, BehindAWallItIsDark) {
    scene::Scene scene = testing::emptyRoom({4, 2, 3});
    scene.lights.push_back(testing::pointLight({0.6, 1.5, 1.1}));
    testing::addObject(scene, scene::makeBox({0.05, 2, 3}), testing::translation({1.77, 1, 1.5}));
    scene.camera.positionWorld = {3.8, 1.6, 2.8};
    scene.camera.targetWorld = {1.8, 0, 1};
    scene.camera.fovYDegrees = 90;
    const scene::Snapshot snapshot = testing::snapshot(scene);
    for (const char* display : {"display=flat", "direct=patches", "direct=light-map", "direct=pixels"}) {
        int bright = 0;
        for (const vec4& texel : Drawing(snapshot, {"patches=200", display}).texels())
            bright += texel.g > 0;
        EXPECT_EQ(bright, 0) << display;
    }
    int leaking = 0;
    for (const vec4& texel : Drawing(snapshot, {"patches=200", "display=flat", "cut-at-contacts=false"}).texels())
        leaking += texel.g > 0.001f;
    EXPECT_GT(leaking, 100) << "patches that lie on both sides of the wall carry light to the other";
}

} // namespace
} // namespace shadowlab
