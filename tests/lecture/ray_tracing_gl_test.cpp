// The lecture's ray tracing as it is drawn: against the exact judge, and where mirrors and glass have a closed form.
// SPDX-License-Identifier: MIT
#include <glm/gtc/matrix_transform.hpp>

#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using LectureRayTracingTest = testing::GlTest;
using testing::TruthComparison;

constexpr const char* kTechnique = "lecture-ray-tracing";

TruthComparison compare(const scene::Snapshot& snapshot, ivec2 size, int light) {
    return testing::compareWithTruth(snapshot, kTechnique, {}, size, light, testing::kTiePx);
}

// Plain double, no exact signs: outside ties no pixel is wrong in any built-in scene, since a rounding of 1e-15 moves no edge by a
// sixty-fourth of a pixel.
TEST_F(LectureRayTracingTest, VisibilityIsExactInEveryBuiltInScene) {
    int compared = 0, lit = 0, shadowed = 0;
    for (const char* name :
         {"billiards", "candle", "colonnade", "cornell-room", "eye-in-shadow", "hung-ring", "lattice", "leafy",
          "mirror-and-glass", "room-with-lamps", "sphere-on-plane", "still-life", "three-lights"}) {
        const scene::Snapshot scene =
            scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        for (int light = 0; light < static_cast<int>(scene->lights.size()); ++light) {
            const TruthComparison sum = compare(scene, {160, 90}, light);
            EXPECT_EQ(sum.wrong(), 0) << name << ", light " << light << ": " << sum;
            compared += sum.compared;
            lit += sum.lit;
            shadowed += sum.shadowed;
        }
    }
    std::cout << compared << " pixels, " << lit << " lit, " << shadowed << " in shadow\n";
    EXPECT_GT(compared, 200'000);
    EXPECT_GT(lit, 50'000);
    EXPECT_GT(shadowed, 10'000);
}

TEST_F(LectureRayTracingTest, VisibilityIsExactInHardScenes) {
    TruthComparison all;
    for (const bool directional : {false, true})
        for (const testing::HardClass hardClass : testing::kHardClasses)
            for (unsigned i = 0; i < 3; ++i)
                all += compare(testing::snapshot(testing::hardScene(hardClass, i, directional)), {160, 120}, 0);
    std::cout << all << "\n";
    EXPECT_GT(all.lit, 50'000);
    EXPECT_GT(all.shadowed, 10'000);
    EXPECT_EQ(all.wrong(), 0);
}

// Far from the origin the place where a ray starts is rounded to some 1e-10 m: under a low sun it would meet its own triangle on the
// way out, if that were not left out by name.
TEST_F(LectureRayTracingTest, FarFromTheOriginNoSurfaceShadowsItself) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::directionalLight({1, -0.05, 0.3})};
    const TruthComparison sum = compare(testing::snapshot(testing::moved(scene, {1e6, -1e6, 1e6})), {240, 160}, 0);
    EXPECT_GT(sum.lit, 5000);
    EXPECT_GT(sum.shadowed, 500);
    EXPECT_EQ(sum.wrong(), 0) << sum;
}

/// The middle of a picture of three by three pixels.
vec4 middleOf(scene::Scene scene, const std::vector<std::string>& settings, std::string_view stage = {}) {
    scene.revisions = {};
    picture::Session session(testing::snapshot(std::move(scene)));
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(kTechnique));
    std::vector<std::string> full;
    for (const std::string& setting : settings)
        full.push_back(std::string(kTechnique) + "." + setting);
    lab::applySettings(slots, full);
    View view;
    view.camera = session.snapshot()->camera;
    view.size = {3, 3};
    FrameRequest request;
    if (!stage.empty()) request.stages = {{std::string(stage), kNoLight}};
    const picture::RenderedFrame frame = session.render(slots[0], view, request);
    return gl::readTexels(stage.empty() ? slots[0].target.color
                                        : picture::findStage(frame, request.stages[0]).texture)[4];
}

/// A quad of 4 x 4 m that stands at x, y, z and looks along +z or -z, of a material of its own that emits.
void addScreen(scene::Scene& scene, const dvec3& middle, bool towardPlusZ, float emission, double reflectivity = 0) {
    scene::Material material;
    material.diffuse = vec3(0.0f);
    material.emission = vec3(emission);
    material.reflectivity = reflectivity;
    scene.materials.push_back(material);
    const dmat4 turn = glm::rotate(dmat4(1), glm::radians(towardPlusZ ? 90.0 : -90.0), dvec3(1, 0, 0));
    testing::addObject(scene, scene::makeQuad({4, 4}), testing::translation(middle) * turn).partMaterials = {
        static_cast<std::uint32_t>(scene.materials.size() - 1)};
}

scene::Scene darkScene() {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.camera.positionWorld = {0, 0, 0};
    scene.camera.targetWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 10;
    return scene;
}

// Two mirrors that face each other, with the eye between them: I = e (1 + k + k^2 + ... + k^D), and what the rays at the bottom
// of the tree have, k^(D + 1) times the background.
TEST_F(LectureRayTracingTest, TheTreeIsAsDeepAsItMayBe) {
    constexpr float kE = 0.25f, kBackground = 0.5f;
    constexpr double kR = 0.5;
    scene::Scene scene = darkScene();
    scene.background = vec3(kBackground);
    addScreen(scene, {0, 0, -2}, true, kE, kR);
    addScreen(scene, {0, 0, 2}, false, kE, kR);
    double sum = 0;
    for (int depth = 0; depth <= 8; ++depth) {
        sum += kE * std::pow(kR, depth);
        const std::vector<std::string> settings{"depth=" + std::to_string(depth)};
        // Half floats hold 11 bits.
        EXPECT_NEAR(middleOf(scene, settings).g, sum + kBackground * std::pow(kR, depth + 1), 1e-3) << depth;
        EXPECT_EQ(middleOf(scene, settings, "tree-depth").r, static_cast<float>(depth + 1));
    }
    scene.materials[1].reflectivity = 0;
    EXPECT_NEAR(middleOf(scene, {}).g, kE, 1e-3) << "a light source that is not a reflecting surface ends the ray";
    EXPECT_EQ(middleOf(scene, {}, "tree-depth").r, 1.0f);
}

TEST_F(LectureRayTracingTest, IntensityIsAttenuatedByTheDistance) {
    scene::Scene scene = darkScene();
    addScreen(scene, {0, 0, -2}, true, 0.9f);
    EXPECT_NEAR(middleOf(scene, {}).g, 0.9, 1e-3);
    EXPECT_NEAR(middleOf(scene, {"c1=0.5", "c2=0.25"}).g, 0.9 / (1 + 0.5 * 2 + 0.25 * 4), 1e-3);
    EXPECT_EQ(middleOf(scene, {}, "distance").r, 2.0f);
}

// A plate of glass shifts what lies behind it sideways by t sin(a - b) / cos b, sin a = n sin b: Snell's law at both faces.
TEST_F(LectureRayTracingTest, APlateOfGlassShiftsTheRayAsSnellSays) {
    constexpr double kThick = 0.5, kIor = 1.5, kTurn = 40;
    const double a = glm::radians(kTurn), b = std::asin(std::sin(a) / kIor);
    const double shift = kThick * std::sin(a - b) / std::cos(b);
    const auto seen = [&](double edge) { // a white screen to the right of x = edge, behind a turned plate
        scene::Scene scene = darkScene();
        addScreen(scene, {edge + 2, 0, -5}, true, 1);
        scene::Material glass;
        glass.diffuse = vec3(0.0f);
        glass.transparency = 1;
        glass.ior = kIor;
        scene.materials.push_back(glass);
        const dmat4 turn = glm::rotate(dmat4(1), a, dvec3(0, 1, 0));
        testing::addObject(scene, scene::makeBox({3, 3, kThick}), testing::translation({0, 0, -2}) * turn)
            .partMaterials = {static_cast<std::uint32_t>(scene.materials.size() - 1)};
        return middleOf(scene, {}).g;
    };
    ASSERT_GT(shift, 0.1);
    // The plate's front is turned toward +x, and within it the ray bends toward -N: it comes out on the side of -x.
    EXPECT_GT(seen(-shift - 0.001), 0.99f);
    EXPECT_LT(seen(-shift + 0.001), 0.01f);
    EXPECT_LT(seen(0), 0.01f) << "without glass this is where it would end";
}

// A prism of 45 degrees turns the ray by a right angle: it meets the long side at 45 degrees, beyond the critical angle of glass
// (41.8), and all that would be let through is reflected.
TEST_F(LectureRayTracingTest, APrismReflectsTotally) {
    scene::Scene scene = darkScene();
    scene.background = vec3(0.0f);
    const dvec3 front{0, 0, -2}; // the leg that the ray enters spans x = -1 ... 1; the other leg looks toward +x
    const dvec3 a = front + dvec3(-1, -1, 0), b = front + dvec3(1, -1, 0), c = front + dvec3(1, -1, -2);
    const dvec3 up(0, 2, 0);
    scene::Material glass;
    glass.diffuse = vec3(0.0f);
    glass.transparency = 1;
    glass.ior = 1.5;
    scene.materials.push_back(glass);
    testing::addObject(scene, testing::triangleSoup({a, b, b + up, a,      b + up, a + up,   // toward the eye
                                                     b, c, c + up, b,      c + up, b + up,   // toward +x
                                                     c, a, a + up, c,      a + up, c + up,   // the long side
                                                     a, c, b,      a + up, b + up, c + up})) // below and above
        .partMaterials = {1};
    scene::Material lamp;
    lamp.emission = vec3(0.75f);
    scene.materials.push_back(lamp);
    const dmat4 turn = glm::rotate(dmat4(1), glm::radians(90.0), dvec3(0, 0, 1)); // it stands at x = 4
    testing::addObject(scene, scene::makeQuad({4, 4}), testing::translation({4, 0, -3}) * turn).partMaterials = {2};
    EXPECT_NEAR(middleOf(scene, {}).g, 0.75, 1e-3);
    scene.materials[1].ior = 1.2; // critical angle 56.4: the ray goes on through the long side
    EXPECT_NEAR(middleOf(scene, {}).g, 0, 1e-3);
}

// The production technique with the lecture's constant coefficients draws the same picture, where nothing transparent lies in
// anything transparent.
TEST_F(LectureRayTracingTest, MirrorsAndGlassAreThoseOfTheProductionTechnique) {
    scene::Scene scene = testing::simpleScene();
    scene.lights[0].intensity = 20;
    scene.background = {0.2f, 0.3f, 0.5f};
    for (const auto& [reflectivity, transparency] : {std::pair(0.5, 0.0), {0.1, 0.8}}) {
        scene::Material material = scene.materials[0];
        material.diffuse = vec3(0.2f);
        material.reflectivity = reflectivity;
        material.transparency = transparency;
        scene.materials.push_back(material);
    }
    scene.objects[1].partMaterials = {1};
    scene.objects[2].partMaterials = {2};
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const auto texels = [&](const char* technique, const std::vector<std::string>& settings) {
        picture::Session session(snapshot);
        std::vector<picture::Slot> slots;
        slots.push_back(picture::Session::makeSlot(technique));
        lab::applySettings(slots, settings);
        View view;
        view.camera = snapshot->camera;
        view.size = {240, 160};
        session.render(slots[0], view);
        return gl::readTexels(slots[0].target.color);
    };
    const auto mine = texels(kTechnique, {"lecture-ray-tracing.depth=4"});
    const auto theirs =
        texels("ray-traced", {"ray-traced.depth=4", "ray-traced.fresnel=constant", "ray-traced.cutoff=0"});
    std::size_t different = 0;
    for (std::size_t i = 0; i < mine.size(); ++i)
        different += std::abs(mine[i].g - theirs[i].g) > 2e-3f;
    std::cout << different << " of " << mine.size() << " pixels differ\n";
    EXPECT_GT(mine.size(), 30'000u);
    // At the rim of the ball a smooth normal may send a ray to the wrong side of its flat triangle; the production technique notices.
    EXPECT_LT(different, mine.size() / 500);
}

} // namespace
} // namespace shadowlab
