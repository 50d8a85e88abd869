// JPEG files: what is read of them, and what is refused.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/jpeg/jpeg.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/picture_file.h"

namespace shadowlab::image {
namespace {

/// 16 x 8 pixels, the left half red and the right half green, as another program has written it.
const std::string kRedAndGreen =
    "ffd8ffe000104a46494600010100000100010000ffdb0043000302020302020303030304030304050805050404050a070706080c0a0c0c0b0a0b0b0d"
    "0e12100d0e110e0b0b1016101113141515150c0f171816141812141514ffdb00430103040405040509050509140d0b0d141414141414141414141414"
    "1414141414141414141414141414141414141414141414141414141414141414141414141414ffc00011080008001003011100021101031101ffc400"
    "14000100000000000000000000000000000008ffc40014100100000000000000000000000000000000ffc40016010101010000000000000000000000"
    "000007090affc40014110100000000000000000000000000000000ffda000c03010002110311003f003a03154cc609331effd9";
/// 8 x 8 pixels in the four inks of printing.
const std::string kInks =
    "ffd8ffee000e41646f626500640000000002ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e2931302e292d2c333a4a"
    "3e333646372c2d405741464c4e525352323e5a615a50604a51524fffdb0043010e0e0e131113261515264f352d354f4f4f4f4f4f4f4f4f4f4f4f4f4f"
    "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4fffc00014080008000804012200021101031101042200ffc4"
    "00160001010100000000000000000000000000000507ffc40014100100000000000000000000000000000000ffc40015010101000000000000000000"
    "00000000000507ffc40014110100000000000000000000000000000000ffda000e040100021103110400003f00be0194d9a700ffd9";

std::vector<std::uint8_t> bytesOf(const std::string& hex) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}

Error refusal(const std::vector<std::uint8_t>& bytes, const PngLimits& limits = {}) {
    try {
        (void)decodeJpeg(bytes, "a.jpg", limits);
    } catch (const Error& error) {
        return error;
    }
    return {ExitStatus::ok, "nothing is refused"};
}

TEST(Jpeg, HasItsSizeAndItsColours) {
    const std::vector<std::uint8_t> bytes = bytesOf(kRedAndGreen);
    const PngSize size = jpegSize(bytes, "a.jpg");
    EXPECT_EQ(size.width, 16u);
    EXPECT_EQ(size.height, 8u);
    const Image image = decodeJpeg(bytes, "a.jpg");
    ASSERT_EQ(image.width, 16);
    ASSERT_EQ(image.height, 8);
    constexpr int kLossy = 3; // levels: what its quantisation loses, of colours that fill whole blocks
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) {
            const Color8 texel = image.at(x, y);
            EXPECT_NEAR(texel.r, x < 8 ? 255 : 0, kLossy) << x << ", " << y;
            EXPECT_NEAR(texel.g, x < 8 ? 0 : 255, kLossy) << x << ", " << y;
            EXPECT_NEAR(texel.b, 0, kLossy) << x << ", " << y;
            EXPECT_EQ(texel.a, 255);
        }
    EXPECT_EQ(pictureFrom(bytes, "a.png", {}).image, image) << "told by how it starts, not by its name";
}

TEST(Jpeg, ThatEndsTooEarlyIsRefusedWhereverItEnds) {
    const std::vector<std::uint8_t> whole = bytesOf(kRedAndGreen);
    int refused = 0;
    for (std::size_t length = 0; length + 3 < whole.size(); ++length) { // without its last block at least
        const Error error = refusal({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
        EXPECT_EQ(error.status(), ExitStatus::badInput) << length;
        EXPECT_TRUE(std::string(error.what()).starts_with("a.jpg: not a readable JPEG: ")) << error.what();
        ++refused;
    }
    EXPECT_GT(refused, 250);
}

TEST(Jpeg, OfInksOrTooLargeOrNoneIsRefused) {
    EXPECT_NE(std::string(refusal(bytesOf(kInks)).what()).find("printing inks (CMYK)"), std::string::npos);
    const Error large = refusal(bytesOf(kRedAndGreen), {.side = 15});
    EXPECT_EQ(large.status(), ExitStatus::overLimit);
    EXPECT_STREQ(large.what(), "a.jpg: 16 x 8 pixels are more than the limit of 15 a side; scale it down");
    EXPECT_FALSE(startsLikeJpeg(bytesOf("89504e470d0a1a0a")));
    EXPECT_EQ(refusal({1, 2, 3, 4}).status(), ExitStatus::badInput);
}

} // namespace
} // namespace shadowlab::image
