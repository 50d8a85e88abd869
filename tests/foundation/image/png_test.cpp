// PNG: what goes in comes out, the same bytes every time, and broken files are refused with a reason.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/png/png.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "techniques/foundation/base/error.h"

namespace shadowlab::image {
namespace {

/// Every channel different everywhere, so that a swapped channel, row or column shows.
Image testPicture(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.set(x, y,
                      {static_cast<std::uint8_t>(x * 7), static_cast<std::uint8_t>(y * 11),
                       static_cast<std::uint8_t>(x * y), static_cast<std::uint8_t>(255 - x - y)});
    return image;
}

std::string asText(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

ExitStatus statusOf(const std::function<void()>& action, std::string& message) {
    try {
        action();
    } catch (const Error& error) {
        message = error.what();
        return error.status();
    }
    return ExitStatus::ok;
}

TEST(Png, RgbaRoundTrip) {
    const Image image = testPicture(37, 23);
    EXPECT_EQ(decodePng(encodePng(image, {.opaque = false, .text = {}}), "test").image, image);
}

TEST(Png, OpaqueDropsAlphaAndKeepsColour) {
    Image image = testPicture(37, 23);
    const Image decoded = decodePng(encodePng(image), "test").image;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;
    EXPECT_EQ(decoded, image);
}

TEST(Png, GreyAlphaRoundTripHasTwoChannelsAndNoColourChunk) {
    const std::vector<std::uint8_t> pairs{0, 255, 128, 255, 255, 255, 7, 0, 1, 255, 254, 255};
    const auto bytes = encodeGreyAlpha(3, 2, pairs);
    EXPECT_EQ(bytes[24], 8) << "bit depth";
    EXPECT_EQ(bytes[25], 4) << "colour type grey + alpha";
    EXPECT_EQ(asText(bytes).find("sRGB"), std::string::npos);
    const Image decoded = decodePng(bytes, "test").image;
    for (int i = 0; i < 6; ++i) {
        const Color8 pixel = decoded.at(i % 3, i / 3);
        const std::uint8_t grey = pairs[static_cast<std::size_t>(2 * i)],
                           alpha = pairs[static_cast<std::size_t>(2 * i + 1)];
        EXPECT_EQ(pixel, (Color8{grey, grey, grey, alpha})) << i;
    }
}

TEST(Png, ColourPicturesSayThatTheyAreSrgb) {
    EXPECT_NE(asText(encodePng(testPicture(2, 2))).find("sRGB"), std::string::npos);
}

TEST(Png, TextsComeBackInTheSimplestChunk) {
    const std::vector<PngText> latin{{"Title", "d\u00e9j\u00e0 vu"}, {"Comment", "two\nlines"}};
    const std::vector<PngText> greek{{"Title", "\u03b1 \u2264 \u03b2"}};
    const auto latinBytes = encodePng(testPicture(2, 2), {.opaque = true, .text = latin});
    const auto greekBytes = encodePng(testPicture(2, 2), {.opaque = true, .text = greek});
    EXPECT_EQ(decodePng(latinBytes, "test").text, latin);
    EXPECT_EQ(decodePng(greekBytes, "test").text, greek);
    EXPECT_EQ(asText(latinBytes).find("iTXt"), std::string::npos);
    EXPECT_NE(asText(greekBytes).find("iTXt"), std::string::npos);
}

TEST(Png, SamePictureSameBytesAndNoTimeStamp) {
    const PngOptions options{.opaque = true, .text = {{"Title", "x"}}};
    const auto bytes = encodePng(testPicture(64, 64), options);
    EXPECT_EQ(bytes, encodePng(testPicture(64, 64), options));
    EXPECT_EQ(asText(bytes).find("tIME"), std::string::npos);
}

TEST(Png, EveryTruncationIsRefused) {
    const auto bytes = encodePng(testPicture(16, 16), {.opaque = false, .text = {{"Title", "x"}}});
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        std::string message;
        const auto status = statusOf([&] { decodePng(std::span(bytes).first(size), "cut.png"); }, message);
        ASSERT_EQ(status, ExitStatus::badInput) << size;
        ASSERT_EQ(message.find("cut.png: not a readable PNG"), 0u) << message;
    }
}

TEST(Png, FlippedBitsNeverPassUnnoticedInThePixels) {
    const auto bytes = encodePng(testPicture(16, 16));
    const Image original = decodePng(bytes, "test").image;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        auto damaged = bytes;
        damaged[i] ^= 0x10;
        try {
            EXPECT_EQ(decodePng(damaged, "test").image, original) << "byte " << i; // in a chunk that is not needed
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::badInput);
        }
    }
}

TEST(Png, TooLargeIsALimitAndNotAFault) {
    const auto bytes = encodePng(testPicture(17, 3));
    std::string message;
    EXPECT_EQ(statusOf([&] { decodePng(bytes, "big.png", {.side = 16}); }, message), ExitStatus::overLimit);
    EXPECT_NE(message.find("17 x 3"), std::string::npos) << message;
}

TEST(Png, OnlyRegularFilesAreRead) {
    std::string message;
    EXPECT_EQ(statusOf([] { loadPng("/dev/zero"); }, message), ExitStatus::badInput);
    EXPECT_EQ(statusOf([] { loadPng("/no/such.png"); }, message), ExitStatus::badInput);
    EXPECT_EQ(statusOf([] { loadPng("/tmp"); }, message), ExitStatus::badInput);
}

TEST(Png, LoadsWhatWasWritten) {
    const auto file = std::filesystem::temp_directory_path() / ("shadowlab_png_" + std::to_string(::getpid()) + ".png");
    const auto bytes = encodePng(testPicture(5, 4), {.opaque = false, .text = {}});
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
    EXPECT_EQ(loadPng(file), testPicture(5, 4));
    std::filesystem::remove(file);
}

TEST(Png, EmptyPictureIsOurBug) {
    std::string message;
    EXPECT_EQ(statusOf([] { encodePng(Image()); }, message), ExitStatus::bug);
}

} // namespace
} // namespace shadowlab::image
