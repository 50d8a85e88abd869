// Shadows whose outline is known in closed form: a sphere over a plane (a conic), a square parallel to it (a square), a
// tilted square (the quadrilateral of its projected corners). The truth must find them.
//
// The camera looks straight down on the plane, and its near plane lies just above it: all casters are cut away, and
// picture and plane are the same up to a scale. The outline is found to a ten-thousandth of a pixel by bisection along
// rays of the picture from the shadow's middle, so no counting of pixels blurs the figures.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "app/judge/truth.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab::judge {
namespace {

using testing::PlaneView;
using trace::Visibility;

constexpr ivec2 kSize{1280, 720};
constexpr int kDirections = 4096;

/// Found and expected outline, compared.
struct Outline {
    double meanPx = 0, largestPx = 0; ///< signed mean, and largest, of found minus expected distance from the middle
    double areaError = 0;             ///< relative
};

/// `radiusPx(direction)`: how far the expected outline is from its middle, in pixels.
Outline compare(scene::Scene scene, const PlaneView& view, const std::function<double(dvec2)>& radiusPx,
                double areaPx) {
    scene.camera = view.camera();
    const auto snapshot = testing::snapshot(scene);
    trace::SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    const trace::EyeRays rays = tracer.eyeRays(snapshot->camera, kSize);
    const dvec2 middle = dvec2(kSize) / 2.0;
    const auto shadowed = [&](dvec2 pixel) {
        return tracer.visibility(tracer.eyePoint(rays, pixel), 0) != Visibility::lit;
    };
    Outline outline;
    double twiceArea = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * M_PI * (i + 0.5) / kDirections;
        const dvec2 direction(std::cos(angle), std::sin(angle));
        const double expected = radiusPx(direction);
        double inside = expected - 2, outside = expected + 2; // two pixels to both sides
        EXPECT_TRUE(shadowed(middle + inside * direction)) << angle;
        EXPECT_FALSE(shadowed(middle + outside * direction)) << angle;
        while (outside - inside > 1e-4) {
            const double half = 0.5 * (inside + outside);
            (shadowed(middle + half * direction) ? inside : outside) = half;
        }
        const double found = 0.5 * (inside + outside);
        outline.meanPx += (found - expected) / kDirections;
        outline.largestPx = std::max(outline.largestPx, std::abs(found - expected));
        twiceArea += found * found * 2 * M_PI / kDirections;
    }
    outline.areaError = 0.5 * twiceArea / areaPx - 1;
    return outline;
}

void expectClose(const Outline& outline, const std::string& what) {
    std::cout << what << ": boundary " << outline.meanPx << " px on average, " << outline.largestPx
              << " px at most; area " << 100 * outline.areaError << " %\n";
    EXPECT_LT(std::abs(outline.meanPx), 0.02) << what;
    EXPECT_LT(outline.largestPx, 0.5) << what; // for meshes of the fineness used here; see each case
    EXPECT_LT(std::abs(outline.areaError), 5e-4) << what;
}

struct SphereCase {
    dvec3 light, centre;
    double radius, a, b; ///< half axes of the ellipse, a along the tilt
    dvec2 middle;        ///< of the ellipse, x and z
};

// With D = C - L, sin alpha = r / |D| and tau the tilt of D against the vertical: a = h sin alpha cos alpha / (cos^2 tau
// - sin^2 alpha), b = h sin alpha / sqrt(cos^2 tau - sin^2 alpha), middle = foot + h sin tau cos tau / (same) along D.
const SphereCase kSpheres[] = {
    {{0, 4, 0}, {0, 1, 0}, 0.5, 0.6761234038, 0.6761234038, {0, 0}},
    {{2, 4, 1}, {0, 1, 0}, 0.5, 0.8475655414, 0.6761234038, {-0.7428571429, -0.3714285714}},
    {{3, 5, 0}, {0, 1, 0}, 1.0, 1.632993162, 1.290994449, {-1, 0}},
    {{0, 5, 0}, {0, 2, 0}, 1.0, 1.767766953, 1.767766953, {0, 0}},
    {{6, 2.1, 0}, {0, 1, 0}, 1.0, 60.17474553, 4.582575695, {-60, 0}},
};

