// Animated PNGs, read by a small reader of its own: chunks, check sums, numbers, times, and every frame as it is seen.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/png/animated_png.h"

#include <gtest/gtest.h>

#include "techniques/foundation/base/error.h"
#include "tests/support/apng_reader.h"

namespace shadowlab::image {
namespace {

/// Noise, so that nothing in it is the same by chance.
Image noise(int width, int height, std::uint32_t seed) {
    Image image(width, height);
    for (std::uint8_t& channel : image.rgba) {
        seed = seed * 1664525u + 1013904223u; // Numerical Recipes' generator
        channel = static_cast<std::uint8_t>(seed >> 24);
    }
    for (std::size_t i = 3; i < image.rgba.size(); i += kChannels)
        image.rgba[i] = 255;
    return image;
}

std::vector<Image> fourFrames() {
    std::vector<Image> frames{noise(37, 23, 1)};
    frames.push_back(frames[0]);
    fillRect(frames[1], 5, 7, 4, 3, {255, 0, 0, 255});
    frames.push_back(frames[1]); // nothing changes
    frames.push_back(noise(37, 23, 2));
    return frames;
}

std::vector<std::uint8_t> encoded(const std::vector<Image>& frames) {
    AnimatedPng animation(std::vector<PngText>{{"Title", "four frames"}});
    std::uint16_t time = 1;
    for (const Image& frame : frames)
        animation.add(frame, {time++, 30});
    return animation.finish();
}

TEST(AnimatedPngTest, EveryFrameIsWhatWasAdded) {
    const std::vector<Image> frames = fourFrames();
    const testing::Apng read = testing::readApng(encoded(frames));
    ASSERT_EQ(read.frames.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(read.frames[i].shown, frames[i]) << "frame " << i;
        EXPECT_EQ(read.frames[i].delayNumerator, i + 1);
        EXPECT_EQ(read.frames[i].delayDenominator, 30u);
    }
    EXPECT_EQ(read.plays, 0u);
}

TEST(AnimatedPngTest, OnlyWhatHasChangedIsWritten) {
    const testing::Apng read = testing::readApng(encoded(fourFrames()));
    const auto partOf = [&](std::size_t i) { return read.frames[i].part; };
    EXPECT_EQ(partOf(0), (ChangedPart{0, 0, 37, 23}));
    EXPECT_EQ(partOf(1), (ChangedPart{5, 7, 4, 3}));
    EXPECT_EQ(partOf(2), (ChangedPart{0, 0, 1, 1})) << "a frame has at least one pixel";
    EXPECT_EQ(partOf(3), (ChangedPart{0, 0, 37, 23}));
}

TEST(AnimatedPngTest, APlainReaderShowsTheFirstFrameAndItsTexts) {
    const std::vector<Image> frames = fourFrames();
    const DecodedPng plain = decodePng(encoded(frames), "animation");
    EXPECT_EQ(plain.image, frames[0]);
    ASSERT_EQ(plain.text.size(), 1u);
    EXPECT_EQ(plain.text[0], (PngText{"Title", "four frames"}));
}

TEST(AnimatedPngTest, TheSameFramesGiveTheSameBytes) { EXPECT_EQ(encoded(fourFrames()), encoded(fourFrames())); }

TEST(AnimatedPngTest, AFlippedBitIsFoundByTheReader) {
    // The reader that all of this rests on is no reader that takes anything.
    const std::vector<std::uint8_t> whole = encoded(fourFrames());
    int refused = 0;
    for (std::size_t at = 8; at < whole.size(); at += 97) {
        std::vector<std::uint8_t> broken = whole;
        broken[at] ^= 0x10;
        try {
            testing::readApng(broken);
        } catch (const std::runtime_error&) {
            ++refused;
            continue;
        }
        ADD_FAILURE() << "byte " << at;
    }
    EXPECT_GE(refused, 20);
}

TEST(AnimatedPngTest, FramesOfAnotherSizeAreRefused) {
    AnimatedPng animation;
    EXPECT_THROW((void)animation.finish(), Error) << "no frame yet";
    EXPECT_THROW(animation.add(Image(0, 4), {}), Error);
    animation.add(noise(8, 4, 3), {});
    EXPECT_THROW(animation.add(noise(4, 8, 3), {}), Error);
    EXPECT_EQ(animation.frames(), 1u);
}

TEST(ChangedPartTest, IsTheSmallestRectangle) {
    const Image before = noise(50, 40, 4);
    int compared = 0;
    for (const auto& [x, y] : {std::pair{0, 0}, {49, 39}, {0, 39}, {13, 21}})
        for (int channel = 0; channel < 3; ++channel, ++compared) {
            Image after = before;
            after.rgba[after.offset(x, y) + static_cast<std::size_t>(channel)] ^= 1;
            EXPECT_EQ(changedPart(before, after), (ChangedPart{x, y, 1, 1}));
            after.rgba[after.offset(20, 9)] ^= 1;
            EXPECT_EQ(changedPart(before, after),
                      (ChangedPart{std::min(x, 20), std::min(y, 9), std::abs(x - 20) + 1, std::abs(y - 9) + 1}));
        }
    EXPECT_EQ(compared, 12);
}

} // namespace
} // namespace shadowlab::image
