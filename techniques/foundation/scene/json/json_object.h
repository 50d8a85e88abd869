// Strict access to one JSON object: unknown keys, missing keys, wrong types and values out of range all become errors that
// name file, line, column, what was expected and the remedy.
// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/json/json_value.h"

namespace shadowlab::scene {

/// The numbers a key accepts. Every scene number is finite; beyond +-1e15 (Limits::coordinate) float squares overflow.
struct Range {
    double low = -1e15, high = 1e15;
    bool lowIncluded = true, highIncluded = true;

    [[nodiscard]] bool contains(double value) const {
        return (lowIncluded ? value >= low : value > low) && (highIncluded ? value <= high : value < high);
    }
    [[nodiscard]] std::string text() const; ///< "above 0 and below 180", "from 0 to 1e+15" ...

    static Range any(double limit) { return {-limit, limit}; }
    static Range between(double low, double high) { return {low, high}; }
    static Range strictlyBetween(double low, double high) { return {low, high, false, false}; }
    static Range above(double low, double limit) { return {low, limit, false, true}; }
    static Range atLeast(double low, double limit) { return {low, limit}; }
};

class JsonObject {
public:
    /// `what` names the object in messages: "the camera", "light 2". Fails unless `value` is an object all of whose
    /// keys are `known`.
    JsonObject(const JsonDocument& document, const JsonValue& value, std::string what,
               std::initializer_list<std::string_view> known);

    [[nodiscard]] const JsonValue* find(std::string_view key) const; ///< nullptr when absent
    [[nodiscard]] const JsonValue& require(std::string_view key, std::string_view example) const;

    // Each returns the fallback when the key is absent; without a fallback the key is required.
    [[nodiscard]] double number(std::string_view key, const Range& range, std::optional<double> fallback = {}) const;
    [[nodiscard]] int integer(std::string_view key, int low, int high, std::optional<int> fallback = {}) const;
    [[nodiscard]] bool boolean(std::string_view key, bool fallback) const;
    [[nodiscard]] std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
    [[nodiscard]] dvec3 vector(std::string_view key, const Range& range, std::optional<dvec3> fallback = {}) const;
    [[nodiscard]] dvec2 pair(std::string_view key, const Range& range) const;
    /// A vector that is a direction: its length is not zero. Not normalised.
    [[nodiscard]] dvec3 direction(std::string_view key, const Range& range, std::optional<dvec3> fallback = {}) const;
    [[nodiscard]] vec3 color(std::string_view key, const Range& range, const vec3& fallback) const;
    /// The elements of an array; none when the key is absent.
    [[nodiscard]] std::span<const JsonValue> array(std::string_view key) const;

    /// Throws at the value of `key` (at the object when the key is absent): `"key" of WHAT PROBLEM`.
    [[noreturn]] void fail(std::string_view key, const std::string& problem,
                           ExitStatus status = ExitStatus::badInput) const;

    [[nodiscard]] const JsonValue& value() const { return value_; }
    [[nodiscard]] const std::string& what() const { return what_; }
    [[nodiscard]] const JsonDocument& document() const { return document_; }

private:
    [[nodiscard]] double checkedNumber(std::string_view key, const JsonValue& value, const Range& range) const;
    void checkNumbers(std::string_view key, const JsonValue& value, std::size_t count, const Range& range,
                      double* out) const;

    const JsonDocument& document_;
    const JsonValue& value_;
    std::string what_;
};

} // namespace shadowlab::scene
