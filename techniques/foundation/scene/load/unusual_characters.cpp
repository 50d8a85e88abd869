// The table of such characters, and the search for them.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/unusual_characters.h"

#include <algorithm>
#include <array>

#include "techniques/foundation/scene/load/text_encoding.h"

namespace shadowlab::scene {

namespace {

enum class Plain { blank, nothing, hyphen, singleQuote, doubleQuote, lineBreak, narrow };

struct Range {
    char32_t first, last;
    std::string_view name;
    Plain plain;
};

constexpr std::array kUnusual{Range{0x0085, 0x0085, "a next-line character", Plain::lineBreak},
                              Range{0x00a0, 0x00a0, "a no-break space", Plain::blank},
                              Range{0x00ab, 0x00ab, "an angle quote", Plain::doubleQuote},
                              Range{0x00ad, 0x00ad, "a soft hyphen", Plain::nothing},
                              Range{0x00bb, 0x00bb, "an angle quote", Plain::doubleQuote},
                              Range{0x1680, 0x1680, "a typographic space", Plain::blank},
                              Range{0x2000, 0x200a, "a typographic space", Plain::blank},
                              Range{0x200b, 0x200f, "an invisible character", Plain::nothing},
                              Range{0x2010, 0x2011, "a typographic hyphen", Plain::hyphen},
                              Range{0x2012, 0x2015, "a dash", Plain::hyphen},
                              Range{0x2018, 0x201b, "a curly quote", Plain::singleQuote},
                              Range{0x201c, 0x201f, "a curly quote", Plain::doubleQuote},
                              Range{0x2028, 0x2029, "a line separator", Plain::lineBreak},
                              Range{0x202f, 0x202f, "a narrow no-break space", Plain::blank},
                              Range{0x2032, 0x2032, "a prime mark", Plain::singleQuote},
                              Range{0x2033, 0x2033, "a double prime mark", Plain::doubleQuote},
                              Range{0x205f, 0x205f, "a typographic space", Plain::blank},
                              Range{0x2060, 0x2064, "an invisible character", Plain::nothing},
                              Range{0x2212, 0x2212, "a minus sign", Plain::hyphen},
                              Range{0x3000, 0x3000, "an ideographic space", Plain::blank},
                              Range{0xfe58, 0xfe58, "a dash", Plain::hyphen},
                              Range{0xfe63, 0xfe63, "a small hyphen", Plain::hyphen},
                              Range{0xfeff, 0xfeff, "a byte order mark", Plain::nothing},
                              Range{0xff01, 0xff5e, "a full-width character", Plain::narrow}};

/// What Windows-1252 has in place of those, by byte.
struct WindowsByte {
    unsigned char byte;
    char32_t character;
};
constexpr std::array kWindowsBytes{WindowsByte{0x91, 0x2018}, WindowsByte{0x92, 0x2019}, WindowsByte{0x93, 0x201c},
                                   WindowsByte{0x94, 0x201d}, WindowsByte{0x96, 0x2013}, WindowsByte{0x97, 0x2014},
                                   WindowsByte{0xa0, 0x00a0}, WindowsByte{0xab, 0x00ab}, WindowsByte{0xad, 0x00ad},
                                   WindowsByte{0xbb, 0x00bb}};

std::string hexadecimal(char32_t number, std::size_t digits) {
    static constexpr char kHex[] = "0123456789ABCDEF";
    std::string text;
    for (std::size_t i = digits; i-- > 0;)
        text += kHex[number >> 4 * i & 15];
    return text;
}

std::string remedyFor(Plain plain, char32_t character) {
    switch (plain) {
    case Plain::blank: return "write a plain blank in its place";
    case Plain::nothing: return "delete it";
    case Plain::hyphen: return "write a plain - in its place";
    case Plain::singleQuote: return "write a straight quote ' in its place";
    case Plain::doubleQuote: return "write a straight quote \" in its place";
    case Plain::lineBreak: return "start a new line in its place";
    case Plain::narrow: break;
    }
    constexpr char32_t kToNarrow = 0xff01 - '!'; // the full-width forms stand in the order of ASCII
    return std::string("write a plain ") + static_cast<char>(character - kToNarrow) + " in its place";
}

/// The character at the start of `text`, its length in bytes, and how a message writes it.
struct Decoded {
    char32_t character;
    std::size_t length;
    bool isUtf8;
};
Decoded decoded(std::string_view text) {
    if (const std::size_t length = sequenceLength(text); length > 0)
        return {codePoint(text.substr(0, length)), length, true};
    const auto byte = static_cast<unsigned char>(text.front());
    const auto found = std::ranges::find(kWindowsBytes, byte, &WindowsByte::byte);
    return {found == kWindowsBytes.end() ? U'\0' : found->character, 1, false};
}

const Range* rangeOf(char32_t character) {
    const auto found =
        std::ranges::find_if(kUnusual, [&](const Range& r) { return character >= r.first && character <= r.last; });
    return found == kUnusual.end() ? nullptr : &*found;
}

bool isPlainBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// `text` without what `isOuter` takes for an outer character, at both ends.
template <typename IsOuter>
std::string_view trimmed(std::string_view text, const IsOuter& isOuter) {
    while (!text.empty()) {
        const std::size_t length = std::max<std::size_t>(sequenceLength(text), 1);
        if (!isOuter(text.substr(0, length))) break;
        text.remove_prefix(length);
    }
    while (!text.empty()) {
        std::size_t start = text.size() - 1; // back to the byte that begins the last character, at most three further
        while (start > 0 && text.size() - start < 4 && (static_cast<unsigned char>(text[start]) & 0xc0) == 0x80)
            --start;
        if (sequenceLength(text.substr(start)) != text.size() - start) start = text.size() - 1; // no UTF-8
        if (!isOuter(text.substr(start))) break;
        text.remove_suffix(text.size() - start);
    }
    return text;
}

bool isAnyBlank(std::string_view character) {
    if (isPlainBlank(character.front())) return true;
    const auto unusual = unusualCharacter(character);
    return unusual && unusual->isBlank;
}

bool isAnyQuote(std::string_view character) {
    if (character == "\"" || character == "'") return true;
    const Range* range = rangeOf(decoded(character).character);
    return range && (range->plain == Plain::singleQuote || range->plain == Plain::doubleQuote);
}

} // namespace

std::optional<UnusualCharacter> unusualCharacter(std::string_view text, std::size_t from) {
    for (std::size_t i = from; i < text.size();) {
        if (static_cast<unsigned char>(text[i]) < 0x80) {
            ++i;
            continue;
        }
        const auto [character, length, isUtf8] = decoded(text.substr(i));
        if (const Range* range = rangeOf(character)) {
            const std::string code = isUtf8 ? "U+" + hexadecimal(character, 4)
                                            : "byte " + hexadecimal(static_cast<unsigned char>(text[i]), 2);
            return UnusualCharacter{.offset = i,
                                    .length = length,
                                    .name = std::string(range->name) + " (" + code + ")",
                                    .remedy = remedyFor(range->plain, character),
                                    .isBlank = range->plain == Plain::blank || range->plain == Plain::nothing,
                                    .isDoubleQuote = range->plain == Plain::doubleQuote};
        }
        i += length;
    }
    return std::nullopt;
}

std::string unusualCharacterHint(std::string_view text) {
    const auto found = unusualCharacter(text);
    return found ? ": it holds " + found->name + "; " + found->remedy : std::string();
}

std::string_view withoutOuterBlanks(std::string_view text) { return trimmed(text, isAnyBlank); }

std::string_view unquoted(std::string_view text) {
    return trimmed(text, [](std::string_view character) { return isAnyBlank(character) || isAnyQuote(character); });
}

} // namespace shadowlab::scene
