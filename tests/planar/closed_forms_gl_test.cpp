// Shadows whose outlines are known in closed form, drawn by planar projection.
//   ball under a lamp        the shadow is an ellipse, where the cone from the lamp around the ball meets the floor
//   square parallel to it    the shadow is the square, larger by h / (h - q)
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using PlanarClosedFormTest = testing::GlTest;

constexpr ivec2 kSize{1000, 1000};

/// The area in shadow, in square metres, and the mean distance in pixels that the outline lies outside of one of that area and
/// length. The picture is turned by an angle that is that of no edge in it, so that pixels' centres lie evenly on both sides
/// of every part of the outline: the area of a shape of `length` pixels around is found to within a few of their square roots.
double displacementPx(scene::Scene scene, const testing::PlaneView& view, double areaMetres, double lengthMetres) {
    scene.camera = view.camera();
    constexpr double kAngle = 0.3;
    scene.camera.upWorld = {std::sin(kAngle), 0, -std::cos(kAngle)};
    const auto image = testing::renderVisibility(testing::snapshot(scene), "planar", {}, view.size, 0);
    int inShadow = 0, lit = 0, atBorder = 0;
    for (int y = 0; y < view.size.y; ++y)
        for (int x = 0; x < view.size.x; ++x) {
            const bool dark = image.grey(x, y) < 128;
            inShadow += dark;
            lit += !dark;
            atBorder += dark && (x == 0 || y == 0 || x == view.size.x - 1 || y == view.size.y - 1);
        }
    EXPECT_GT(lit, 10000);
    EXPECT_EQ(atBorder, 0) << "all of the shadow is in the picture";
    const double scale = view.pixelsPerMetre;
    return (inShadow - areaMetres * scale * scale) / (lengthMetres * scale);
}

struct BallCase {
    dvec3 lightWorld, centreWorld;
    double radius;
};

// Half axes a, b of the ellipse in which a cone of half angle alpha about an axis at an angle tau to the vertical meets the
// floor, h below its apex: a = h sin alpha cos alpha / k, b = h sin alpha / sqrt(k), k = cos^2 tau - sin^2 alpha. Its middle is
// h sin tau cos tau / k from the point below the light.
TEST_F(PlanarClosedFormTest, ABallsShadowIsAnEllipse) {
    constexpr int kSegments = 1024; // inscribed in the ball: smaller by 4.7e-6 of its radius
    const std::vector<BallCase> cases = {{{0, 4, 0}, {0, 1, 0}, 0.5},
                                         {{2, 4, 1}, {0, 1, 0}, 0.5},
                                         {{3, 5, 0}, {0, 1, 0}, 1},
                                         {{0, 5, 0}, {0, 2, 0}, 1},
                                         {{6, 2.1, 0}, {0, 1, 0}, 1}};
    for (const BallCase& one : cases) {
        const dvec3 axis = one.centreWorld - one.lightWorld;
        const double h = one.lightWorld.y, sinAlpha = one.radius / glm::length(axis);
        const double cosTau = -axis.y / glm::length(axis), sinTau = std::sqrt(1 - cosTau * cosTau);
        const double k = cosTau * cosTau - sinAlpha * sinAlpha;
        const double a = h * sinAlpha * std::sqrt(1 - sinAlpha * sinAlpha) / k, b = h * sinAlpha / std::sqrt(k);
        const dvec2 below(one.lightWorld.x, one.lightWorld.z), level(axis.x, axis.z);
        const dvec2 middle =
            below + (glm::length(level) > 0 ? glm::normalize(level) : dvec2(0)) * h * sinTau * cosTau / k;
        scene::Scene scene = testing::planeUnderLight(one.lightWorld);
        testing::addObject(scene, scene::makeSphere(one.radius, kSegments), testing::translation(one.centreWorld));
        const testing::PlaneView view{middle, 0.45 * kSize.y / a, kSize};
        const testing::EllipseInPicture ellipse{.a = a, .b = b};
        const double displaced = displacementPx(scene, view, M_PI * a * b, ellipse.lengthPx());
        std::cout << "half axes " << a << " and " << b << ": " << displaced << " px outside\n";
        EXPECT_NEAR(displaced, 0, 0.02);
    }
}

TEST_F(PlanarClosedFormTest, ABallOfFewerFacesIsFoundToBeSmaller) {
    scene::Scene scene = testing::planeUnderLight({0, 4, 0});
    testing::addObject(scene, scene::makeSphere(0.5, 64), testing::translation({0, 1, 0}));
    const double radius = 0.6761234038;
    const testing::PlaneView view{{0, 0}, 0.45 * kSize.y / radius, kSize};
    EXPECT_LT(displacementPx(scene, view, M_PI * radius * radius, 2 * M_PI * radius), -0.1);
}

TEST_F(PlanarClosedFormTest, ASquaresShadowIsALargerSquare) {
    const dvec3 light{0.3, 4, -0.2};
    constexpr double kHeight = 1, kHalf = 0.5;
    const double larger = light.y / (light.y - kHeight); // 4/3
    scene::Scene scene = testing::planeUnderLight(light);
    testing::addObject(scene, scene::makeQuad({2 * kHalf, 2 * kHalf}), testing::translation({0, kHeight, 0}));
    const dvec2 middle = -(larger - 1) * dvec2(light.x, light.z); // (-0.1, 0.0667)
    const double side = 2 * kHalf * larger;
    const testing::PlaneView view{middle, 0.6 * kSize.y / side, kSize};
    const double displaced = displacementPx(scene, view, side * side, 4 * side);
    std::cout << "square of " << side << " m: " << displaced << " px outside\n";
    EXPECT_NEAR(displaced, 0, 0.02);
}

} // namespace
} // namespace shadowlab
