// Line and token scanning for OBJ and MTL texts.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/statement_lines.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>

#include "techniques/foundation/scene/load/message_text.h"

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

std::string_view StatementLines::restOfStatement() {
    std::string_view rest = restOfLine();
    const auto goesOn = [&] { return rest.ends_with('\\') && (rest.size() == 1 || isBlank(rest[rest.size() - 2])); };
    while (goesOn() && nextLine()) {
        const std::string_view more = restOfLine();
        rest = {rest.data(), static_cast<std::size_t>(more.data() + more.size() - rest.data())};
    }
    return rest;
}

std::string StatementLines::place(std::size_t line) const { return fileName_ + ":" + std::to_string(line); }

void StatementLines::fail(const std::string& message, ExitStatus status) const {
    throw Error(status, place(line_) + ": " + message);
}

std::string onOneLine(std::string_view statement) {
    std::string line;
    for (std::size_t at = 0; at < statement.size();) {
        const std::size_t end = std::min(statement.find_first_of("\r\n", at), statement.size());
        line += statement.substr(at, end - at);
        if (end < statement.size()) line.back() = ' '; // the backslash
        at = std::min(statement.find_first_not_of("\r\n", end), statement.size());
    }
    return line;
}

namespace {

/// The power of ten that a positive decimal number is just below: 3 for 123.4, -1 for 0.01234, 2 for 0.5e2.
std::int64_t powerOfTen(std::string_view number) {
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    const std::string_view digits = number.substr(0, e);
    std::string_view exponentText = number.substr(std::min(e + 1, number.size()));
    if (exponentText.starts_with('+')) exponentText.remove_prefix(1);
    std::int64_t exponent = 0;
    const auto [end, error] = std::from_chars(exponentText.data(), exponentText.data() + exponentText.size(), exponent);
    constexpr std::int64_t kBeyondAll = std::int64_t{1} << 62;
    if (error == std::errc::result_out_of_range) exponent = exponentText.starts_with('-') ? -kBeyondAll : kBeyondAll;
    const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
    const auto first = static_cast<std::int64_t>(std::min(digits.find_first_of("123456789"), digits.size()));
    return (first < point ? point - first : point + 1 - first) + std::clamp(exponent, -kBeyondAll, kBeyondAll);
}

/// NaN and infinity as programs of Microsoft's C library wrote them before 2015: 1.#QNAN, -1.#IND, 1.#INF, with digits behind, or
/// "rounded", such as 1.#R and -1.#J.
std::optional<double> readWindowsNan(std::string_view token) {
    if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
    if (!token.starts_with("1.#") || token.size() < 4) return std::nullopt;
    token.remove_prefix(3);
    const auto isAllowed = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '-';
    };
    if (!std::ranges::all_of(token, isAllowed)) return std::nullopt;
    return token.starts_with("INF") ? std::numeric_limits<double>::infinity()
                                    : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::optional<double> readNumber(std::string_view token) {
    if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1); // from_chars knows no plus sign
    double value = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error == std::errc::invalid_argument || end != token.data() + token.size()) return readWindowsNan(token);
    if (error == std::errc::result_out_of_range) {
        const std::string_view size = token.starts_with('-') ? token.substr(1) : token;
        return powerOfTen(size) <= 0 ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return value;
}

} // namespace shadowlab::scene
