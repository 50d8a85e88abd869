// Coverage of pixels by shadows: straight edges whose areas are known in closed form, one point against the truth at centres, an
// independent count of points, and what is compared with it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <stdexcept>

#include "app/judge/coverage.h"
#include "app/judge/coverage_errors.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/foundation/trace/parallel.h"
#include "tests/support/area_lights.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab::judge {
namespace {

using testing::PlaneView, testing::tracerOf;
using trace::Visibility;

/// The area of the part of a unit square, from `corner`, where normal . p >= level: the square is cut by the line (Sutherland and
/// Hodgman) and measured by the shoelace formula.
double areaBeyond(dvec2 corner, dvec2 normal, double level) {
    const std::vector<dvec2> square{corner, corner + dvec2(1, 0), corner + dvec2(1, 1), corner + dvec2(0, 1)};
    std::vector<dvec2> kept;
    for (std::size_t i = 0; i < square.size(); ++i) {
        const dvec2 p = square[i], q = square[(i + 1) % square.size()];
        const double atP = glm::dot(normal, p) - level, atQ = glm::dot(normal, q) - level;
        if (atP >= 0) kept.push_back(p);
        if (atP * atQ < 0) kept.push_back(p + atP / (atP - atQ) * (q - p));
    }
    double twice = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const dvec2 p = kept[i], q = kept[(i + 1) % kept.size()];
        twice += p.x * q.y - p.y * q.x;
    }
    return 0.5 * std::abs(twice);
}

constexpr ivec2 kPlaneSize{48, 40};

/// A floor, seen from above, half of which is in the shadow of a plate with one straight edge. In pixels the shadow is where
/// normal . p >= level.
struct HalfShadow {
    scene::Scene scene;
    dvec2 normal;
    double level;
};

HalfShadow halfShadow(double degrees, double levelPx) {
    const PlaneView view{{0, 0}, 20, kPlaneSize};
    HalfShadow half{testing::planeUnderLight({0, 4, 0}), {}, 0};
    half.scene.camera = view.camera();
    const double angle = degrees * M_PI / 180;
    half.normal = {std::cos(angle), std::sin(angle)};
    half.level = glm::dot(half.normal, dvec2(kPlaneSize) / 2.0) + levelPx;
    // The lamp is 4 m above the floor and the plate 2 m: its shadow is twice as large.
    const double edge = levelPx / view.pixelsPerMetre / 2;
    const dvec2 along(-half.normal.y, half.normal.x);
    const auto corner = [&](double across, double length) {
        const dvec2 place = (edge + across) * half.normal + length * along;
        return dvec3(place.x, 2, place.y);
    };
    const dvec3 a = corner(0, -8), b = corner(8, -8), c = corner(8, 8), d = corner(0, 8);
    testing::addObject(half.scene, testing::triangleSoup({a, b, c, a, c, d}));
    return half;
}

/// What a technique says that is right at each sample: 0 or 255, and a surface everywhere.
std::vector<std::uint8_t> binaryAnswers(const Truth& truth) {
    std::vector<std::uint8_t> greyAlpha;
    for (const Visibility visibility : truth.visibility) {
        greyAlpha.push_back(visibility == Visibility::lit ? 255 : 0);
        greyAlpha.push_back(255);
    }
    return greyAlpha;
}

CoverageErrors errorsOfBinary(const scene::Snapshot& snapshot, ivec2 size, int points, int samples) {
    const trace::SceneTracer tracer = tracerOf(snapshot);
    const ivec2 larger = samples * size;
    const Truth truth = truthAtCentres(tracer, snapshot->camera, larger, 0);
    const PixelAnswers answers =
        meansOfSamples(binaryAnswers(truth), facingCentres(tracer, snapshot->camera, larger, 0), size, samples);
    const Coverage coverage = trueCoverage(tracer, snapshot->camera, size, 0, points, TruthOf::centre);
    return coverageErrors(coverage, answers, std::vector<std::uint8_t>(coverage.shares.size(), 0), samples);
}

