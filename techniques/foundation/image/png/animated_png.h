// Animated PNG: frames that follow each other in one PNG file. A viewer without support for it shows the first frame.
//
// PNG, third edition (W3C 2025), 4.9 and 11.3.6: acTL says how many frames there are, fcTL before each how large it is, where
// it lies and how long it stays, and fdAT holds the pixels of all but the first, whose IDAT is that of a plain PNG. Of each
// following frame only the smallest rectangle that has changed is written; it replaces what was there.
// The same frames give the same bytes.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/image/png/png.h"

namespace shadowlab::image {

/// How long a frame stays, in seconds: a fraction of two numbers of 16 bits, so that 1/30 is exact.
struct FrameTime {
    std::uint16_t numerator = 1, denominator = 25;
};

/// A rectangle of a picture, in pixels from its upper left corner.
struct ChangedPart {
    int x = 0, y = 0, width = 0, height = 0;
    friend bool operator==(const ChangedPart&, const ChangedPart&) = default;
};

/// The smallest rectangle outside of which two pictures of one size are the same; of the same pictures the first pixel
/// alone, since a frame has at least one. Alpha is ignored, because frames are opaque.
ChangedPart changedPart(const Image& before, const Image& after);

class AnimatedPng {
public:
    /// The texts are those of the file. All frames are opaque.
    explicit AnimatedPng(std::vector<PngText> text = {}) : text_(std::move(text)) {}

    /// Adds a frame; all are as large as the first. Throws Error (bug) for another size, or one without pixels.
    void add(const Image& frame, FrameTime time);
    [[nodiscard]] std::uint32_t frames() const { return frames_; }

    /// The whole file, which begins again after its last frame. At least one frame has to be added before.
    [[nodiscard]] std::vector<std::uint8_t> finish() const;

private:
    std::vector<PngText> text_;
    Image last_;
    std::vector<std::uint8_t> head_; ///< signature and all chunks before the pixels
    std::vector<std::uint8_t> body_; ///< fcTL, IDAT or fdAT of the frames
    std::uint32_t frames_ = 0, sequence_ = 0;
};

} // namespace shadowlab::image
