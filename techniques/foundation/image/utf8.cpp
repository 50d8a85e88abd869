// UTF-8 decoding that refuses overlong forms, surrogates and values beyond Unicode (RFC 3629).
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/utf8.h"

#include <cstddef>

namespace shadowlab::image {
namespace {

/// Length of the sequence that starts with this byte, and the smallest value it may stand for; length 0: cannot start.
struct Lead {
    std::size_t length;
    char32_t minimum, bits;
};
Lead leadOf(unsigned char byte) {
    if (byte < 0x80) return {1, 0, byte};
    if (byte >= 0xC2 && byte < 0xE0) return {2, 0x80, byte & 0x1Fu};
    if (byte >= 0xE0 && byte < 0xF0) return {3, 0x800, byte & 0x0Fu};
    if (byte >= 0xF0 && byte < 0xF5) return {4, 0x10000, byte & 0x07u};
    return {0, 0, 0};
}

} // namespace

std::u32string decodeUtf8(std::string_view text) {
    std::u32string points;
    for (std::size_t i = 0; i < text.size();) {
        const Lead lead = leadOf(static_cast<unsigned char>(text[i]));
        char32_t value = lead.bits;
        bool good = lead.length > 0 && i + lead.length <= text.size();
        for (std::size_t k = 1; good && k < lead.length; ++k) {
            const auto byte = static_cast<unsigned char>(text[i + k]);
            good = (byte & 0xC0) == 0x80;
            value = value << 6 | (byte & 0x3Fu);
        }
        good = good && value >= lead.minimum && value <= 0x10FFFF && (value < 0xD800 || value > 0xDFFF);
        points.push_back(good ? value : kReplacementCharacter);
        i += good ? lead.length : 1;
    }
    return points;
}

std::string encodeUtf8(std::u32string_view text) {
    std::string bytes;
    const auto put = [&bytes](char32_t value) {
        bytes.push_back(static_cast<char>(static_cast<unsigned char>(value)));
    };
    for (const char32_t point : text) {
        if (point < 0x80) {
            put(point);
        } else if (point < 0x800) {
            put(0xC0 | point >> 6), put(0x80 | (point & 0x3F));
        } else if (point < 0x10000) {
            put(0xE0 | point >> 12), put(0x80 | (point >> 6 & 0x3F)), put(0x80 | (point & 0x3F));
        } else {
            put(0xF0 | point >> 18), put(0x80 | (point >> 12 & 0x3F));
            put(0x80 | (point >> 6 & 0x3F)), put(0x80 | (point & 0x3F));
        }
    }
    return bytes;
}

std::string withoutNoncharacters(std::string_view text) {
    std::u32string points = decodeUtf8(text);
    for (char32_t& point : points)
        if ((point & 0xFFFE) == 0xFFFE || (point >= 0xFDD0 && point <= 0xFDEF)) point = kReplacementCharacter;
    return encodeUtf8(points);
}

} // namespace shadowlab::image
