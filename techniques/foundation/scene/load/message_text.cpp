// Escaping and counting for messages.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/message_text.h"

#include <charconv>

#include "techniques/foundation/scene/load/text_encoding.h"

namespace shadowlab::scene {

namespace {

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