class SphereOverPlane : public ::testing::TestWithParam<int> {}; ///< segments

// A mesh with its vertices on the sphere is a little too small: with N segments by up to r (1 - cos(pi / N)), 7.5e-5 r
// for 256. On a shadow that fills 60 % of the picture's height that is a little more than a hundredth of a pixel. The
// long ellipse's far tip belongs to rays that graze the sphere's top, where a tiny shrinking moves the shadow a lot:
// 1024 segments there.
TEST_P(SphereOverPlane, CastsAConic) {
    if (GetParam() > 256 && !std::getenv("SHADOWLAB_LONG")) GTEST_SKIP() << "takes long; set SHADOWLAB_LONG=1";
    for (const SphereCase& c : kSpheres) {
        const int segments = c.a > 10 ? std::max(1024, GetParam()) : GetParam();
        scene::Scene scene = testing::planeUnderLight(c.light);
        testing::addObject(scene, scene::makeSphere(c.radius, segments), testing::translation(c.centre));
        const PlaneView view{c.middle, std::min(0.45 * kSize.x / c.a, 0.3 * kSize.y / c.b), kSize};
        const dvec2 toLight = dvec2(c.light.x, c.light.z) - c.middle;
        const dvec2 along = glm::length(toLight) > 1e-9 ? glm::normalize(toLight) : dvec2(1, 0);
        const auto radius = [&](dvec2 direction) {
            const double u = glm::dot(direction, along), v = direction.x * along.y - direction.y * along.x;
            return view.pixelsPerMetre / std::sqrt(u * u / (c.a * c.a) + v * v / (c.b * c.b));
        };
        const double area = M_PI * c.a * c.b * view.pixelsPerMetre * view.pixelsPerMetre;
        expectClose(compare(scene, view, radius, area),
                    "sphere of " + std::to_string(segments) + " segments, a = " + std::to_string(c.a));
    }
}
INSTANTIATE_TEST_SUITE_P(Segments, SphereOverPlane, ::testing::Values(256, 1024));

/// Distance from the origin to a convex polygon's outline, along a direction.
double radiusOf(const std::vector<dvec2>& corners, dvec2 direction) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 p = corners[i], edge = corners[(i + 1) % corners.size()] - p;
        const double across = direction.x * edge.y - direction.y * edge.x;
        const double t = (p.x * edge.y - p.y * edge.x) / across, s = (p.x * direction.y - p.y * direction.x) / across;
        if (t > 0 && s >= -1e-12 && s <= 1 + 1e-12) nearest = std::min(nearest, t);
    }
    return nearest;
}

/// Corners in order, projected from the light onto y = 0, against what the truth sees.
Outline comparePolygon(const std::vector<dvec3>& caster, const dvec3& light, double* areaOnPlane = nullptr) {
    std::vector<dvec2> onPlane;
    dvec2 middle(0);
    for (const dvec3& corner : caster) {
        const dvec3 p = light + (corner - light) * (light.y / (light.y - corner.y));
        onPlane.emplace_back(p.x, p.z);
        middle += onPlane.back() / double(caster.size());
    }
    double twiceArea = 0, largest = 0;
    for (std::size_t i = 0; i < onPlane.size(); ++i) {
        const dvec2 p = onPlane[i] - middle, q = onPlane[(i + 1) % onPlane.size()] - middle;
        twiceArea += p.x * q.y - p.y * q.x;
        largest = std::max(largest, glm::length(p));
    }
    if (areaOnPlane) *areaOnPlane = 0.5 * std::abs(twiceArea);
    const PlaneView view{middle, 0.45 * kSize.y / largest, kSize};
    std::vector<dvec2> pixels;
    for (const dvec2& p : onPlane)
        pixels.push_back((p - middle) * view.pixelsPerMetre);
    scene::Scene scene = testing::planeUnderLight(light);
    testing::addObject(scene,
                       testing::triangleSoup({caster[0], caster[1], caster[2], caster[0], caster[2], caster[3]}));
    return compare(
        scene, view, [&](dvec2 direction) { return radiusOf(pixels, direction); },
        0.5 * std::abs(twiceArea) * view.pixelsPerMetre * view.pixelsPerMetre);
}

