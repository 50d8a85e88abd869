// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>

#include "app/course/explore/explore.h"
#include "app/course/explore/explored_numbers.h"
#include "app/course/lessons/lesson_parts.h"
#include "app/drawing/prose.h"
#include "app/picture/session.h"
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

namespace {

using scene::JsonObject;
using scene::JsonValue;
using scene::Range;

constexpr int kMostLampPositions = 360; ///< one for each degree of a full turn
constexpr int kMostAskPoints = 200;
constexpr std::size_t kMostSettings = 4, kMostValues = 8; ///< as many as a column of buttons shows

std::string valueText(const scene::JsonDocument& document, const JsonValue& value) {
    if (value.kind == JsonValue::Kind::string) return value.string;
    if (value.kind == JsonValue::Kind::boolean) return value.boolean ? "true" : "false";
    if (value.kind != JsonValue::Kind::number) document.fail(value.offset, "is neither a number nor a word; write for example 256");
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.10g", value.number);
    return text.data();
}

/// "shadow-map.resolution": [64, 256]; the values are tried on a slot of that technique.
ExploredSetting setting(const scene::JsonDocument& document, const scene::JsonMember& member) {
    const std::size_t dot = member.key.find('.'), offset = member.value.offset;
    if (dot == std::string::npos)
        document.fail(offset, scene::inQuotes(member.key) + " is no parameter of a technique; write for example \"shadow-map.resolution\"");
    ExploredSetting setting{member.key.substr(0, dot), member.key.substr(dot + 1), {}};
    if (member.value.kind != JsonValue::Kind::array || member.value.items.size() < 2 || member.value.items.size() > kMostValues)
        document.fail(offset, scene::inQuotes(member.key) + " takes a list of 2 to " + std::to_string(kMostValues) +
                                  " values; write for example [64, 256, 1024]");
    picture::Slot slot = saidAt(document, offset, [&] { return picture::Session::makeSlot(setting.technique); });
    for (const JsonValue& value : member.value.items) {
        const std::string written = valueText(document, value);
        const std::string text = saidAt(document, value.offset, [&] {
            params::Param& param = params::find(slot.params, setting.param, setting.technique);
            params::setFromText(param, written, setting.technique);
            return params::valueText(param);
        });
        if (std::ranges::find(setting.values, text) != setting.values.end())
            document.fail(value.offset, "the value " + text + " stands in the list twice; leave it out");
        setting.values.push_back(text);
    }
    return setting;
}

ExploreTask task(const JsonObject& explore) {
    const JsonObject own(explore.document(), *explore.find("task"), "the task", {"question", "told", "number", "picture", "at-least", "at-most"});
    ExploreTask task;
    task.question = shortText(own, "question", kLongestSentence);
    task.told = own.find("told") ? shortText(own, "told", kLongestSentence) : "";
    for (const char* key : {"question", "told"})
        if (own.find(key))
            saidAt(own.document(), own.find(key)->offset, [&] { return drawing::plainProse(own.text(key)); });
    std::vector<std::string> known;
    for (const ExploredNumber& number : kExploredNumbers)
        known.emplace_back(number.key);
    task.number = known[static_cast<std::size_t>(oneOf(own, "number", own.text("number"), known))];
    task.pane = own.integer("picture", 1, 2, 1) - 1;
    if (own.find("at-least")) task.bound.atLeast = own.number("at-least", Range::atLeast(0, 1e9));
    if (own.find("at-most")) task.bound.atMost = own.number("at-most", Range::atLeast(0, 1e9));
    if (!task.bound.atLeast && !task.bound.atMost)
        own.fail("number", R"(needs a bound by which an answer is right; write "at-least" or "at-most")");
    if (task.bound.atLeast && task.bound.atMost && *task.bound.atLeast > *task.bound.atMost)
        own.fail("at-most", R"(is less than "at-least", so no number is right; write a larger one)");
    return task;
}

} // namespace

std::optional<Explore> readExplore(const JsonObject& top) {
    const JsonValue* value = top.find("explore");
    if (!value) return {};
    Explore explore;
    if (value->kind == JsonValue::Kind::boolean) {
        if (!value->boolean) return {};
        return explore;
    }
    const JsonObject own(top.document(), *value, "explore", {"lamp", "degrees", "steps", "errors", "ask", "stages", "settings", "task"});
    explore.lampPositions = own.integer("lamp", 1, kMostLampPositions, explore.lampPositions);
    explore.lampDegrees = own.number("degrees", {-360, 360, true, true}, explore.lampDegrees);
    if (explore.lampDegrees == 0) own.fail("degrees", R"(is how far the lights turn; where they rest, write "lamp": 1)");
    explore.steps = own.boolean("steps", explore.steps);
    explore.errors = own.boolean("errors", explore.errors);
    explore.askPoints = own.integer("ask", 0, kMostAskPoints, explore.askPoints);
    for (const auto& [text, offset] : texts(own, "stages"))
        explore.stages.push_back(text);
    if (const JsonValue* settings = own.find("settings")) {
        if (settings->kind != JsonValue::Kind::object || settings->members.empty() || settings->members.size() > kMostSettings)
            own.fail("settings", "is an object of 1 to " + std::to_string(kMostSettings) +
                                     R"( parameters; write for example {"shadow-map.resolution": [64, 256, 1024]})");
        for (const scene::JsonMember& member : settings->members)
            explore.settings.push_back(setting(top.document(), member));
    }
    if (own.find("task")) explore.task = task(own);
    if (explore.task && !explore.errors && explore.task->number != "frameMs")
        own.fail("task", R"(is about errors, and "errors" is false; leave that out)");
    return explore;
}

} // namespace shadowlab::course