TEST(SubpixelPoints, HaveOneInEachRowAndColumn) {
    for (int count = 1; count <= kMostSubpixelPoints; ++count) {
        const std::vector<dvec2> points = subpixelPoints(count);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
        std::set<int> columns, rows;
        for (const dvec2& point : points) {
            columns.insert(static_cast<int>(std::floor(point.x * count)));
            rows.insert(static_cast<int>(std::floor(point.y * count)));
            ASSERT_NEAR(point.x * count - std::floor(point.x * count), 0.5, 1e-9); // the middle of its cell, rounded
            ASSERT_NEAR(point.y * count - std::floor(point.y * count), 0.5, 1e-9);
        }
        ASSERT_EQ(columns.size(), points.size()) << count;
        ASSERT_EQ(rows.size(), points.size()) << count;
        ASSERT_GE(std::min(*columns.begin(), *rows.begin()), 0);
        ASSERT_LT(std::max(*columns.rbegin(), *rows.rbegin()), count);
    }
    EXPECT_EQ(subpixelPoints(1).front(), dvec2(0.5));
    const std::vector<dvec2> four =
        subpixelPoints(4); // Hammersley's: 0, 1/2, 1/4, 3/4, each in the middle of a quarter
    const std::array<double, 4> rows{0.125, 0.625, 0.375, 0.875};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(four[i], dvec2(0.125 + 0.25 * static_cast<double>(i), rows[i]));
}

// Lines at all slopes and distances from the middle; the bounds are those found for these very lines, rounded up.
TEST(SubpixelPoints, MeasureTheAreaBesideALine) {
    struct Bound {
        int count;
        double rms, most;
    };
    for (const auto& [count, rms, most] :
         {Bound{16, 0.039, 0.13}, Bound{32, 0.024, 0.11}, Bound{64, 0.014, 0.065}, Bound{256, 0.005, 0.032}}) {
        const std::vector<dvec2> points = subpixelPoints(count);
        double squares = 0, largest = 0;
        int lines = 0;
        for (int slope = 0; slope < 720; ++slope)
            for (int step = 0; step < 101; ++step, ++lines) {
                const double angle = 2 * M_PI * slope / 720;
                const dvec2 normal(std::cos(angle), std::sin(angle));
                const double level = glm::dot(normal, dvec2(0.5)) + 0.7 * (step - 50) / 50;
                const auto beyond =
                    std::ranges::count_if(points, [&](dvec2 p) { return glm::dot(normal, p) >= level; });
                const double error = std::abs(static_cast<double>(beyond) / count - areaBeyond({0, 0}, normal, level));
                squares += error * error;
                largest = std::max(largest, error);
            }
        std::cout << count << " points: " << std::sqrt(squares / lines) << " RMS, " << largest << " at most\n";
        EXPECT_LT(std::sqrt(squares / lines), rms) << count;
        EXPECT_LT(largest, most) << count;
    }
}

TEST(Coverage, OfHalfPlanesIsTheirArea) {
    int crossed = 0;
    for (const double degrees : {0.0, 90.0, 45.0, 17.0, 63.5, 151.0, 200.0, 289.0}) {
        const HalfShadow half = halfShadow(degrees, 3.3);
        const scene::Snapshot snapshot = testing::snapshot(half.scene);
        const trace::SceneTracer tracer = tracerOf(snapshot);
        for (const int points : {32, 256}) {
            const Coverage coverage = trueCoverage(tracer, snapshot->camera, kPlaneSize, 0, points, TruthOf::centre);
            // As above; an upright or level line errs by half a point at most. 1e-6 is for the rounding of vertices to float.
            const double bound = std::fmod(degrees, 90) == 0 ? 0.5 / points + 1e-6 : points == 32 ? 0.11 : 0.032;
            for (int y = 0; y < kPlaneSize.y; ++y)
                for (int x = 0; x < kPlaneSize.x; ++x) {
                    const std::size_t i = static_cast<std::size_t>(y * kPlaneSize.x + x);
                    const double lit = 1 - areaBeyond({x, y}, half.normal, half.level);
                    ASSERT_NEAR(coverage.shares[i], lit, bound) << degrees << ", " << points << ": " << x << ", " << y;
                    if (lit < 0.12 || lit > 0.88) continue; // there all points may lie on one side
                    ++crossed;
                    ASSERT_EQ(coverage.kinds[i], PixelKind::edge);
                }
        }
    }
    EXPECT_GT(crossed, 500);
}

