// UTF-8 to code points and back, as far as labels and PNG texts need it.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace shadowlab::image {

/// The replacement for bytes that are not UTF-8.
constexpr char32_t kReplacementCharacter = 0xFFFD;

/// Every ill-formed byte becomes one replacement character, because a file name with odd bytes should not make a label
/// fail.
std::u32string decodeUtf8(std::string_view text);
std::string encodeUtf8(std::u32string_view text);

/// With the replacement character for ill-formed bytes, and for noncharacters (U+FFFF and its like: The Unicode Standard, section
/// 23.7). UTF-8 may have these; XML may not, and Cairo refuses them.
std::string withoutNoncharacters(std::string_view text);

} // namespace shadowlab::image
