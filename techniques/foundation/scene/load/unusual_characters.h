// Characters that look like plain ones and are not: no-break spaces, minus signs, curly quotes and so on come from word processors
// and web pages. A message that names them is of more help than one that repeats them.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace shadowlab::scene {

struct UnusualCharacter {
    std::size_t offset = 0, length = 0; ///< in bytes
    std::string name;                   ///< "a no-break space (U+00A0)"
    std::string remedy;                 ///< "write a plain blank in its place", "delete it"
    bool isBlank = false;               ///< a space of some width, also of none
    bool isDoubleQuote = false;
};

/// The first in `text` at or after `from`. Bytes that are no UTF-8 are looked up as Windows-1252, which has such characters too.
std::optional<UnusualCharacter> unusualCharacter(std::string_view text, std::size_t from = 0);

/// ": it holds a minus sign (U+2212); write ..." for a message about `text`; empty when it holds none of them.
std::string unusualCharacterHint(std::string_view text);

/// Without blanks, plain or unusual, at both ends.
std::string_view withoutOuterBlanks(std::string_view text);

/// Without quotes, straight or curly, single or double, and blanks at both ends. A quote on one side alone goes too.
std::string_view unquoted(std::string_view text);

} // namespace shadowlab::scene
