// A picture in memory: 8 bits per channel, sRGB-encoded, straight (not premultiplied) alpha, row 0 at the top.
// Everything that draws on finished pictures (labels, legends, the layouts of several slots) works on this type.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::image {

/// One pixel as it stands in the file: sRGB-encoded colour and straight alpha.
struct Color8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    friend bool operator==(const Color8&, const Color8&) = default;
};

/// Bytes of one pixel: r, g, b, a.
constexpr std::size_t kChannels = 4;

struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba; ///< width * height * 4 bytes, rows from top to bottom

    Image() = default;
    Image(int width, int height, Color8 fill = {0, 0, 0, 0}); ///< sizes below 0 count as 0

    [[nodiscard]] std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               kChannels;
    }
    [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }

    /// The pixel must lie inside.
    [[nodiscard]] Color8 at(int x, int y) const {
        const std::uint8_t* p = rgba.data() + offset(x, y);
        return {p[0], p[1], p[2], p[3]};
    }
    void set(int x, int y, Color8 color) {
        std::uint8_t* p = rgba.data() + offset(x, y);
        p[0] = color.r, p[1] = color.g, p[2] = color.b, p[3] = color.a;
    }
    friend bool operator==(const Image&, const Image&) = default;
};

/// Overwrites a rectangle; what lies outside the image is left out.
void fillRect(Image& image, int x, int y, int width, int height, Color8 color);

/// Copies `source` with its top left corner to (x, y), replacing what was there; what lies outside is left out.
void blit(Image& destination, int x, int y, const Image& source);

/// Lays `color` over one pixel with `coverage` in 0..1 (times the colour's own alpha), in linear light.
/// Linear, because half a pixel of white on black must send half the light: blending the encoded numbers sends about
/// a fifth, and thin bright strokes on dark ground lose weight. Outside the image nothing happens.
void blendPixel(Image& image, int x, int y, Color8 color, float coverage);

/// The sRGB transfer function (IEC 61966-2-1), both ways. The encoder clamps to 0..1 and rounds to nearest.
float linearFromSrgb(std::uint8_t encoded);
std::uint8_t srgbFromLinear(float linear);
/// The decoder of numbers between those of a byte, 0..1.
double linearFromEncoded(double encoded);
/// The same of a colour's three channels.
Color8 encoded(const vec3& linear, std::uint8_t alpha = 255);

} // namespace shadowlab::image
