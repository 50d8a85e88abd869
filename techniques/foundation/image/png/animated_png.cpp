// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/png/animated_png.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>

#include "techniques/foundation/base/error.h"

namespace shadowlab::image {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kSignature = 8, kAround = 12; ///< bytes; of a chunk: length, type and check sum
constexpr std::uint8_t kStays = 0, kReplaces = 0;   ///< dispose_op NONE, blend_op SOURCE

void appendNumber(Bytes& bytes, std::uint32_t number) { // PNG has the largest byte first
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

void appendShort(Bytes& bytes, std::uint16_t number) {
    bytes.push_back(static_cast<std::uint8_t>(number >> 8));
    bytes.push_back(static_cast<std::uint8_t>(number));
}

void appendChunk(Bytes& bytes, std::string_view type, std::span<const std::uint8_t> data) {
    appendNumber(bytes, static_cast<std::uint32_t>(data.size()));
    const std::size_t summed = bytes.size(); // type and data
    bytes.insert(bytes.end(), type.begin(), type.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    appendNumber(bytes, static_cast<std::uint32_t>(
                            crc32_z(crc32_z(0, nullptr, 0), bytes.data() + summed, bytes.size() - summed)));
}

struct Chunk {
    std::string_view type;
    std::span<const std::uint8_t> data;
};

/// The chunks of a PNG that our own encoder wrote.
std::vector<Chunk> chunksOf(const Bytes& png) {
    std::vector<Chunk> chunks;
    for (std::size_t at = kSignature; at + kAround <= png.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | png[at + i];
        chunks.push_back({{reinterpret_cast<const char*>(png.data()) + at + 4, 4}, {png.data() + at + 8, length}});
        at += kAround + length;
    }
    return chunks;
}

Image cut(const Image& image, const ChangedPart& part) {
    Image piece(part.width, part.height);
    for (int y = 0; y < part.height; ++y)
        std::memcpy(piece.rgba.data() + piece.offset(0, y), image.rgba.data() + image.offset(part.x, part.y + y),
                    static_cast<std::size_t>(part.width) * kChannels);
    return piece;
}

} // namespace

ChangedPart changedPart(const Image& before, const Image& after) {
    int left = after.width, right = -1, top = after.height, bottom = -1;
    for (int y = 0; y < after.height; ++y)
        for (int x = 0; x < after.width; ++x) {
            const std::size_t at = after.offset(x, y);
            if (std::equal(&after.rgba[at], &after.rgba[at] + 3, &before.rgba[at])) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = y;
        }
    if (right < 0) return {0, 0, 1, 1};
    return {left, top, right - left + 1, bottom - top + 1};
}

void AnimatedPng::add(const Image& frame, FrameTime time) {
    if (frame.width < 1 || frame.height < 1 ||
        (frames_ > 0 && (frame.width != last_.width || frame.height != last_.height)))
        throw Error(ExitStatus::bug, "frames of an animation differ in size, or have none; report it");
    const bool isFirst = frames_ == 0;
    const ChangedPart part = isFirst ? ChangedPart{0, 0, frame.width, frame.height} : changedPart(last_, frame);
    const Bytes png = isFirst ? encodePng(frame, {.opaque = true, .text = text_})
                              : encodePng(cut(frame, part), {.opaque = true, .text = {}});
    Bytes control;
    appendNumber(control, sequence_++);
    for (const int number : {part.width, part.height, part.x, part.y})
        appendNumber(control, static_cast<std::uint32_t>(number));
    appendShort(control, time.numerator);
    appendShort(control, time.denominator);
    control.insert(control.end(), {kStays, kReplaces});
    if (isFirst) head_.assign(png.begin(), png.begin() + kSignature);
    appendChunk(body_, "fcTL", control);
    for (const Chunk& chunk : chunksOf(png)) {
        if (chunk.type == "IEND") break;
        if (chunk.type != "IDAT") {
            if (isFirst) appendChunk(head_, chunk.type, chunk.data);
            continue;
        }
        if (isFirst) {
            appendChunk(body_, "IDAT", chunk.data);
            continue;
        }
        Bytes data;
        appendNumber(data, sequence_++);
        data.insert(data.end(), chunk.data.begin(), chunk.data.end());
        appendChunk(body_, "fdAT", data);
    }
    last_ = frame;
    ++frames_;
}

std::vector<std::uint8_t> AnimatedPng::finish() const {
    if (frames_ == 0) throw Error(ExitStatus::bug, "an animation has no frame; report it");
    Bytes bytes = head_, control;
    appendNumber(control, frames_);
    appendNumber(control, 0); // it loops for ever
    appendChunk(bytes, "acTL", control);
    bytes.insert(bytes.end(), body_.begin(), body_.end());
    appendChunk(bytes, "IEND", {});
    return bytes;
}

} // namespace shadowlab::image
