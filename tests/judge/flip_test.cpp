// FLIP against published values of its parts, against values that follow by hand for flat pictures, and against the
// paper's formulas written out in double: kernels in two dimensions, no separation, no sharing.
// SPDX-License-Identifier: MIT
#include "app/judge/metrics/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "app/judge/metrics/opponent_colors.h"

namespace shadowlab::judge {
namespace {

using image::Color8;
using Paint = std::function<Color8(int, int)>;

image::Image painted(int width, int height, const Paint& paint) {
    image::Image picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.set(x, y, paint(x, y));
    return picture;
}
image::Image flat(Color8 color) {
    return painted(24, 24, [=](int, int) { return color; });
}

void expectNear(const vec3& value, const vec3& expected, float tolerance) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(value[i], expected[i], tolerance) << i;
}

// L*a*b* of sRGB's primaries for D65, as colour science tables list them to four digits.
TEST(OpponentColors, LabOfThePrimaries) {
    expectNear(labFromLinear({1, 1, 1}), {100, 0, 0}, 1e-3f);
    expectNear(labFromLinear({1, 0, 0}), {53.2408f, 80.0925f, 67.2032f}, 0.02f); // white in the tables has five digits
    expectNear(labFromLinear({0, 1, 0}), {87.7347f, -86.1827f, 83.1793f}, 0.02f);
    expectNear(labFromLinear({0, 0, 1}), {32.2970f, 79.1875f, -107.8602f}, 0.02f);
    expectNear(labFromLinear({0, 0, 0}), {0, 0, 0}, 1e-4f);
}

TEST(OpponentColors, YcxczAndBack) {
    expectNear(ycxczFromLinear({1, 1, 1}), {100, 0, 0}, 1e-3f);
    expectNear(ycxczFromLinear({0, 0, 0}), {-16, 0, 0}, 1e-5f);
    for (const vec3& color : {vec3(0.2f, 0.7f, 0.1f), vec3(1, 0, 0), vec3(0, 0, 1)})
        expectNear(linearFromYcxcz(ycxczFromLinear(color)), color, 1e-5f);
}

TEST(Flip, OfEqualPicturesIsZero) {
    std::mt19937 random(1);
    const auto noise = painted(40, 30, [&](int, int) {
        return Color8{std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()), 255};
    });
    EXPECT_EQ(flip(noise, noise).mean, 0);
}

// Flat pictures have no features, and blur does nothing to them: what is left is the spread difference of two colours.
TEST(Flip, OfFlatPicturesFollowsByHand) {
    const auto redistributed = [](double hyabDifference) {
        // Green against blue: Lab (87.7347, -86.1827, 83.1793) and (32.2970, 79.1875, -107.8602), a and b times L / 100.
        const double aG = 0.877347 * -86.1827, bG = 0.877347 * 83.1793, aB = 0.32297 * 79.1875,
                     bB = 0.32297 * -107.8602;
        const double largest = std::pow(87.7347 - 32.2970 + std::hypot(aG - aB, bG - bB), 0.7);
        const double raised = std::pow(hyabDifference, 0.7), knee = 0.4 * largest;
        return raised < knee ? 0.95 * raised / knee : 0.95 + 0.05 * (raised - knee) / (largest - knee);
    };
    // The mean of equal pixels is exact but for sums in float; the table's digits leave about 1e-4.
    EXPECT_NEAR(flip(flat({0, 0, 0, 255}), flat({255, 255, 255, 255})).mean, redistributed(100), 2e-4);
    EXPECT_NEAR(flip(flat({0, 255, 0, 255}), flat({0, 0, 255, 255})).mean, 1, 1e-5);
    EXPECT_NEAR(flip(flat({0, 0, 0, 255}), flat({0, 0, 255, 255})).mean,
                redistributed(32.2970 + 0.32297 * std::hypot(79.1875, -107.8602)), 2e-4);
    // Grey 119 has L* = 50.03 (sRGB 119 is linear 0.1845): below the knee.
    const double l119 = 116 * std::cbrt(0.184475) - 16;
    EXPECT_NEAR(flip(flat({0, 0, 0, 255}), flat({119, 119, 119, 255})).mean, redistributed(l119), 2e-4);
}

/// The paper, step by step, in double.
class Plain {
public:
    explicit Plain(double pixelsPerDegree) : ppd_(pixelsPerDegree) {}

    double mean(const image::Image& a, const image::Image& b) const {
        double sum = 0;
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                const double color = spread(difference(seen(a, x, y), seen(b, x, y)));
                const double edges = std::abs(feature(a, x, y, true) - feature(b, x, y, true));
                const double points = std::abs(feature(a, x, y, false) - feature(b, x, y, false));
                sum += std::pow(color, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0)));
            }
        return sum / (a.width * a.height);
    }

