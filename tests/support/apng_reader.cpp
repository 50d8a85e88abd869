// SPDX-License-Identifier: MIT
#include "tests/support/apng_reader.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

namespace shadowlab::testing {

namespace {

using Bytes = std::vector<std::uint8_t>;

void require(bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error("animated PNG: " + what);
}

std::uint32_t numberAt(const Bytes& bytes, std::size_t at) {
    require(at + 4 <= bytes.size(), "ends too early");
    return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 | std::uint32_t{bytes[at + 2]} << 8 |
           bytes[at + 3];
}

/// The check sum as the specification's annex computes it: bit by bit.
std::uint32_t checkSum(const Bytes& bytes, std::size_t begin, std::size_t end) {
    std::uint32_t sum = 0xffffffffu;
    for (std::size_t i = begin; i < end; ++i) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
    }
    return ~sum;
}

struct Chunk {
    std::string type;
    Bytes data;
};

std::vector<Chunk> chunksOf(const Bytes& bytes) {
    static const Bytes signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    require(bytes.size() > 8 && std::equal(signature.begin(), signature.end(), bytes.begin()), "no signature");
    std::vector<Chunk> chunks;
    std::size_t at = 8;
    while (at < bytes.size()) {
        const std::size_t length = numberAt(bytes, at), data = at + 8, end = data + length;
        require(end + 4 <= bytes.size(), "a chunk goes beyond the file");
        require(numberAt(bytes, end) == checkSum(bytes, at + 4, end), "a check sum is wrong");
        chunks.push_back({std::string(bytes.begin() + static_cast<std::ptrdiff_t>(at + 4),
                                      bytes.begin() + static_cast<std::ptrdiff_t>(data)),
                          Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(data),
                                bytes.begin() + static_cast<std::ptrdiff_t>(end))});
        at = end + 4;
    }
    require(!chunks.empty() && chunks.front().type == "IHDR" && chunks.back().type == "IEND", "no IHDR or no IEND");
    return chunks;
}

/// The rows of a rectangle: unpacked, and each filter undone.
Bytes rgbOf(const Bytes& packed, int width, int height) {
    const std::size_t rowBytes = static_cast<std::size_t>(width) * 3;
    Bytes rows((rowBytes + 1) * static_cast<std::size_t>(height));
    uLongf size = rows.size();
    uLong taken = packed.size();
    require(uncompress2(rows.data(), &size, packed.data(), &taken) == Z_OK && size == rows.size() &&
                taken == packed.size(),
            "not as many pixels as the frame has");
    Bytes rgb(rowBytes * static_cast<std::size_t>(height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        const std::uint8_t filter = rows[y * (rowBytes + 1)];
        require(filter <= 4, "no such filter");
        for (std::size_t x = 0; x < rowBytes; ++x) {
            const int left = x >= 3 ? rgb[y * rowBytes + x - 3] : 0, up = y > 0 ? rgb[(y - 1) * rowBytes + x] : 0,
                      corner = x >= 3 && y > 0 ? rgb[(y - 1) * rowBytes + x - 3] : 0;
            const int estimate = left + up - corner;
            const std::array<int, 3> apart{std::abs(estimate - left), std::abs(estimate - up),
                                           std::abs(estimate - corner)};
            const int paeth = apart[0] <= apart[1] && apart[0] <= apart[2] ? left : apart[1] <= apart[2] ? up : corner;
            const std::array<int, 5> predicted{0, left, up, (left + up) / 2, paeth};
            rgb[y * rowBytes + x] = static_cast<std::uint8_t>(rows[y * (rowBytes + 1) + 1 + x] + predicted[filter]);
        }
    }
    return rgb;
}

class Reader {
public:
    Apng read(const Bytes& bytes) {
        for (const Chunk& chunk : chunksOf(bytes))
            take(chunk);
        finishFrame();
        require(declared_ == animation_.frames.size(), "acTL counts other frames than there are");
        return std::move(animation_);
    }

private:
    void take(const Chunk& chunk) {
        if (chunk.type == "IHDR") header(chunk.data);
        if (chunk.type == "acTL") {
            require(!declared_ && !seesPixels_ && chunk.data.size() == 8, "acTL has to come once, before IDAT");
            declared_ = numberAt(chunk.data, 0);
            animation_.plays = numberAt(chunk.data, 4);
        }
        if (chunk.type == "fcTL") beginFrame(chunk.data);
        if (chunk.type == "IDAT") {
            require(animation_.frames.size() == 1, "IDAT has to be the first frame");
            seesPixels_ = true;
            packed_.insert(packed_.end(), chunk.data.begin(), chunk.data.end());
        }
        if (chunk.type == "fdAT") {
            require(animation_.frames.size() > 1 && numberAt(chunk.data, 0) == sequence_++, "fdAT out of order");
            packed_.insert(packed_.end(), chunk.data.begin() + 4, chunk.data.end());
        }
    }

    void header(const Bytes& data) {
        require(data.size() == 13 && data[8] == 8 && data[9] == 2 && data[12] == 0, "not 8-bit RGB, row by row");
        animation_.width = static_cast<int>(numberAt(data, 0));
        animation_.height = static_cast<int>(numberAt(data, 4));
        canvas_ = image::Image(animation_.width, animation_.height, {0, 0, 0, 255});
    }

    void beginFrame(const Bytes& data) {
        finishFrame();
        require(declared_.has_value() && data.size() == 26 && numberAt(data, 0) == sequence_++, "fcTL out of order");
        ApngFrame frame;
        frame.part = {static_cast<int>(numberAt(data, 12)), static_cast<int>(numberAt(data, 16)),
                      static_cast<int>(numberAt(data, 4)), static_cast<int>(numberAt(data, 8))};
        frame.delayNumerator = static_cast<unsigned>(data[20] << 8 | data[21]);
        frame.delayDenominator = static_cast<unsigned>(data[22] << 8 | data[23]);
        const image::ChangedPart& part = frame.part;
        require(part.width > 0 && part.height > 0 && part.x >= 0 && part.y >= 0 &&
                    part.x + part.width <= animation_.width && part.y + part.height <= animation_.height,
                "a frame goes beyond the picture");
        require(data[24] == 0 && data[25] == 0, "a frame that does not stay, or does not replace");
        const bool isWhole = part == image::ChangedPart{0, 0, animation_.width, animation_.height};
        require(!animation_.frames.empty() || isWhole, "the first frame has to be the whole picture");
        animation_.frames.push_back(std::move(frame));
    }

    void finishFrame() {
        if (animation_.frames.empty()) return;
        ApngFrame& frame = animation_.frames.back();
        const image::ChangedPart& part = frame.part;
        const Bytes rgb = rgbOf(packed_, part.width, part.height);
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) {
                const auto at = static_cast<std::size_t>(3 * (y * part.width + x));
                canvas_.set(part.x + x, part.y + y, {rgb[at], rgb[at + 1], rgb[at + 2], 255});
            }
        frame.shown = canvas_;
        packed_.clear();
    }

    Apng animation_;
    image::Image canvas_;
    Bytes packed_;
    std::optional<std::uint32_t> declared_;
    std::uint32_t sequence_ = 0;
    bool seesPixels_ = false;
};

} // namespace

Apng readApng(const std::vector<std::uint8_t>& bytes) { return Reader().read(bytes); }

} // namespace shadowlab::testing
