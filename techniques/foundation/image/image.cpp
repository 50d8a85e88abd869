// Rectangles, copies and blending on 8-bit pictures.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowlab::image {
namespace {

std::array<float, 256> makeDecodeTable() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<float>(linearFromEncoded(static_cast<double>(i) / 255.0));
    return table;
}

} // namespace

Image::Image(int widthIn, int heightIn, Color8 fill) : width(std::max(0, widthIn)), height(std::max(0, heightIn)) {
    rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * kChannels);
    fillRect(*this, 0, 0, width, height, fill);
}

void fillRect(Image& image, int x, int y, int width, int height, Color8 color) {
    const int right = std::min(image.width, x + width), bottom = std::min(image.height, y + height);
    for (int row = std::max(0, y); row < bottom; ++row)
        for (int column = std::max(0, x); column < right; ++column)
            image.set(column, row, color);
}

void blit(Image& destination, int x, int y, const Image& source) {
    const int left = std::max(0, x), right = std::min(destination.width, x + source.width);
    const int top = std::max(0, y), bottom = std::min(destination.height, y + source.height);
    if (left >= right) return;
    const std::size_t bytes = static_cast<std::size_t>(right - left) * kChannels;
    for (int row = top; row < bottom; ++row)
        std::copy_n(source.rgba.data() + source.offset(left - x, row - y), bytes,
                    destination.rgba.data() + destination.offset(left, row));
}

void blendPixel(Image& image, int x, int y, Color8 color, float coverage) {
    if (!image.contains(x, y)) return;
    const float above = std::clamp(coverage, 0.0f, 1.0f) * static_cast<float>(color.a) / 255.0f;
    if (above <= 0.0f) return;
    const Color8 old = image.at(x, y);
    // Porter and Duff's "over" for straight alpha: weigh each colour by what it contributes, divide by the sum.
    const float below = static_cast<float>(old.a) / 255.0f * (1.0f - above);
    const float alpha = above + below;
    const auto mix = [&](std::uint8_t top, std::uint8_t bottom) {
        return srgbFromLinear((linearFromSrgb(top) * above + linearFromSrgb(bottom) * below) / alpha);
    };
    image.set(x, y,
              {mix(color.r, old.r), mix(color.g, old.g), mix(color.b, old.b),
               static_cast<std::uint8_t>(std::lround(std::min(alpha, 1.0f) * 255.0f))});
}

float linearFromSrgb(std::uint8_t encoded) {
    static const std::array<float, 256> table = makeDecodeTable();
    return table[encoded];
}

double linearFromEncoded(double encoded) {
    // 0.04045 is where the straight piece near black meets the power curve.
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t srgbFromLinear(float linear) {
    const double value = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    const double encoded = value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(encoded * 255.0));
}

Color8 encoded(const vec3& linear, std::uint8_t alpha) {
    return {srgbFromLinear(linear.r), srgbFromLinear(linear.g), srgbFromLinear(linear.b), alpha};
}

} // namespace shadowlab::image
