// The parts of the reader of lessons (docs/lessons.md), and the small readers that they share.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/course/lessons/lesson.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/json/json_object.h"

namespace shadowlab::course {

/// Turns an error about an option of the command line into one about the place in the file.
template <typename Do>
auto saidAt(const scene::JsonDocument& document, std::size_t offset, const Do& what) {
    try {
        return what();
    } catch (const Error& error) {
        std::string message = error.what();
        if (message.starts_with("--set: ")) message.erase(0, 7);
        document.fail(offset, message);
    }
}

/// A text that is there, and fits below a picture.
std::string shortText(const scene::JsonObject& object, std::string_view key, std::size_t longest);

/// A list of texts, each with its place in the file.
std::vector<std::pair<std::string, std::size_t>> texts(const scene::JsonObject& object, std::string_view key);

/// Index of the text among those that are known.
int oneOf(const scene::JsonObject& object, std::string_view key, const std::string& text,
          const std::vector<std::string>& known);

/// What differs from the defaults, as panes keep it.
std::map<std::string, lab::Values> settingsOf(const picture::Slot& slot);

// What fits below a picture in type that is read from the last row.
constexpr std::size_t kLongestTitle = 60, kLongestSentence = 260, kLongestLabel = 40;

/// "box": [left, top, width, height] in shares of a picture; without a label.
LookBox readBox(const scene::JsonObject& keys);

// Each reads what `top`, the lesson's object, has under one key.
void readLook(const scene::JsonObject& top, Lesson& lesson);
void readQuestion(const scene::JsonObject& top, Lesson& lesson);
/// Needs the states, the motion and the boxes.
void readExpectations(const scene::JsonObject& top, Lesson& lesson);

} // namespace shadowlab::course
