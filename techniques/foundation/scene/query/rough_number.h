// Numbers in advice: three digits are enough to act on.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// "0.0342", "1500", "1.5e+06".
inline std::string roughNumber(double value) {
    std::array<char, 32> text{};
    constexpr int kDigits = 3;
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kDigits);
    if (error != std::errc{}) return "?";
    // Above 999 these digits come with an exponent, which people read with ease for millions only.
    constexpr double kMillion = 1e6;
    double rounded = 0;
    std::from_chars(text.data(), end, rounded);
    if (std::abs(rounded) >= 1000 && std::abs(rounded) < kMillion) return std::to_string(std::lround(rounded));
    return std::string(text.data(), end);
}

/// A place as a scene file has it: "[1.2, 0, -3]". What is tiny beside `size` is written as 0.
inline std::string roughPlace(const dvec3& place, double size) {
    std::string text = "[";
    for (int i = 0; i < 3; ++i)
        text += (i > 0 ? ", " : "") + roughNumber(std::abs(place[i]) < 1e-3 * size ? 0.0 : place[i]);
    return text + "]";
}

} // namespace shadowlab::scene