// An upright edge leaves the share f of each pixel that it crosses lit. An answer of 0 or 1 by the centre is then wrong by
// min(f, 1 - f) in each of them, and one of two columns of samples by 1/2 - f or so.
TEST(Coverage, ErrorOfABinaryTechniqueIsKnown) {
    for (const int tenths : {1, 2, 3, 4, 6, 7, 8, 9}) {
        const double f = tenths / 10.0;
        const HalfShadow half = halfShadow(0, 5 + f);
        const scene::Snapshot snapshot = testing::snapshot(half.scene);
        const double tolerance = 0.5 / 256 + 1e-6; // of the share from 256 points, and of vertices rounded to float
        const CoverageErrors one = errorsOfBinary(snapshot, kPlaneSize, 256, 1);
        EXPECT_EQ(one.edge.pixels, kPlaneSize.y);
        EXPECT_EQ(one.all.pixels, kPlaneSize.x * kPlaneSize.y);
        EXPECT_EQ(one.outline.pixels, 0);
        EXPECT_NEAR(one.edge.rmse, std::min(f, 1 - f), tolerance) << f;
        EXPECT_NEAR(one.edge.mean, std::min(f, 1 - f), tolerance) << f;
        EXPECT_NEAR(one.edge.largest, std::min(f, 1 - f), tolerance) << f;
        EXPECT_NEAR(one.all.rmse, one.edge.rmse / std::sqrt(kPlaneSize.x), 1e-9); // one pixel of each row is wrong
        EXPECT_NEAR(one.all.mean, one.edge.mean / kPlaneSize.x, 1e-9);
        const CoverageErrors four = errorsOfBinary(snapshot, kPlaneSize, 256, 4); // columns at 1/8, 3/8, 5/8, 7/8
        const double nearest = std::round(4 * f) / 4;
        EXPECT_NEAR(four.edge.rmse, std::abs(f - nearest), tolerance) << f;
    }
}

// A column is crossed in 16 rows, so pixels are left lit by all shares.
TEST(Coverage, ErrorAlongASlopingEdgeIsThatOfItsAreas) {
    const HalfShadow half = halfShadow(std::atan(1 / 16.0) * 180 / M_PI, 0.01);
    const CoverageErrors errors = errorsOfBinary(testing::snapshot(half.scene), kPlaneSize, 256, 1);
    double squares = 0, sum = 0;
    int crossed = 0, clearly = 0;
    for (int y = 0; y < kPlaneSize.y; ++y)
        for (int x = 0; x < kPlaneSize.x; ++x) {
            const double lit = 1 - areaBeyond({x, y}, half.normal, half.level);
            const bool centreLit = glm::dot(half.normal, dvec2(x + 0.5, y + 0.5)) < half.level;
            const double error = std::abs((centreLit ? 1 : 0) - lit);
            squares += error * error, sum += error;
            crossed += lit > 0 && lit < 1;
            clearly += lit > 0.02 && lit < 0.98;
        }
    ASSERT_GT(clearly, 35);
    EXPECT_GE(errors.edge.pixels, clearly);
    EXPECT_LE(errors.edge.pixels, crossed);
    // Means of 40 shares, each of which is wrong by 0.005 (one standard deviation, as above).
    EXPECT_NEAR(errors.edge.mean, sum / errors.edge.pixels, 0.003);
    EXPECT_NEAR(errors.edge.rmse, std::sqrt(squares / errors.edge.pixels), 0.003);
}

