// SPDX-License-Identifier: MIT
#include "techniques/foundation/base/look.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::look {

vec3 linearFromSrgb8(int r, int g, int b) {
    const auto decode = [](int value) {
        const double s = value / 255.0; // IEC 61966-2-1
        return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    };
    return {decode(r), decode(g), decode(b)};
}

int lineRadius(int height) { return std::max(1, height / 480); }

const Palette& viridis() {
    static const Palette palette = {
        linearFromSrgb8(0x44, 0x01, 0x54), linearFromSrgb8(0x47, 0x2D, 0x7B), linearFromSrgb8(0x3B, 0x52, 0x8B),
        linearFromSrgb8(0x2C, 0x72, 0x8E), linearFromSrgb8(0x21, 0x91, 0x8C), linearFromSrgb8(0x28, 0xAE, 0x80),
        linearFromSrgb8(0x5E, 0xC9, 0x62), linearFromSrgb8(0xAD, 0xDC, 0x30), linearFromSrgb8(0xFD, 0xE7, 0x25)};
    return palette;
}

const Palette& diverging() {
    static const Palette palette = {
        linearFromSrgb8(0x05, 0x30, 0x61), linearFromSrgb8(0x21, 0x66, 0xAC), linearFromSrgb8(0x43, 0x93, 0xC3),
        linearFromSrgb8(0x92, 0xC5, 0xDE), linearFromSrgb8(0xE8, 0xE8, 0xE8), linearFromSrgb8(0xF4, 0xA5, 0x82),
        linearFromSrgb8(0xD6, 0x60, 0x4D), linearFromSrgb8(0xB2, 0x18, 0x2B), linearFromSrgb8(0x67, 0x00, 0x1F)};
    return palette;
}

vec3 colorAt(const Palette& palette, double t) {
    const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(palette.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), palette.size() - 2);
    return glm::mix(palette[below], palette[below + 1], static_cast<float>(at - static_cast<double>(below)));
}

} // namespace shadowlab::look
