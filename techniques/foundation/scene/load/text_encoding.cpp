// Telling UTF-16 from UTF-8, and converting it.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/text_encoding.h"

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

enum class ByteOrder { none, littleEndian, bigEndian };

/// Of a text without a byte order mark. All formats read here begin with two ASCII characters (a keyword, a bracket, a comment, a
/// line end), of which UTF-16 makes a NUL byte and another one each. A UTF-8 text has no NUL bytes.
ByteOrder guessedOrder(std::string_view bytes) {
    if (bytes.size() < 4) return ByteOrder::none;
    const auto isAscii = [](char high, char low) {
        return high == '\0' && low != '\0' && static_cast<unsigned char>(low) < 0x80;
    };
    if (isAscii(bytes[1], bytes[0]) && isAscii(bytes[3], bytes[2])) return ByteOrder::littleEndian;
    if (isAscii(bytes[0], bytes[1]) && isAscii(bytes[2], bytes[3])) return ByteOrder::bigEndian;
    return ByteOrder::none;
}

[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t line, const std::string& what) {
    throw Error(ExitStatus::badInput,
                shownPath(file) + ":" + std::to_string(line) + ": " + what + "; save the file again as UTF-8");
}

/// Lines end at CR LF, LF or CR alone, as for the readers.
std::size_t lastLine(std::string_view text) {
    std::size_t line = 1;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n")) ++line;
    return line;
}

std::string fromUtf16(std::string_view bytes, ByteOrder order, const std::filesystem::path& file) {
    const std::size_t low = order == ByteOrder::littleEndian ? 0 : 1;
    const auto unit = [&](std::size_t i) {
        return static_cast<char32_t>(static_cast<unsigned char>(bytes[i + low]) |
                                     static_cast<unsigned char>(bytes[i + 1 - low]) << 8);
    };
    const auto isBetween = [](char32_t c, char32_t first, char32_t last) { return c >= first && c <= last; };
    std::string text;
    text.reserve(bytes.size() / 2 + bytes.size() / 16);
    const std::size_t end = bytes.size() - bytes.size() % 2;
    for (std::size_t i = 0; i < end; i += 2) {
        char32_t character = unit(i);
        if (isBetween(character, 0xd800, 0xdbff) && i + 2 < end && isBetween(unit(i + 2), 0xdc00, 0xdfff)) {
            character = 0x10000 + ((character - 0xd800) << 10) + (unit(i + 2) - 0xdc00);
            i += 2;
        }
        appendUtf8(text, character);
    }
    if (end < bytes.size())
        refuse(file, lastLine(text),
               "the UTF-16 text ends in half a character (" + counted(bytes.size(), "byte") + ")");
    return text;
}

} // namespace

std::string utf8Text(std::string bytes, const std::filesystem::path& file) {
    using namespace std::string_view_literals;
    const std::string_view view(bytes);
    if (view.starts_with("\xff\xfe\0\0"sv) || view.starts_with("\0\0\xfe\xff"sv))
        refuse(file, 1, "the text is encoded as UTF-32");
    if (view.starts_with("\xff\xfe"sv)) return fromUtf16(view.substr(2), ByteOrder::littleEndian, file);
    if (view.starts_with("\xfe\xff"sv)) return fromUtf16(view.substr(2), ByteOrder::bigEndian, file);
    const ByteOrder order = guessedOrder(view);
    return order == ByteOrder::none ? std::move(bytes) : fromUtf16(view, order, file);
}

std::size_t sequenceLength(std::string_view text) {
    if (text.empty()) return 0;
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

char32_t codePoint(std::string_view sequence) {
    const auto byte = [&](std::size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(sequence[i])); };
    if (sequence.size() == 1) return byte(0);
    char32_t character = byte(0) & (0x7f >> sequence.size());
    for (std::size_t i = 1; i < sequence.size(); ++i)
        character = character << 6 | (byte(i) & 0x3f);
    return character;
}

void appendUtf8(std::string& text, char32_t character) {
    const auto add = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    const auto addRest = [&](int bits) { // the bits from `bits` on, six to a byte
        for (; bits >= 0; bits -= 6)
            add(0x80 | (character >> bits & 0x3f));
    };
    if (character < 0x80)
        add(character);
    else if (character < 0x800)
        add(0xc0 | character >> 6), addRest(0);
    else if (character < 0x10000)
        add(0xe0 | character >> 12), addRest(6);
    else
        add(0xf0 | character >> 18), addRest(12);
}

} // namespace shadowlab::scene
