// Line and token scanning for OBJ and MTL texts.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/statement_lines.h"

#include <charconv>
#include <limits>

#include "techniques/foundation/scene/message_text.h"

namespace shadowlab::scene {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

} // namespace

StatementLines::StatementLines(std::string_view text, const std::filesystem::path& file, std::uint64_t lineBytes)
    : text_(text), fileName_(shownPath(file)), lineBytes_(lineBytes) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3); // UTF-8 byte order mark
}

bool StatementLines::nextLine() {
    if (nextLine_ >= text_.size()) return false;
    ++line_;
    inComment_ = false;
    cursor_ = lineEnd_ = nextLine_;
    while (lineEnd_ < text_.size() && text_[lineEnd_] != '\n' && text_[lineEnd_] != '\r') {
        if (text_[lineEnd_] == '\0') fail("binary data (a NUL byte); it is not an OBJ or MTL text file");
        ++lineEnd_;
    }
    if (lineEnd_ - cursor_ > lineBytes_)
        fail("the line is " + counted(lineEnd_ - cursor_, "byte") + " long, more than the limit of " +
                 std::to_string(lineBytes_) + "; break it up, or set --limit mesh-line=VALUE",
             ExitStatus::overLimit);
    nextLine_ = lineEnd_ + (text_.substr(lineEnd_, 2) == "\r\n" ? 2 : 1);
    return true;
}

bool StatementLines::lineIsContinued() const {
    return !inComment_ && lineEnd_ > 0 && cursor_ <= lineEnd_ && lineEnd_ < text_.size() && text_[lineEnd_ - 1] == '\\';
}

bool StatementLines::nextStatement() {
    // The rest of a statement that was not read to its end.
    while (line_ > 0 && lineIsContinued())
        if (!nextLine()) return false;
    while (nextLine()) {
        if (const auto token = nextToken()) {
            keyword_ = *token;
            return true;
        }
    }
    return false;
}

std::optional<std::string_view> StatementLines::nextToken() {
    for (;;) {
        while (cursor_ < lineEnd_ && isBlank(text_[cursor_]))
            ++cursor_;
        if (cursor_ < lineEnd_ && text_[cursor_] == '#') {
            inComment_ = true; // a backslash at the end of a comment continues nothing: Windows paths stand there
            cursor_ = lineEnd_;
        }
        const bool atBackslash = cursor_ + 1 == lineEnd_ && text_[cursor_] == '\\';
        if (cursor_ < lineEnd_ && !atBackslash) break;
        if (!atBackslash || !nextLine()) return std::nullopt;
    }
    const std::size_t start = cursor_;
    while (cursor_ < lineEnd_ && !isBlank(text_[cursor_]) && !(text_[cursor_] == '\\' && cursor_ + 1 == lineEnd_))
        ++cursor_;
    return text_.substr(start, cursor_ - start);
}

std::string_view StatementLines::restOfLine() {
    std::size_t end = lineEnd_;
    while (cursor_ < end && isBlank(text_[cursor_]))
        ++cursor_;
    while (end > cursor_ && isBlank(text_[end - 1]))
        --end;
    const std::string_view rest = text_.substr(cursor_, end - cursor_);
    inComment_ = true; // the line has been read to its end, whatever its last character
    cursor_ = lineEnd_;
    return rest;
}

std::string StatementLines::place(std::size_t line) const { return fileName_ + ":" + std::to_string(line); }

void StatementLines::fail(const std::string& message, ExitStatus status) const {
    throw Error(status, place(line_) + ": " + message);
}

std::optional<double> readNumber(std::string_view token) {
    if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1); // from_chars knows no plus sign
    double value = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error == std::errc::invalid_argument || end != token.data() + token.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        // Too large or too small? A negative exponent or a leading zero makes it small.
        const std::string_view digits = token.starts_with('-') ? token.substr(1) : token;
        const bool isTiny = token.find("e-") != std::string_view::npos || token.find("E-") != std::string_view::npos ||
                            (digits.starts_with("0.") || digits.starts_with('.'));
        return isTiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return value;
}

} // namespace shadowlab::scene
