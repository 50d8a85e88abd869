// The line structure that OBJ and MTL files share: statements of a keyword and tokens, `#` comments, lines ended by
// LF, CR LF or CR, and a backslash that continues a statement on the next line. Knows the true line number throughout.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "techniques/foundation/base/error.h"

namespace shadowlab::scene {

class StatementLines {
public:
    /// `text` must outlive this. `lineBytes` is the longest line accepted.
    StatementLines(std::string_view text, const std::filesystem::path& file, std::uint64_t lineBytes);

    /// Goes to the next statement; false at the end of the text. Throws on NUL bytes and on lines too long.
    bool nextStatement();

    [[nodiscard]] std::string_view keyword() const { return keyword_; }

    /// The next token of the statement; nothing at its end. Tokens end at blanks and at a comment.
    std::optional<std::string_view> nextToken();

    /// What is left of the line, without blanks around it: a name, in which blanks and `#` may stand.
    std::string_view restOfLine();

    /// The same over all lines of the statement, with the ends of lines in it (onOneLine() removes them). A backslash continues it only
    /// where it stands behind a blank: at the end of a name it is a part of a Windows path.
    std::string_view restOfStatement();

    /// Line of the last token, counted from 1.
    [[nodiscard]] std::size_t line() const { return line_; }

    /// Throws Error "FILE:LINE: message" for the line of the last token.
    [[noreturn]] void fail(const std::string& message, ExitStatus status = ExitStatus::badInput) const;
    [[nodiscard]] std::string place(std::size_t line) const; ///< "FILE:LINE"

private:
    bool nextLine();
    [[nodiscard]] bool lineIsContinued() const;

    std::string_view text_;
    std::string fileName_;
    std::uint64_t lineBytes_;
    std::size_t cursor_ = 0;   ///< in the current line
    std::size_t lineEnd_ = 0;  ///< of the current line, without its terminator
    std::size_t nextLine_ = 0; ///< start of the next line
    std::size_t line_ = 0;
    bool inComment_ = false;
    std::string_view keyword_;
};

/// What restOfStatement() gave, with a blank in place of each backslash and end of line.
std::string onOneLine(std::string_view statement);

/// A decimal number as all of `token`, read correctly rounded and whatever the locale. Nothing when it is no number;
/// infinity when it is too large for double, NaN when it says so (also as 1.#QNAN). Too small is zero.
std::optional<double> readNumber(std::string_view token);

} // namespace shadowlab::scene
