// The JSON of a glTF file, checked: every key that is read has the type, the range and the target that the specification asks for.
// Only what has passed goes on to tinygltf, which skips values of a wrong type without a word and follows indices that lead nowhere.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "techniques/foundation/scene/gltf/gltf_notes.h"
#include "techniques/foundation/scene/json/json_value.h"

namespace shadowlab::scene {

/// A checked file: its JSON, to name places by, and the notes on it so far.
class GltfSource {
public:
    /// Throws Error for the first fault. `document` must outlive this.
    explicit GltfSource(const JsonDocument& document);

    /// What was checked and is read, as JSON text for tinygltf, without buffers and images: those are read by this program.
    [[nodiscard]] const std::string& checkedText() const { return text_; }

    /// The elements of a top-level array; empty where there is none.
    [[nodiscard]] const std::vector<JsonValue>& elements(std::string_view array) const;

    /// Throws the Error "FILE:LINE:COLUMN: accessors[3] ..." at an element of a top-level array.
    [[noreturn]] void fail(std::string_view array, std::size_t index, const std::string& message,
                           ExitStatus status = ExitStatus::badInput) const;

    /// Notes that an element is not, or not wholly, shown.
    void note(std::string_view array, std::size_t index, const std::string& what, std::uint64_t times = 1);

    [[nodiscard]] const JsonDocument& document() const { return document_; }
    [[nodiscard]] GltfNotes& notes() { return notes_; }

private:
    const JsonDocument& document_;
    std::string text_;
    GltfNotes notes_;
};

/// The value of a key; nullptr where the object has none.
const JsonValue* gltfMember(const JsonValue& object, std::string_view key);

/// "accessors[3]"
std::string gltfElementName(std::string_view array, std::size_t index);

} // namespace shadowlab::scene