private:
    static vec3 linear(const image::Image& image, int x, int y) {
        const Color8 c = image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
        return {image::linearFromSrgb(c.r), image::linearFromSrgb(c.g), image::linearFromSrgb(c.b)};
    }
    double sensitivity(int channel, double squared) const { // at a squared distance in degrees
        const double a1[] = {1, 1, 34.1}, b1[] = {0.0047, 0.0053, 0.04}, a2[] = {0, 0, 13.5},
                     b2[] = {1e-5, 1e-5, 0.025};
        const auto one = [&](double a, double b) {
            return a * std::sqrt(M_PI / b) * std::exp(-M_PI * M_PI * squared / b);
        };
        return one(a1[channel], b1[channel]) + one(a2[channel], b2[channel]);
    }
    dvec3 seen(const image::Image& image, int x, int y) const {
        const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * M_PI * M_PI)) * ppd_));
        dvec3 blurred(0), weights(0);
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i) {
                const vec3 ycxcz = ycxczFromLinear(linear(image, x + i, y + j));
                for (int channel = 0; channel < 3; ++channel) {
                    const double weight = sensitivity(channel, (i * i + j * j) / (ppd_ * ppd_));
                    blurred[channel] += weight * double(ycxcz[channel]);
                    weights[channel] += weight;
                }
            }
        const vec3 rgb = glm::clamp(linearFromYcxcz(vec3(blurred / weights)), 0.0f, 1.0f);
        const vec3 lab = labFromLinear(rgb);
        return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
    }
    static double difference(const dvec3& p, const dvec3& q) {
        return std::abs(p.x - q.x) + std::sqrt((p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
    }
    static double spread(double d) {
        const auto adjusted = [](const vec3& rgb) {
            const vec3 lab = labFromLinear(rgb);
            return dvec3(lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z);
        };
        const double largest = std::pow(difference(adjusted({0, 1, 0}), adjusted({0, 0, 1})), 0.7);
        const double raised = std::pow(d, 0.7);
        if (raised < 0.4 * largest) return 0.95 / (0.4 * largest) * raised;
        return 0.95 + (raised - 0.4 * largest) / (largest - 0.4 * largest) * 0.05;
    }
    double feature(const image::Image& image, int x, int y, bool edges) const {
        const double deviation = 0.5 * 0.082 * ppd_;
        const int radius = int(std::ceil(3 * deviation));
        const auto kernel = [&](int i, int j) {
            const double g = std::exp(-(i * i + j * j) / (2 * deviation * deviation));
            return edges ? -i * g : (i * i / (deviation * deviation) - 1) * g;
        };
        double positive = 0, negative = 0;
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i)
                (kernel(i, j) > 0 ? positive : negative) += std::abs(kernel(i, j));
        double alongX = 0, alongY = 0;
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i) {
                const double light = (ycxczFromLinear(linear(image, x + i, y + j)).x + 16.0) / 116.0;
                const double p = kernel(i, j), q = kernel(j, i);
                alongX += light * p / (p > 0 ? positive : negative);
                alongY += light * q / (q > 0 ? positive : negative);
            }
        return std::sqrt(alongX * alongX + alongY * alongY);
    }
    double ppd_;
};

TEST(Flip, IsThePapersFormulas) {
    std::mt19937 random(7);
    const auto colors = painted(36, 28, [&](int x, int y) {
        return Color8{std::uint8_t(40 + 5 * x), std::uint8_t(random() % 256), std::uint8_t(9 * y), 255};
    });
    const auto disc = [](double radius) {
        return painted(36, 28, [=](int x, int y) {
            return std::hypot(x - 18, y - 14) < radius ? Color8{200, 90, 30, 255} : Color8{60, 80, 120, 255};
        });
    };
    const auto shifted = painted(36, 28, [&](int x, int y) { return colors.at(std::max(x - 1, 0), y); });
    for (const double ppd : {kPixelsPerDegree, 25.0}) {
        const Plain plain(ppd);
        // Float against double: 1e-4 of values around 0.1 to 0.5.
        EXPECT_NEAR(flip(colors, shifted, ppd).mean, plain.mean(colors, shifted), 1e-4);
        EXPECT_NEAR(flip(disc(9), disc(7), ppd).mean, plain.mean(disc(9), disc(7)), 1e-4);
        EXPECT_GT(flip(disc(9), disc(7), ppd).mean, 0.05);
    }
}

TEST(Flip, IsSymmetricAndSeesOnlyWhereThereIsADifference) {
    const auto dot = painted(120, 90, [](int x, int y) {
        return x >= 20 && x < 24 && y >= 40 && y < 44 ? Color8{255, 255, 255, 255} : Color8{128, 128, 128, 255};
    });
    const auto grey = painted(120, 90, [](int, int) { return Color8{128, 128, 128, 255}; });
    const Flip there = flip(dot, grey), back = flip(grey, dot);
    EXPECT_EQ(there.map.values, back.map.values);
    EXPECT_GT(there.map.at(22, 42), 0.3f);
    EXPECT_LT(there.map.at(100, 42), 1e-3f);
}

} // namespace
} // namespace shadowlab::judge
