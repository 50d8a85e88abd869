// How the bytes of a text file become UTF-8, the encoding that all readers work on.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace shadowlab::scene {

/// The text in UTF-8. UTF-16 is told by its byte order mark or, without one, by the NUL bytes of its first two characters, and is
/// converted; all else is returned as it is, also a UTF-8 byte order mark. Half of a surrogate pair becomes the three
/// bytes that UTF-8 forbids for it: harmless in a comment, refused in JSON, never equal to another character.
/// Throws Error (badInput) for UTF-16 of an odd number of bytes, and for UTF-32.
std::string utf8Text(std::string bytes, const std::filesystem::path& file);

/// Length of the well-formed UTF-8 sequence at the start of `text`, 0 when it is ill-formed or there is none.
std::size_t sequenceLength(std::string_view text);

/// The character of a well-formed sequence.
char32_t codePoint(std::string_view sequence);

void appendUtf8(std::string& text, char32_t character);

} // namespace shadowlab::scene
