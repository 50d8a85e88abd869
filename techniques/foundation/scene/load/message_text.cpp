// Escaping and counting for messages.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/message_text.h"

#include <charconv>

namespace shadowlab::scene {

namespace {

/// Length of the well-formed UTF-8 sequence at the start of `text`, 0 when it is ill-formed.
std::size_t sequenceLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0x80   ? 1
                               : byte(0) < 0xc2 ? 0
                               : byte(0) < 0xe0 ? 2
                               : byte(0) < 0xf0 ? 3
                               : byte(0) < 0xf5 ? 4
                                                : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    // Longer than need be, a half of a surrogate pair, or beyond the last code point (The Unicode Standard, table 3-7).
    if ((byte(0) == 0xe0 && byte(1) < 0xa0) || (byte(0) == 0xed && byte(1) > 0x9f) ||
        (byte(0) == 0xf0 && byte(1) < 0x90) || (byte(0) == 0xf4 && byte(1) > 0x8f))
        return 0;
    return length;
}

/// Does a sequence of two or three bytes stand for a control character, or for one that changes the direction of text?
/// Terminals would obey them.
bool isControl(std::string_view sequence) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
    if (sequence.size() == 2) return byte(0) == 0xc2 && byte(1) < 0xa0; // U+0080 to U+009F
    if (sequence.size() != 3 || byte(0) != 0xe2) return false;
    return (byte(1) == 0x80 && (byte(2) == 0x8e || byte(2) == 0x8f || (byte(2) >= 0xa8 && byte(2) <= 0xae))) ||
           (byte(1) == 0x81 && byte(2) >= 0xa6 &&
            byte(2) <= 0xa9); // U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069
}

std::string escaped(std::string_view text, std::size_t longest) {
    static constexpr char kHex[] = "0123456789abcdef";
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (result.size() >= longest) return result + "...";
        const auto byte = static_cast<unsigned char>(text[i]);
        const std::size_t length = byte < 0x20 || byte == 0x7f ? 0 : sequenceLength(text.substr(i));
        if (length == 0 || isControl(text.substr(i, length))) {
            result += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
            ++i;
        } else {
            result += text.substr(i, length);
            i += length;
        }
    }
    return result;
}

} // namespace

std::string shown(std::string_view text, std::size_t longest) { return escaped(text, longest); }

std::string inQuotes(std::string_view text, std::size_t longest) {
    std::string result(1, '"');
    result += escaped(text, longest);
    result += '"';
    return result;
}

std::string shownPath(const std::filesystem::path& path) { return escaped(path.native(), 4096); }

std::string numberText(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return error == std::errc{} ? std::string(buffer, end) : std::string("?");
}

std::string counted(std::uint64_t count, std::string_view singular) {
    return std::to_string(count) + " " + std::string(singular) + (count == 1 ? "" : "s");
}

} // namespace shadowlab::scene
