// What pictures are graded by is right itself: the lecture's pictures of the cases, against closed forms and against other code.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/limits.h"
#include "app/student/grading/families.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/image/image.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab::student {
namespace {

using GradingReferenceTest = testing::GlTest;

scene::Snapshot sceneOfCase(const std::string& id) {
    return scene::loadScene((context::assetsRoot() / "grading" / (id + ".json")).string(),
                            {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = picture::limits()});
}

/// Of the finished picture, rows from the top.
std::vector<vec4> texelsOf(const scene::Snapshot& snapshot, const std::string& technique,
                           const std::vector<std::string>& settings = {}) {
    picture::Session session(snapshot);
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(technique));
    lab::applySettings(slots, settings);
    View view;
    view.camera = snapshot->camera;
    view.size = {kCaseWidth, kCaseHeight};
    EXPECT_TRUE(session.render(slots[0], view).converged);
    return gl::readTexels(slots[0].target.color);
}

/// By how many of 255 levels two intensities differ in a picture.
int levelsApart(float a, float b) { return std::abs(int{image::srgbFromLinear(a)} - int{image::srgbFromLinear(b)}); }

// E is 0.2, 0.16, 0.12 and rho 0.5, 0.6, 0.7: in all three colours B / pi = 0.4.
TEST_F(GradingReferenceTest, TheFurnaceIsAsBrightAsEnergyIsKept) {
    const Family& family = findFamily("radiosity");
    const auto texels = texelsOf(sceneOfCase("room-furnace"), std::string(family.reference));
    ASSERT_EQ(texels.size(), std::size_t{kCaseWidth} * kCaseHeight);
    int wrong = 0;
    for (const vec4& texel : texels)
        for (int channel = 0; channel < 3; ++channel)
            wrong += levelsApart(texel[channel], 0.4f) > family.levels;
    std::cout << wrong << " of " << 3 * texels.size() << " values are more than " << family.levels << " levels off\n";
    // In corners rows of form factors are wrong by up to a twentieth.
    EXPECT_LT(wrong, static_cast<int>(3 * texels.size() / 50));
}

struct ShiningSquare {
    const char* scene;
    dvec3 corners[4]; ///< counter-clockwise seen from the floor
    double emission;
};

/// J. H. Lambert, Photometria, 1760: which share of what leaves the floor at that place reaches the polygon, and the other way.
double lambert(const dvec3& place, const ShiningSquare& square) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const dvec3 a = glm::normalize(square.corners[i] - place),
                    b = glm::normalize(square.corners[(i + 1) % 4] - place);
        const dvec3 across = glm::cross(a, b);
        sum += std::acos(glm::clamp(glm::dot(a, b), -1.0, 1.0)) * across.y / glm::length(across);
    }
    return std::abs(sum) / (2 * glm::pi<double>());
}

// Black squares that shine on a floor: it has the radiosity rho F B at each place, F by Lambert's formula for polygons.
TEST_F(GradingReferenceTest, FormFactorsAreThoseOfLambert) {
    constexpr double kRho = 0.7;
    const ShiningSquare squares[] = {
        {"room-parallel", {{-0.75, 1.5, -0.75}, {0.75, 1.5, -0.75}, {0.75, 1.5, 0.75}, {-0.75, 1.5, 0.75}}, 6},
        {"room-corner", {{-2, 0, -2}, {2, 0, -2}, {2, 2, -2}, {-2, 2, -2}}, 1.6}};
    const Family& family = findFamily("radiosity");
    for (const ShiningSquare& square : squares) {
        const scene::Snapshot snapshot = sceneOfCase(square.scene);
        const auto texels = texelsOf(snapshot, std::string(family.reference));
        const scene::Camera& camera = snapshot->camera;
        const dmat3 worldFromView = glm::transpose(dmat3(scene::viewFromWorld(camera)));
        const double halfHeight = std::tan(glm::radians(camera.fovYDegrees) / 2);
        int compared = 0, wrong = 0;
        for (int y = 0; y < kCaseHeight; ++y)
            for (int x = 0; x < kCaseWidth; ++x) {
                const dvec2 center =
                    halfHeight / kCaseHeight * (2.0 * (dvec2(x, y) + 0.5) - dvec2(kCaseWidth, kCaseHeight));
                const dvec3 u = worldFromView * dvec3(center.x, -center.y, -1.0); // row 0 is the uppermost
                const dvec3 place = camera.positionWorld - camera.positionWorld.y / u.y * u;
                // A twentieth of a metre from the borders of the floor all of a pixel is on it.
                if (u.y >= 0 || std::abs(place.x) > 1.95 || std::abs(place.z) > 1.95) continue;
                const float found = texels[static_cast<std::size_t>(y * kCaseWidth + x)].g;
                if (found >= static_cast<float>(square.emission)) continue; // the square is before it
                ++compared;
                wrong += levelsApart(found, static_cast<float>(kRho * lambert(place, square) * square.emission)) >
                         family.levels;
            }
        std::cout << square.scene << ": " << wrong << " of " << compared << " pixels are more than " << family.levels
                  << " levels off\n";
        EXPECT_GT(compared, 10'000) << square.scene;
        // One radiosity stands for a whole patch, so where light falls off fast the patch's border is off. The limit of the
        // case is wide enough for a picture that has no patches at all: the closed form itself would have the points.
        const auto which = std::ranges::find(family.cases, square.scene, &Case::id);
        ASSERT_NE(which, family.cases.end());
        EXPECT_LT(wrong, which->limit) << square.scene;
    }
}

// The production technique finds the same with other rays, other triangles' tests and another tree.
TEST_F(GradingReferenceTest, RaysAreThoseOfTheProductionTechnique) {
    const Family& family = findFamily("ray-tracing");
    int cases = 0;
    for (const Case& which : family.cases) {
        if (which.judged != Judged::picture) continue;
        const scene::Snapshot snapshot = sceneOfCase(std::string(which.id));
        const auto mine = texelsOf(snapshot, std::string(family.reference));
        const auto theirs = texelsOf(snapshot, "ray-traced",
                                     {"ray-traced.depth=4", "ray-traced.fresnel=constant", "ray-traced.cutoff=0"});
        int wrong = 0;
        for (std::size_t i = 0; i < mine.size(); ++i)
            wrong += levelsApart(mine[i].g, theirs[i].g) > family.levels;
        std::cout << which.id << ": " << wrong << " of " << mine.size() << " pixels differ\n";
        // At the rim of a ball a smooth normal may send a ray to the wrong side of its flat triangle; the production technique notices.
        EXPECT_LT(wrong, static_cast<int>(mine.size() / 200)) << which.id;
        ++cases;
    }
    EXPECT_GE(cases, 4);
}

} // namespace
} // namespace shadowlab::student
