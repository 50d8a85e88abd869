// Builds the tree from nlohmann-json's SAX events. The events carry no position, but tokens arrive in order: the next
// token starts at the first character after the previous one that is neither blank, comment nor separator.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/json/json_value.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/load/unusual_characters.h"

namespace shadowlab::scene {

namespace {

using Kind = JsonValue::Kind;

/// An input iterator over the text that tells how far the lexer has read.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* consumed) : at_(at), consumed_(consumed) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        ++*consumed_;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

private:
    const char* at_;
    std::size_t* consumed_;
};

/// Offset of the first character at or after `offset` that begins a token.
std::size_t skipToToken(std::string_view text, std::size_t offset) {
    if (offset == 0 && text.starts_with("\xef\xbb\xbf")) offset = 3; // UTF-8 byte order mark
    while (offset < text.size()) {
        if (std::string_view(" \t\r\n,:").find(text[offset]) != std::string_view::npos)
            ++offset;
        else if (text.substr(offset, 2) == "//")
            offset = std::min(text.find_first_of("\r\n", offset), text.size());
        else if (text.substr(offset, 2) == "/*")
            offset = std::min(text.find("*/", offset + 2), text.size() - 2) + 2;
        else
            break;
    }
    return offset;
}

constexpr std::size_t kLongestSequence = 4; ///< bytes of one character in UTF-8

/// What nlohmann-json calls back. Values under construction wait on a stack; a finished one moves into its parent.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
    TreeBuilder(const JsonDocument& document, const std::size_t& consumed, std::uint32_t maximumDepth,
                std::string_view content)
        : document_(document), consumed_(consumed), maximumDepth_(maximumDepth), content_(content) {}

    JsonValue takeRoot() { return std::move(root_); }

    bool null() override { return add(startOf(Kind::null, tokenStart())); }
    bool boolean(bool value) override {
        JsonValue found = startOf(Kind::boolean, tokenStart());
        found.boolean = value;
        return add(std::move(found));
    }
    bool number_integer(number_integer_t value) override { return addNumber(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return addNumber(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return addNumber(value); }
    bool string(string_t& value) override {
        requireNoNul(value);
        JsonValue found = startOf(Kind::string, tokenStart());
        lastTextStart_ = found.offset;
        found.string = std::move(value);
        add(std::move(found));
        lastTextEnd_ = lastEnd_;
        return true;
    }
    bool binary(binary_t&) override { return false; } // never occurs in JSON text
    bool start_object(std::size_t) override { return open(Kind::object); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(Kind::array); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        requireNoNul(key);
        const std::size_t offset = tokenStart();
        Frame& object = stack_.back();
        const auto [earlier, isNew] = object.keyOffsets.emplace(key, offset);
        if (!isNew)
            document_.fail(offset, "key \"" + shown(key) + "\" appears twice in one object, first at " +
                                       document_.place(earlier->second) + "; delete one of them");
        object.value.members.push_back({std::move(key), offset, {}});
        lastTextStart_ = offset;
        lastTextEnd_ = lastEnd_ = consumed_;
        return true;
    }

    /// `position` counts the characters read when the fault was noticed.
    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& error) override {
        const std::string& text = document_.text();
        const std::size_t noticed = std::min(position == 0 ? 0 : position - 1, text.size());
        // "[json.exception.parse_error.101] parse error at line 3, column 8: syntax error ..." -> "syntax error ..."
        std::string what = error.what();
        if (const std::size_t column = what.find(", column "); column != std::string::npos)
            what = what.substr(what.find(": ", column) + 2);
        else if (const std::size_t end = what.find("] "); end != std::string::npos)
            what = what.substr(end + 2);
        // The excerpt "; last read: '...'" may hold half the file; the place says it better.
        if (const std::size_t excerpt = what.find("; last read: '"); excerpt != std::string::npos) {
            const std::size_t end = what.rfind("'; expected");
            what.erase(excerpt, end == std::string::npos ? std::string::npos : end + 1 - excerpt);
        }
        if (skipToToken(text, 0) >= text.size() && what.find("invalid comment") == std::string::npos)
            document_.fail(noticed, "the file holds no JSON value; write " + std::string(content_));
        // Inside a string the very character is at fault, elsewhere the token that begins after the last good one.
        const bool inString = what.find("invalid string") != std::string::npos;
        nameUnusualCharacter(std::min(noticed, tokenStart()), noticed, inString);
        if (what.find("after backslash") != std::string::npos)
            what += "; in a path write / between folders, elsewhere \\\\ for a backslash";
        document_.fail(inString ? noticed : std::min(noticed, tokenStart()), shown(what, 200) + "; fix the JSON here");
    }

private:
    struct Frame {
        JsonValue value;
        std::unordered_map<std::string, std::size_t> keyOffsets;
    };

    /// Fails at a character that looks like one of JSON's, where it is to blame: from the faulty token to where the fault was noticed.
    /// Within a text only a curly quote can be, which was to end it: there, and in the text before, which then ran on.
    void nameUnusualCharacter(std::size_t start, std::size_t noticed, bool inString) const {
        const std::string_view text = document_.text();
        const std::size_t end = std::min(noticed + kLongestSequence, text.size());
        for (auto found = unusualCharacter(text.substr(0, end), start); found && found->offset <= noticed;
             found = unusualCharacter(text.substr(0, end), found->offset + found->length))
            if (!inString || found->isDoubleQuote)
                document_.fail(found->offset, found->name + " stands here, which JSON does not know; " + found->remedy);
        if (lastTextEnd_ != lastEnd_) return;
        const std::string_view before = text.substr(0, lastTextEnd_);
        std::optional<UnusualCharacter> quote;
        std::size_t quotes = 0;
        for (auto found = unusualCharacter(before, lastTextStart_); found;
             found = unusualCharacter(before, found->offset + found->length))
            if (found->isDoubleQuote && quotes++ == 0) quote = found;
        if (quotes % 2 == 1) // pairs of them are part of a sentence
            document_.fail(quote->offset,
                           quote->name + " stands in this text, which may have been meant to end it; " + quote->remedy);
    }

    /// Names, paths and settings go into messages and to the system, where a NUL byte would end them.
    void requireNoNul(const std::string& text) const {
        if (text.find('\0') != std::string::npos)
            document_.fail(tokenStart(), "the text holds a NUL character; leave out \\u0000");
    }
    static JsonValue startOf(Kind kind, std::size_t offset) {
        JsonValue value;
        value.kind = kind;
        value.offset = offset;
        return value;
    }

    [[nodiscard]] std::size_t tokenStart() const { return skipToToken(document_.text(), lastEnd_); }

    bool addNumber(double value) {
        const std::size_t start = tokenStart();
        JsonValue found = startOf(Kind::number, start);
        found.number = value;
        const bool added = add(std::move(found));
        // The lexer sees the end of a number only by reading one character too many.
        const std::size_t end = document_.text().find_first_not_of("+-.0123456789eE", start);
        lastEnd_ = std::min(end, document_.text().size());
        return added;
    }

    bool add(JsonValue value) {
        lastEnd_ = consumed_;
        if (stack_.empty())
            root_ = std::move(value);
        else if (JsonValue& parent = stack_.back().value; parent.kind == Kind::array)
            parent.items.push_back(std::move(value));
        else
            parent.members.back().value = std::move(value);
        return true;
    }

    bool open(Kind kind) {
        const std::size_t offset = tokenStart();
        if (stack_.size() >= maximumDepth_)
            document_.fail(offset,
                           "nested deeper than " + std::to_string(maximumDepth_) +
                               " levels; flatten the file, or set --limit json-depth=VALUE",
                           ExitStatus::overLimit);
        lastEnd_ = consumed_;
        stack_.push_back({.value = startOf(kind, offset), .keyOffsets = {}});
        return true;
    }

    bool close() {
        JsonValue value = std::move(stack_.back().value);
        stack_.pop_back();
        return add(std::move(value));
    }

    const JsonDocument& document_;
    const std::size_t& consumed_;
    std::uint32_t maximumDepth_;
    std::string_view content_;
    std::size_t lastEnd_ = 0;                         ///< where the last token ended
    std::size_t lastTextStart_ = 0, lastTextEnd_ = 0; ///< of the last token that is a text
    std::vector<Frame> stack_;
    JsonValue root_;
};

} // namespace

