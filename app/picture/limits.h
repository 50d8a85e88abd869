// The limits of what is read, by name: for `list limits`, and for `--limit NAME=VALUE`, which sets one for this run.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::picture {

constexpr int kMostFrames = 100000; ///< of one sequence

/// What commands refuse to draw beyond (exit status 6).
struct PictureLimits {
    std::uint32_t side = 16384;         ///< pixels of the picture, and samples of one panel, on a side
    std::uint64_t samples = 1ull << 27; ///< of all panels together: 12 bytes each on the graphics card
    std::uint32_t measuredSide = 8192;  ///< truth, verdicts and comparisons of pictures keep some 200 bytes a pixel
    std::uint32_t supersample = 16;     ///< samples on a side of a pixel
    std::uint32_t frames = kMostFrames; ///< of one sequence
};

struct NamedLimit {
    std::string name, unit;
    std::uint64_t standard, most; ///< it is by itself, and can be raised to
    std::function<std::uint64_t()> value;
    std::function<void(std::uint64_t)> set;
};
const std::vector<NamedLimit>& namedLimits();

/// Those in force.
const scene::Limits& limits();
const PictureLimits& pictureLimits();

/// The value of one of namedLimits().
std::uint64_t limitNamed(std::string_view name);

/// As words of a command line, those that are not what they are by themselves.
std::vector<std::string> limitWords();

/// `NAME=VALUE`, before anything is read. Throws Error (usage): no such limit, no whole number, or beyond what it can be raised to.
void setLimit(const std::string& assignment);

// Bytes that a sample of a picture takes in all, a tenth above the largest measured: of what is drawn (ray tracing with
// mirrors and glass 90, others 27 to 52), and of what is compared with the truth (175).
constexpr std::uint64_t kBytesPerDrawnSample = 100, kBytesPerMeasuredPixel = 200;

/// Sets aside what pictures of so many samples will take; what is loaded then has the rest. Throws Error (overLimit)
/// where they alone are beyond the limit: `asked` names what asks for them ("--size 9000x9000"), `remedy` what to do.
void reserveForPictures(std::uint64_t samples, std::uint64_t bytesPerSample, const std::string& asked,
                        const std::string& remedy);

} // namespace shadowlab::picture
