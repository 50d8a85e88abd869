// The checks of JsonObject, and their error messages.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/json/json_object.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/unusual_characters.h"

namespace shadowlab::scene {

namespace {

/// How a wrong value is repeated in the message: numbers and texts literally, the rest by kind.
std::string echo(const JsonValue& value) {
    switch (value.kind) {
    case JsonValue::Kind::number: return numberText(value.number);
    case JsonValue::Kind::string: {
        const auto unusual = unusualCharacter(value.string);
        return "the string " + inQuotes(value.string) + (unusual ? " with " + unusual->name : std::string());
    }
    case JsonValue::Kind::boolean: return value.boolean ? "true" : "false";
    case JsonValue::Kind::array: return "an array of " + std::to_string(value.items.size());
    default: return std::string(describe(value.kind));
    }
}

} // namespace

std::string Range::text() const {
    const std::string from = (lowIncluded ? "from " : "above ") + numberText(low);
    if (lowIncluded && highIncluded) return from + " to " + numberText(high);
    return from + (highIncluded ? " and at most " : " and below ") + numberText(high);
}

JsonObject::JsonObject(const JsonDocument& document, const JsonValue& value, std::string what,
                       std::initializer_list<std::string_view> known)
    : document_(document), value_(value), what_(std::move(what)) {
    if (value.kind != JsonValue::Kind::object)
        document.fail(value.offset, what_ + " is " + echo(value) + "; it must be an object { ... }");
    for (const JsonMember& member : value.members)
        if (std::ranges::find(known, member.key) == known.end()) {
            const std::vector<std::string> names(known.begin(), known.end());
            const auto unusual = unusualCharacter(member.key);
            document.fail(member.keyOffset, "unknown key " + inQuotes(member.key) + " in " + what_ +
                                                (unusual ? ", with " + unusual->name : std::string()) + "; " +
                                                suggestion(member.key, names));
        }
}

const JsonValue* JsonObject::find(std::string_view key) const {
    const auto found = std::ranges::find(value_.members, key, &JsonMember::key);
    return found == value_.members.end() ? nullptr : &found->value;
}

const JsonValue& JsonObject::require(std::string_view key, std::string_view example) const {
    if (const JsonValue* found = find(key)) return *found;
    document_.fail(value_.offset,
                   what_ + " has no " + inQuotes(key) + "; add " + inQuotes(key) + ": " + std::string(example));
}

void JsonObject::fail(std::string_view key, const std::string& problem, ExitStatus status) const {
    const JsonValue* found = find(key);
    const auto unusual = unusualCharacter(found ? found->string : std::string());
    document_.fail(found ? found->offset : value_.offset,
                   inQuotes(key) + " of " + what_ + " " + problem +
                       (unusual ? " (its text holds " + unusual->name + ")" : std::string()),
                   status);
}

double JsonObject::checkedNumber(std::string_view key, const JsonValue& value, const Range& range) const {
    if (value.kind == JsonValue::Kind::number && range.contains(value.number)) return value.number;
    document_.fail(value.offset,
                   inQuotes(key) + " of " + what_ + " is " + echo(value) + "; it must be a number " + range.text());
}

double JsonObject::number(std::string_view key, const Range& range, std::optional<double> fallback) const {
    const JsonValue* found = find(key);
    if (!found && fallback) return *fallback;
    return checkedNumber(key, found ? *found : require(key, "a number " + range.text()), range);
}

int JsonObject::integer(std::string_view key, int low, int high, std::optional<int> fallback) const {
    const JsonValue* found = find(key);
    if (!found && fallback) return *fallback;
    const Range range = Range::between(low, high);
    // Without an exponent: 100000, not 1e+05.
    const std::string wanted = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
    const JsonValue& value = found ? *found : require(key, wanted);
    if (value.kind != JsonValue::Kind::number || !range.contains(value.number) ||
        value.number != std::floor(value.number))
        document_.fail(value.offset, inQuotes(key) + " of " + what_ + " is " + echo(value) + "; it must be " + wanted);
    return static_cast<int>(value.number);
}

bool JsonObject::boolean(std::string_view key, bool fallback) const {
    const JsonValue* found = find(key);
    if (!found) return fallback;
    if (found->kind != JsonValue::Kind::boolean) fail(key, "is " + echo(*found) + "; it must be true or false");
    return found->boolean;
}

std::string JsonObject::text(std::string_view key, std::optional<std::string> fallback) const {
    const JsonValue* found = find(key);
    if (!found && fallback) return *fallback;
    const JsonValue& value = found ? *found : require(key, "\"...\"");
    if (value.kind != JsonValue::Kind::string) fail(key, "is " + echo(value) + "; it must be a string");
    if (value.string.empty()) fail(key, "is empty; give it at least one character");
    // Names and paths end up in one-line messages and tables.
    for (const char c : value.string)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            fail(key, "holds a control character; use printable text, and in a path / between folders");
    return value.string;
}

void JsonObject::checkNumbers(std::string_view key, const JsonValue& value, std::size_t count, const Range& range,
                              double* out) const {
    if (value.kind != JsonValue::Kind::array || value.items.size() != count)
        document_.fail(value.offset, inQuotes(key) + " of " + what_ + " is " + echo(value) +
                                         "; it must be an array of " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i)
        out[i] = checkedNumber(key, value.items[i], range);
}

dvec3 JsonObject::vector(std::string_view key, const Range& range, std::optional<dvec3> fallback) const {
    const JsonValue* found = find(key);
    if (!found && fallback) return *fallback;
    dvec3 result;
    checkNumbers(key, found ? *found : require(key, "[x, y, z]"), 3, range, &result.x);
    return result;
}

dvec2 JsonObject::pair(std::string_view key, const Range& range) const {
    dvec2 result;
    checkNumbers(key, require(key, "[a, b]"), 2, range, &result.x);
    return result;
}

dvec3 JsonObject::direction(std::string_view key, const Range& range, std::optional<dvec3> fallback) const {
    const dvec3 result = vector(key, range, fallback);
    // The squares of components below 1e-150 underflow: such a vector has no direction either.
    if (!(glm::dot(result, result) > 0.0)) fail(key, "has no length; make one of its numbers other than 0");
    return result;
}

vec3 JsonObject::color(std::string_view key, const Range& range, const vec3& fallback) const {
    return vec3(vector(key, range, dvec3(fallback)));
}

std::span<const JsonValue> JsonObject::array(std::string_view key) const {
    const JsonValue* found = find(key);
    if (!found) return {};
    if (found->kind != JsonValue::Kind::array) fail(key, "is " + echo(*found) + "; it must be an array [ ... ]");
    return found->items;
}

} // namespace shadowlab::scene
