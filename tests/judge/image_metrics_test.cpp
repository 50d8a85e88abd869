// PSNR and SSIM where their values follow by hand, and SSIM against its definition written out.
// SPDX-License-Identifier: MIT
#include "app/judge/metrics/image_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace shadowlab::judge {
namespace {

image::Image grey(int width, int height, const std::function<int(int, int)>& value) {
    image::Image picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto v = static_cast<std::uint8_t>(value(x, y));
            picture.set(x, y, {v, v, v, 255});
        }
    return picture;
}
image::Image noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    return grey(width, height, [&](int x, int y) { return int(random() % 64) + 2 * ((x * 7 + y * 3) % 90); });
}

TEST(Psnr, OfAConstantDifferenceIsItsLogarithm) {
    const std::vector<float> zero(30, 0.0f), tenth(30, 0.1f), one(30, 1.0f);
    EXPECT_NEAR(psnr(zero, tenth), 20, 1e-6); // 0.1f is not quite a tenth
    EXPECT_NEAR(psnr(zero, one), 0, 1e-12);
    EXPECT_TRUE(std::isinf(psnr(tenth, tenth)));
    std::vector<float> oneOfFour(8, 0.5f), half(8, 0.5f);
    oneOfFour[0] = oneOfFour[4] = 0.75f; // a quarter of the numbers differ by 1/4: the mean square is 1/64
    EXPECT_NEAR(psnr(half, oneOfFour), 10 * std::log10(64.0), 1e-12);
}

TEST(Ssim, OfEqualPicturesIsOne) { EXPECT_DOUBLE_EQ(ssim(noise(40, 30, 1), noise(40, 30, 1)), 1.0); }

TEST(Ssim, OfFlatPicturesIsTheirLuminanceTerm) {
    const auto flat = [](int v) { return grey(32, 32, [=](int, int) { return v; }); };
    const double c1 = 0.01 * 255 * 0.01 * 255;
    for (const auto& [p, q] : {std::pair{0, 255}, {100, 120}, {30, 30}})
        EXPECT_NEAR(ssim(flat(p), flat(q)), (2.0 * p * q + c1) / (double(p) * p + double(q) * q + c1), 1e-9);
}

TEST(Ssim, IsSymmetricAndFallsWithContrast) {
    const image::Image a = noise(50, 40, 1);
    const auto contrast = [&](double share) {
        return grey(50, 40, [&](int x, int y) { return int(128 + share * (a.at(x, y).r - 128)); });
    };
    EXPECT_DOUBLE_EQ(ssim(a, noise(50, 40, 2)), ssim(noise(50, 40, 2), a));
    const double full = ssim(a, contrast(1.0)), half = ssim(a, contrast(0.5)), tenth = ssim(a, contrast(0.1));
    EXPECT_GT(full, half);
    EXPECT_GT(half, tenth);
    EXPECT_LT(ssim(a, contrast(-1.0)), 0) << "an inverted structure counts below zero";
}

/// The definition, one window after the other, with all 121 weights.
double plainSsim(const image::Image& a, const image::Image& b) {
    const auto luma = [](const image::Color8& c) { return 0.299 * c.r + 0.587 * c.g + 0.114 * c.b; };
    double sum = 0, total = 0;
    int windows = 0;
    double weights[11][11];
    for (int j = 0; j < 11; ++j)
        for (int i = 0; i < 11; ++i)
            total += weights[j][i] = std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / (2 * 1.5 * 1.5));
    for (int y = 0; y + 11 <= a.height; ++y)
        for (int x = 0; x + 11 <= a.width; ++x, ++windows) {
            const auto mean = [&](const std::function<double(double, double)>& f) {
                double m = 0;
                for (int j = 0; j < 11; ++j)
                    for (int i = 0; i < 11; ++i)
                        m += weights[j][i] / total * f(luma(a.at(x + i, y + j)), luma(b.at(x + i, y + j)));
                return m;
            };
            const double ma = mean([](double p, double) { return p; }), mb = mean([](double, double q) { return q; });
            const double va = mean([&](double p, double) { return (p - ma) * (p - ma); });
            const double vb = mean([&](double, double q) { return (q - mb) * (q - mb); });
            const double cov = mean([&](double p, double q) { return (p - ma) * (q - mb); });
            sum += (2 * ma * mb + 6.5025) / (ma * ma + mb * mb + 6.5025) * (2 * cov + 58.5225) / (va + vb + 58.5225);
        }
    return sum / windows;
}

TEST(Ssim, IsItsDefinition) {
    const image::Image a = noise(37, 29, 3), b = noise(37, 29, 4);
    EXPECT_NEAR(ssim(a, b), plainSsim(a, b), 1e-9); // sums in another order
}

TEST(Ssim, OfPicturesSmallerThanAWindow) {
    EXPECT_DOUBLE_EQ(ssim(noise(3, 40, 1), noise(3, 40, 1)), 1.0);
    EXPECT_LT(ssim(noise(1, 1, 1), grey(1, 1, [](int, int) { return 255; })), 1.0);
}

} // namespace
} // namespace shadowlab::judge
