// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_uris.h"

#include <array>
#include <cstdint>

namespace shadowlab::scene {

namespace {

bool isAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isAsciiDigit(char c) { return c >= '0' && c <= '9'; }

int hexDigit(char c) {
    if (isAsciiDigit(c)) return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// The six bits that a character stands for, or one of these.
constexpr std::int8_t kNoDigit = -1, kPadding = -2, kBlank = -3;

constexpr std::array<std::int8_t, 256> base64Digits() {
    std::array<std::int8_t, 256> digits{};
    digits.fill(kNoDigit);
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < kDigits.size(); ++i)
        digits[static_cast<unsigned char>(kDigits[i])] = static_cast<std::int8_t>(i);
    digits['-'] = 62, digits['_'] = 63; // as in URLs (RFC 4648, section 5)
    digits['='] = kPadding;
    for (const char blank : {' ', '\t', '\r', '\n'})
        digits[static_cast<unsigned char>(blank)] = kBlank;
    return digits;
}

/// RFC 4648; padding may be left out.
std::optional<std::string> fromBase64(std::string_view text) {
    static constexpr std::array<std::int8_t, 256> kDigits = base64Digits();
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    std::size_t digits = 0, padding = 0;
    for (const char c : text) {
        const std::int8_t digit = kDigits[static_cast<unsigned char>(c)];
        if (digit == kBlank) continue;
        if (digit == kPadding) {
            ++padding;
            continue;
        }
        if (digit == kNoDigit || padding > 0) return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if (++digits % 4 == 0)
            for (const int shift : {16, 8, 0})
                bytes += static_cast<char>(bits >> shift & 0xff);
    }
    if (digits % 4 == 1 || padding > 2 || (padding > 0 && (digits + padding) % 4 != 0)) return std::nullopt;
    if (digits % 4 == 2) bytes += static_cast<char>(bits >> 4 & 0xff);
    if (digits % 4 == 3) bytes += static_cast<char>(bits >> 10 & 0xff), bytes += static_cast<char>(bits >> 2 & 0xff);
    return bytes;
}

} // namespace

bool hasScheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon < 2 || !isAsciiLetter(uri[0])) return false;
    for (const char c : uri.substr(0, colon))
        if (!isAsciiLetter(c) && !isAsciiDigit(c) && c != '+' && c != '-' && c != '.') return false;
    return true;
}

std::optional<std::string> bytesOfDataUri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) return std::nullopt;
    const std::string_view text = uri.substr(comma + 1);
    return text.find('%') == std::string_view::npos ? fromBase64(text) : fromBase64(percentDecoded(text));
}

std::string percentDecoded(std::string_view uri) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        path += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
        if (low >= 0) i += 2;
    }
    return path;
}

std::string percentEncoded(std::string_view path) {
    constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string uri;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (isAsciiLetter(c) || isAsciiDigit(c) || std::string_view("-._~/").find(c) != std::string_view::npos)
            uri += c;
        else
            uri.append({'%', kHex[byte >> 4], kHex[byte & 15]});
    }
    return uri;
}

} // namespace shadowlab::scene
