// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson_parts.h"

#include <algorithm>

#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

using scene::JsonObject;
using scene::JsonValue;

std::string shortText(const JsonObject& object, std::string_view key, std::size_t longest) {
    std::string text = object.text(key);
    if (text.empty()) object.fail(key, "is empty; write it, or leave the lesson out");
    if (text.size() > longest)
        object.fail(key, "has " + std::to_string(text.size()) + " characters, and " + std::to_string(longest) +
                             " fit below a picture; make it shorter");
    return text;
}

std::vector<std::pair<std::string, std::size_t>> texts(const JsonObject& object, std::string_view key) {
    std::vector<std::pair<std::string, std::size_t>> texts;
    for (const JsonValue& value : object.array(key)) {
        if (value.kind != JsonValue::Kind::string)
            object.document().fail(value.offset, "each of \"" + std::string(key) + "\" is a text, and this is " +
                                                     std::string(scene::describe(value.kind)) + "; put it in quotes");
        texts.emplace_back(value.string, value.offset);
    }
    return texts;
}

int oneOf(const JsonObject& object, std::string_view key, const std::string& text,
          const std::vector<std::string>& known) {
    const auto found = std::ranges::find(known, text);
    if (found == known.end()) object.fail(key, "is " + scene::inQuotes(text) + "; " + suggestion(text, known));
    return static_cast<int>(found - known.begin());
}

std::map<std::string, lab::Values> settingsOf(const picture::Slot& slot) {
    std::map<std::string, lab::Values> settings;
    for (const params::Param& param : slot.params)
        if (params::valueText(param) != params::initialText(param))
            settings[std::string(slot.info->id)][param.id] = params::valueText(param);
    return settings;
}

LookBox readBox(const JsonObject& keys) {
    const JsonValue& numbers = keys.require("box", "[0.4, 0.4, 0.2, 0.2]");
    const std::string remedy = "is not four numbers; write [left, top, width, height] in shares of the picture, "
                             "as [0.4, 0.4, 0.2, 0.2]";
    if (numbers.kind != JsonValue::Kind::array || numbers.items.size() != 4) keys.fail("box", remedy);
    std::array<double, 4> box{};
    for (std::size_t i = 0; i < box.size(); ++i) {
        if (numbers.items[i].kind != JsonValue::Kind::number) keys.fail("box", remedy);
        box[i] = numbers.items[i].number;
    }
    const bool inside =
        box[0] >= 0 && box[1] >= 0 && box[2] > 0 && box[3] > 0 && box[0] + box[2] <= 1 && box[1] + box[3] <= 1;
    if (!inside) keys.fail("box", "reaches beyond the picture, or is empty; its numbers are shares, from 0 to 1");
    return {{box[0], box[1]}, {box[2], box[3]}, ""};
}

void readLook(const JsonObject& top, Lesson& lesson) {
    for (const JsonValue& value : top.array("look")) {
        const JsonObject look(top.document(), value, "box " + std::to_string(lesson.look.size() + 1), {"box", "label"});
        lesson.look.push_back(readBox(look));
        lesson.look.back().label = shortText(look, "label", kLongestLabel);
    }
    if (lesson.look.empty()) top.fail("look", R"(is missing or empty; write [{"box": [...], "label": "..."}])");
}

void readQuestion(const JsonObject& top, Lesson& lesson) {
    const JsonValue* value = top.find("question");
    if (!value) return;
    const JsonObject keys(top.document(), *value, "the question", {"text", "kind", "choices", "right", "picture"});
    Question question;
    question.text = shortText(keys, "text", kLongestSentence);
    question.kind = static_cast<Question::Kind>(oneOf(keys, "kind", keys.text("kind", "choice"), {"choice", "mark"}));
    for (const auto& [choice, offset] : texts(keys, "choices"))
        question.choices.push_back(choice);
    if (question.kind == Question::Kind::mark) {
        for (const char* key : {"choices", "right", "picture"})
            if (keys.find(key)) keys.fail(key, "is there for \"kind\": \"choice\"; leave it out");
    } else {
        constexpr int kMostChoices = 4;
        const auto count = static_cast<int>(question.choices.size());
        if (count < 2 || count > kMostChoices) keys.fail("choices", "are two to four; write as many");
        question.right = keys.integer("right", 1, count) - 1;
        question.picture =
            static_cast<std::size_t>(oneOf(keys, "picture", keys.text("picture", "before"), {"before", "after"}));
    }
    lesson.question = std::move(question);
}

} // namespace shadowlab::course
