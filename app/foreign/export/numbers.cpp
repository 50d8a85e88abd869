// SPDX-License-Identifier: MIT
#include "app/foreign/export/numbers.h"

#include <array>
#include <charconv>

namespace shadowlab::foreign {

namespace {

template <typename Number>
void append(std::string& list, Number value) {
    std::array<char, 40> digits; // a double takes 24
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    list.append(digits.data(), end);
}

template <typename Number>
std::string textOf(Number value) {
    std::string digits;
    append(digits, value + Number(0)); // no "-0"
    return digits;
}

template <typename Number>
void appendEach(std::string& list, std::span<const Number> values) {
    for (const Number value : values) {
        append(list, value + Number(0));
        list += ' ';
    }
}

} // namespace

std::string text(float value) { return textOf(value); }
std::string text(double value) { return textOf(value); }
std::string text(const dvec3& v) { return text(v.x) + ", " + text(v.y) + ", " + text(v.z); }
std::string text(const vec3& v) { return text(v.x) + ", " + text(v.y) + ", " + text(v.z); }

void appendAll(std::string& list, std::span<const float> values) { appendEach(list, values); }
void appendAll(std::string& list, std::span<const std::uint32_t> values) { appendEach(list, values); }

} // namespace shadowlab::foreign