TEST(Coverage, OfOnePointIsTheTruthAtTheCentre) {
    constexpr ivec2 kSize{96, 72};
    int lit = 0, dark = 0, between = 0;
    scene::Scene area = testing::everyKindOfLight();
    area.lights = {testing::rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5})};
    for (const auto& [made, of] :
         {std::pair(testing::everyKindOfLight(), TruthOf::centre), std::pair(area, TruthOf::area)}) {
        const scene::Snapshot snapshot = testing::snapshot(made);
        const trace::SceneTracer tracer = tracerOf(snapshot);
        for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light) {
            const Truth truth = truthAtCentres(tracer, snapshot->camera, kSize, light, {}, of);
            const Coverage coverage = trueCoverage(tracer, snapshot->camera, kSize, light, 1, of);
            const std::vector<std::uint8_t> facing = facingCentres(tracer, snapshot->camera, kSize, light);
            for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
                const bool isLit = truth.visibility[i] == Visibility::lit,
                           isDark = truth.visibility[i] == Visibility::shadowed;
                ASSERT_EQ(coverage.kinds[i], isLit || isDark ? PixelKind::whole : PixelKind::none);
                ASSERT_EQ(facing[i] != 0, isLit || isDark);
                lit += isLit, dark += isDark;
                if (!isLit && !isDark) continue;
                ASSERT_NEAR(coverage.shares[i], truth.share(i),
                            1e-6); // float; areas depend on which points are asked together
                between += coverage.shares[i] > 0.01f && coverage.shares[i] < 0.99f;
            }
        }
    }
    EXPECT_GT(lit, 5000);
    EXPECT_GT(dark, 500);
    EXPECT_GT(between, 100);
}

// Point by point with the judge that tries every triangle. It shares no code with the tracer.
TEST(Coverage, IsTheShareOfPointsThatAnotherJudgeCounts) {
    constexpr ivec2 kSize{48, 36};
    constexpr int kPoints = 7;
    const scene::Snapshot snapshot = testing::snapshot(testing::everyKindOfLight());
    const trace::SceneTracer tracer = tracerOf(snapshot);
    const trace::ExactVisibility judge(snapshot);
    const std::vector<dvec2> within = subpixelPoints(kPoints);
    std::array<int, 4> kinds{};
    for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light) {
        const Coverage coverage = trueCoverage(tracer, snapshot->camera, kSize, light, kPoints, TruthOf::centre);
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                int lit = 0, dark = 0;
                std::set<std::uint32_t> objects;
                for (const dvec2& point : within) {
                    const auto hit = judge.eyeHit(snapshot->camera, dvec2(x, y) + point, kSize);
                    if (!hit) continue;
                    const Visibility visibility = judge.visibility(*hit, snapshot->camera, light);
                    if (visibility == Visibility::turnedAway) continue;
                    objects.insert(hit->object);
                    ++(visibility == Visibility::lit ? lit : dark);
                }
                const std::size_t i = static_cast<std::size_t>(y * kSize.x + x);
                const PixelKind expected = lit + dark == 0                              ? PixelKind::none
                                           : lit + dark < kPoints || objects.size() > 1 ? PixelKind::outline
                                           : lit > 0 && dark > 0                        ? PixelKind::edge
                                                                                        : PixelKind::whole;
                ASSERT_EQ(coverage.kinds[i], expected) << light << ": " << x << ", " << y;
                ASSERT_FLOAT_EQ(coverage.shares[i],
                                lit + dark == 0 ? 0.0f : static_cast<float>(lit) / static_cast<float>(lit + dark));
                ++kinds[static_cast<std::size_t>(expected)];
            }
    }
    for (const int count : kinds)
        EXPECT_GT(count, 50);
}