std::string_view describe(JsonValue::Kind kind) {
    switch (kind) {
    case Kind::null: return "null";
    case Kind::boolean: return "true or false";
    case Kind::number: return "a number";
    case Kind::string: return "a string";
    case Kind::array: return "an array";
    case Kind::object: return "an object";
    }
    return "";
}

JsonDocument::JsonDocument(std::string text, const std::filesystem::path& file, std::uint32_t maximumDepth,
                           std::string_view content)
    : text_(utf8Text(std::move(text), file)), fileName_(shownPath(file)) {
    // nlohmann-json takes a NUL byte for the end and would never see what follows.
    if (const std::size_t nul = text_.find('\0'); nul != std::string::npos)
        fail(nul, "binary data (a NUL byte); write a JSON text");
    std::size_t consumed = 0;
    TreeBuilder builder(*this, consumed, maximumDepth, content);
    const char* begin = text_.data();
    nlohmann::json::sax_parse(CountingIterator(begin, &consumed), CountingIterator(begin + text_.size(), &consumed),
                              &builder, nlohmann::json::input_format_t::json, /*strict=*/true,
                              /*ignore_comments=*/true);
    root_ = builder.takeRoot();
}

std::string JsonDocument::place(std::size_t offset) const {
    // A line ends at CR LF, LF or CR alone.
    std::size_t line = 1, lineStart = text_.starts_with("\xef\xbb\xbf") ? 3 : 0;
    offset = std::min(offset, text_.size());
    for (std::size_t i = 0; i < offset; ++i)
        if (text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'))) {
            ++line;
            lineStart = i + 1;
        }
    const auto isFirstByte = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    std::size_t column = 1;
    for (std::size_t i = lineStart; i < offset; ++i)
        column += isFirstByte(text_[i]) ? 1 : 0;
    return fileName_ + ":" + std::to_string(line) + ":" + std::to_string(column);
}

void JsonDocument::fail(std::size_t offset, const std::string& message, ExitStatus status) const {
    throw Error(status, place(offset) + ": " + message);
}

} // namespace shadowlab::scene
