// JSON as a tree that remembers where in the text each key and value stands, so that every later complaint can name
// line and column. nlohmann-json does the parsing (its own tree keeps no places); see json_value.cpp.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/base/error.h"

namespace shadowlab::scene {

struct JsonMember;

struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };
    Kind kind = Kind::null;
    std::size_t offset = 0; ///< of its first character in the text
    bool boolean = false;
    double number = 0.0;
    std::string string{};
    std::vector<JsonValue> items{};  ///< of an array
    std::vector<JsonMember> members; ///< of an object, in the order of the text; no key twice
};

struct JsonMember {
    std::string key;
    std::size_t keyOffset = 0;
    JsonValue value;
};

/// "a number", "an array" ...: for messages.
std::string_view describe(JsonValue::Kind kind);

/// A parsed JSON text, in UTF-8 or UTF-16. Comments are allowed, a byte order mark too; a key twice in one object is an error.
class JsonDocument {
public:
    /// `content` is what an empty file is asked to hold. Throws Error (badInput; overLimit when nested deeper than
    /// `maximumDepth`) with FILE:LINE:COLUMN.
    JsonDocument(std::string text, const std::filesystem::path& file, std::uint32_t maximumDepth,
                 std::string_view content = "a scene, starting with {");

    [[nodiscard]] const JsonValue& root() const { return root_; }

    /// "FILE:LINE:COLUMN" of an offset. Lines and columns count from 1, columns count characters.
    [[nodiscard]] std::string place(std::size_t offset) const;

    /// Throws the Error "FILE:LINE:COLUMN: message".
    [[noreturn]] void fail(std::size_t offset, const std::string& message,
                           ExitStatus status = ExitStatus::badInput) const;

    [[nodiscard]] const std::string& text() const { return text_; } ///< in UTF-8

private:
    std::string text_;
    std::string fileName_;
    JsonValue root_;
};

} // namespace shadowlab::scene