TEST(Coverage, TheSameForAnyNumberOfThreads) {
    constexpr ivec2 kSize{61, 45};
    const scene::Snapshot snapshot = testing::snapshot(testing::everyKindOfLight());
    const trace::SceneTracer tracer = tracerOf(snapshot);
    std::vector<Coverage> made;
    for (const char* threads : {"1", "3"}) {
        setenv("SHADOWLAB_THREADS", threads, 1);
        made.push_back(trueCoverage(tracer, snapshot->camera, kSize, 0, 16, TruthOf::centre));
        unsetenv("SHADOWLAB_THREADS");
    }
    EXPECT_EQ(made[0].shares, made[1].shares);
    EXPECT_EQ(made[0].kinds, made[1].kinds);
    EXPECT_GT(std::ranges::count(made[0].kinds, PixelKind::edge), 10);
}

TEST(Coverage, StopsOnRequest) {
    const scene::Snapshot snapshot = testing::snapshot(testing::everyKindOfLight());
    const trace::SceneTracer tracer = tracerOf(snapshot);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(trueCoverage(tracer, snapshot->camera, {64, 48}, 0, 16, TruthOf::centre, stop.get_token()),
                 trace::Stopped);
}

TEST(CoverageErrors, LeavesOutWhatSaysNothing) {
    // One row: lit, an edge, turned away, an outline whose centre is turned away, a tie that all points agree on, an edge at a tie.
    const Coverage coverage{
        {6, 1},
        4,
        {1.0f, 0.5f, 0.0f, 0.75f, 1.0f, 0.25f},
        {PixelKind::whole, PixelKind::edge, PixelKind::none, PixelKind::outline, PixelKind::whole, PixelKind::edge}};
    const std::vector<std::uint8_t> ties{0, 0, 0, 0, 1, 1};
    const std::vector<std::uint8_t> greyAlpha{255, 255, 0, 255, 255, 255, 0, 255, 0, 255, 255, 255};
    const std::vector<std::uint8_t> facing{1, 1, 0, 0, 1, 1};
    const CoverageErrors errors = coverageErrors(coverage, meansOfSamples(greyAlpha, facing, {6, 1}, 1), ties, 1);
    EXPECT_EQ(errors.all.pixels, 3);
    EXPECT_EQ(errors.edge.pixels, 2);
    EXPECT_EQ(errors.outline.pixels, 0);
    EXPECT_DOUBLE_EQ(errors.edge.mean, (0.5 + 0.75) / 2);
    EXPECT_DOUBLE_EQ(errors.edge.rmse, std::sqrt((0.25 + 0.5625) / 2));
    EXPECT_DOUBLE_EQ(errors.all.largest, 0.75);
    EXPECT_DOUBLE_EQ(errors.all.mean, (0 + 0.5 + 0.75) / 3);
}

TEST(CoverageErrors, MeansAreOfSamplesThatFaceTheLight) {
    // Two pixels of 2 x 2 samples.
    const std::vector<std::uint8_t> grey{255, 0, 51, 51, 255, 0, 51, 51};
    std::vector<std::uint8_t> greyAlpha;
    for (const std::uint8_t value : grey)
        greyAlpha.insert(greyAlpha.end(), {value, 255});
    const PixelAnswers answers =
        meansOfSamples(greyAlpha, std::vector<std::uint8_t>{1, 1, 0, 0, 1, 0, 0, 0}, {2, 1}, 2);
    EXPECT_FLOAT_EQ(answers.visibility[0], 2.0f / 3.0f); // 255, 0 and 255
    EXPECT_EQ(answers.answered, (std::vector<std::uint8_t>{1, 0}));
    EXPECT_THROW(meansOfSamples(greyAlpha, std::vector<std::uint8_t>(8, 1), {2, 1}, 1), std::logic_error);
}

} // namespace
} // namespace shadowlab::judge
