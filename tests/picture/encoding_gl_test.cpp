// The last step of every picture, exposure and encoding, held against the definition of sRGB (IEC 61966-2-1).
// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "app/picture/picture.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

/// Levels of 255, not rounded.
double encoded(double linear) {
    return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

class Encoding : public testing::GlTest {};

TEST_F(Encoding, IsThatOfTheStandardAtEveryBrightness) {
    constexpr int kSide = 512; // 262,144 radiances from 0 to 1.1, half of them in the darkest tenth
    std::vector<vec4> radiances;
    for (int i = 0; i < kSide * kSide; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(kSide * kSide - 1);
        radiances.emplace_back(1.1f * std::pow(share, 3.3f));
    }
    const gl::Texture2D texture(GL_RGBA32F, {kSide, kSide}, "radiances");
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, radiances.data());
    const image::Image image = picture::PictureEncoder().encode(texture, 1.0f);
    int dark = 0, bright = 0, held = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double linear = std::min(1.0, double{radiances[static_cast<std::size_t>((kSide - 1 - y) * kSide + x)].r});
            const image::Color8 color = image.at(x, y);
            // Half a level for rounding, a 20th for the polynomial (shaders/srgb.glsl), a 100th for the arithmetic of floats.
            ASSERT_NEAR(color.r, encoded(linear), 0.56) << linear;
            ASSERT_EQ(color.r, color.g);
            ASSERT_EQ(color.r, color.b);
            dark += linear <= 0.0031308;
            bright += linear > 0.0031308 && linear < 1;
            held += linear == 1;
        }
    EXPECT_GT(dark, 30'000);
    EXPECT_GT(bright, 150'000);
    EXPECT_GT(held, 5'000) << "brighter than white";
}

} // namespace
} // namespace shadowlab