// At height q under a light at height h, a square is magnified by h / (h - q) and stays a square: 4/3 of 1 m here.
TEST(SquareParallelToPlane, CastsASquare) {
    const std::vector<dvec3> square = {{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}};
    double area = 0;
    const Outline outline = comparePolygon(square, {0.3, 4, -0.2}, &area);
    EXPECT_NEAR(area, 16.0 / 9.0, 1e-12);
    expectClose(outline, "square parallel to the plane");
    EXPECT_LT(outline.largestPx, 1e-3); // straight edges: nothing but the bisection's own width, and float vertices
}

TEST(TiltedSquare, CastsItsHomographicImage) {
    for (const double degrees : {20.0, 55.0, 80.0}) {
        const double a = degrees * M_PI / 180;
        std::vector<dvec3> square;
        for (const dvec2& corner : {dvec2(-0.5, -0.5), dvec2(0.5, -0.5), dvec2(0.5, 0.5), dvec2(-0.5, 0.5)})
            square.emplace_back(corner.x, 1.2 + corner.y * std::sin(a), corner.y * std::cos(a));
        const Outline outline = comparePolygon(square, {0.4, 4, 1.5});
        expectClose(outline, "square tilted by " + std::to_string(int(degrees)) + " degrees");
        EXPECT_LT(outline.largestPx, 5e-3); // where the outline runs along the direction, its distance is ill-defined
    }
}

// The same by counting pixels, as `measure` sees a shadow. Counting a smooth outline of a length of 2000 px errs by about
// a third of a pixel for each independent crossing, sqrt(2000) / 3 = 15 px: 0.006 % of this area.
TEST(SphereOverPlaneByPixels, HasTheAreaOfTheEllipse) {
    const SphereCase& c = kSpheres[1];
    scene::Scene scene = testing::planeUnderLight(c.light);
    testing::addObject(scene, scene::makeSphere(c.radius, 512), testing::translation(c.centre));
    const PlaneView view{c.middle, 0.45 * kSize.y / c.b, kSize};
    scene.camera = view.camera();
    const auto snapshot = testing::snapshot(scene);
    trace::SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    const Truth truth = exactTruth(tracer, scene.camera, kSize, 0, {1.0 / 64, {}});
    const auto dark = static_cast<double>(std::ranges::count(truth.visibility, Visibility::shadowed));
    const double area = M_PI * c.a * c.b * view.pixelsPerMetre * view.pixelsPerMetre;
    std::cout << "sphere by pixels: " << dark << " of " << area << " px, " << 100 * (dark / area - 1) << " %\n";
    EXPECT_GT(dark, 100'000);
    EXPECT_LT(std::abs(dark / area - 1), 5e-4);
    // A tie is a pixel whose centre lies within 1/64 px of the outline: 2/64 of a pixel for each pixel of its length.
    const double h = (c.a - c.b) * (c.a - c.b) / ((c.a + c.b) * (c.a + c.b));
    const double length = M_PI * (c.a + c.b) * (1 + h / 4) * view.pixelsPerMetre; // Ramanujan's series, two terms
    const auto ties = static_cast<double>(std::ranges::count(truth.ties, 1));
    EXPECT_NEAR(ties, length / 32, 4 * std::sqrt(length / 32)); // a count of rare things scatters by its root
}

} // namespace
} // namespace shadowlab::judge
