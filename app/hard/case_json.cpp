// Reads a hard case with the readers of scenes and lessons: the same keys, the same ranges, the same words.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <tuple>

#include "app/course/lessons/lesson_parts.h"
#include "app/course/state_json.h"
#include "app/hard/case.h"
#include "app/hard/quantities.h"
#include "app/picture/limits.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::hard {

namespace {

using scene::JsonDocument;
using scene::JsonObject;
using scene::JsonValue;
using scene::Range;
using course::ShownState;

constexpr int kSmallestSide = 16, kLargestSide = 2048; ///< of pictures, pixels
// Four to three, as most of the cases' numbers were found; the small ones take a sixteenth of the time.
constexpr ivec2 kSize{640, 480}, kSmallSize{160, 120};
// Of a picture of kSize: a shadow of which less is in view is no test of shadows. Fewer in a smaller picture, by its area.
constexpr Least kLeast{500, 500};
constexpr std::size_t kLongestTitle = 80, kLongestWhy = 400;

/// Family, number, letter.
std::tuple<std::size_t, int, std::string> partsOf(const std::string& id) {
    constexpr std::string_view kFamilies = "PMVRF";
    constexpr std::size_t kMostDigits =
        6; // fewer than an int holds; what follows them is no letter, and refused as one
    std::size_t digits = 1;
    int number = 0;
    while (digits < std::min(id.size(), kMostDigits + 1) && id[digits] >= '0' && id[digits] <= '9')
        number = 10 * number + (id[digits++] - '0');
    return {id.empty() ? std::string_view::npos : kFamilies.find(id[0]), number,
            id.substr(std::min(digits, id.size()))};
}

class CaseReader {
public:
    CaseReader(const std::string& text, const std::filesystem::path& file, const scene::LoadOptions& options)
        : file_(file), document_(text, file, picture::limits().jsonDepth, "a hard case, starting with {"),
          top_(document_, document_.root(), "the case",
               {"case", "title", "why", "scene", "camera", "lights", "light", "size", "smallSize", "least", "checks",
                "tests", "naiveTests", "withoutNaive", "limits"}),
          states_(document_, file_, options) {}

    Case read() {
        Case one;
        one.id = id();
        one.name = file_.stem().string();
        one.file = file_;
        one.title = course::shortText(top_, "title", kLongestTitle);
        one.why = course::shortText(top_, "why", kLongestWhy);
        one.size = size("size", kSize);
        one.smallSize = size("smallSize", kSmallSize);
        one.least = least();
        one.tests = names("tests");
        one.naiveTests = names("naiveTests");
        if (top_.find("withoutNaive")) one.withoutNaive = course::shortText(top_, "withoutNaive", kLongestWhy);
        if (top_.find("scene")) {
            // The case's own scene needs some technique to be read; any will do.
            const std::array<const JsonObject*, 2> levels{&top_, &unshadowed_};
            one.picture = states_.read(levels);
            if (one.picture->scene->lights.empty()) top_.fail("scene", "has no light; add one, or leave it out");
            for (const JsonValue& value : top_.array("checks"))
                one.checks.push_back(check(value, one.checks.size() + 1));
            for (const JsonValue& value : top_.array("limits"))
                one.limits.push_back(limit(value, one.limits.size() + 1));
        } else {
            for (const char* key : {"camera", "lights", "light", "size", "smallSize", "least", "checks", "limits"})
                if (top_.find(key)) top_.fail(key, "is about a scene, and there is none; write \"scene\"");
            if (one.tests.empty())
                top_.fail("tests", "is missing or empty, and without a scene nothing else holds the case; write "
                                   "[\"SUITE.NAME\"] of a test");
        }
        requireNaive(one);
        return one;
    }

private:
    [[nodiscard]] std::string id() const {
        std::string id = top_.text("case");
        const auto [family, number, letter] = partsOf(id);
        if (family == std::string_view::npos || number == 0 || letter.size() > 1)
            top_.fail("case", "is " + scene::inQuotes(id) + R"(; write family, number and perhaps a letter, as "P2b")");
        return id;
    }
    [[nodiscard]] ivec2 size(const char* key, ivec2 standard) const {
        if (!top_.find(key)) return standard;
        const dvec2 size = top_.pair(key, Range::between(kSmallestSide, kLargestSide));
        if (dvec2(ivec2(size)) != size) top_.fail(key, "is pixels, and these are whole; write for example [640, 480]");
        return size;
    }
    [[nodiscard]] Least least() const {
        const JsonValue* value = top_.find("least");
        if (!value) return kLeast;
        const JsonObject keys(document_, *value, "\"least\"", {"lit", "shadowed"});
        const int most = kLargestSide * kLargestSide;
        return {keys.integer("lit", 0, most, kLeast.lit), keys.integer("shadowed", 0, most, kLeast.shadowed)};
    }
    [[nodiscard]] std::vector<std::string> names(const char* key) const {
        std::vector<std::string> names;
        for (const auto& [name, offset] : course::texts(top_, key)) {
            if (name.find('.') == std::string::npos)
                document_.fail(offset, "is " + scene::inQuotes(name) + "; write SUITE.NAME of a test");
            names.push_back(name);
        }
        return names;
    }
    [[nodiscard]] int quantityOf(const JsonObject& keys) const {
        std::vector<std::string> known;
        for (const Quantity& quantity : quantities())
            known.emplace_back(quantity.id);
        return course::oneOf(keys, "quantity", keys.text("quantity"), known);
    }
    Check check(const JsonValue& value, std::size_t number) {
        const JsonObject keys(document_, value, "check " + std::to_string(number),
                              {"title", "scene", "camera", "lights", "light", "technique", "set", "expect", "naive"});
        Check check;
        check.title = keys.text("title", "");
        static_cast<void>(keys.text("technique"));
        const std::array<const JsonObject*, 2> levels{&top_, &keys};
        check.right = states_.read(levels);
        check.settings = settings(keys);
        for (const JsonValue& expected : keys.array("expect"))
            check.expectations.push_back(expectation(expected, keys, check.expectations.size() + 1));
        if (check.expectations.empty())
            keys.fail("expect", R"(is missing or empty; write [{"quantity": "wrong", "atMost": 0}])");
        if (const JsonValue* naiveValue = keys.find("naive")) {
            const JsonObject naive(document_, *naiveValue, "\"naive\" of " + keys.what(), {"set"});
            const std::array<const JsonObject*, 3> naiveLevels{&top_, &keys, &naive};
            check.naive = states_.read(naiveLevels);
            check.naiveSettings = settings(naive);
            if (check.naive->slots == check.right.slots)
                naive.fail("set", "changes nothing; write the setting that makes it careless");
        }
        return check;
    }
    Limit limit(const JsonValue& value, std::size_t number) {
        const JsonObject keys(document_, value, "limit " + std::to_string(number), {"technique", "set", "why"});
        const std::array<const JsonObject*, 2> levels{&top_, &keys};
        return {states_.read(levels).slots.front(), course::shortText(keys, "why", kLongestWhy)};
    }
    /// A check that nothing careless has failed may be one that sees nothing.
    void requireNaive(const Case& one) const {
        const bool hasNaive = !one.naiveTests.empty() || std::ranges::any_of(one.checks, [](const Check& check) {
            return check.naive.has_value();
        });
        if (hasNaive && !one.withoutNaive.empty())
            top_.fail("withoutNaive", "says why there is no careless version, and there is one; leave it out");
        if (!hasNaive && one.withoutNaive.empty())
            top_.fail("case",
                      R"(has no careless version; write "naive" in a check, "naiveTests", or in "withoutNaive" why )"
                      "there is none");
    }
    Expectation expectation(const JsonValue& value, const JsonObject& check, std::size_t number) {
        const JsonObject keys(document_, value, "expectation " + std::to_string(number) + " of " + check.what(),
                              {"quantity", "atMost", "atLeast", "from"});
        const Quantity& quantity = kQuantities[quantityOf(keys)];
        Expectation expected;
        expected.quantity = quantity.id;
        if (keys.find("atMost")) expected.bound.atMost = keys.number("atMost", Range{});
        if (keys.find("atLeast")) expected.bound.atLeast = keys.number("atLeast", Range{});
        if (!expected.bound.atMost && !expected.bound.atLeast)
            keys.fail("quantity", R"(has no bound; write "atMost": NUMBER or "atLeast": NUMBER beside it)");
        if (quantity.of == Quantity::Of::comparison) {
            const JsonObject from(document_, keys.require("from", R"({"set": ["planar.cull=false"]})"),
                                  "\"from\" of " + keys.what(),
                                  {"scene", "camera", "lights", "light", "technique", "set"});
            const std::array<const JsonObject*, 3> levels{&top_, &check, &from};
            expected.from = states_.read(levels);
        } else if (keys.find("from")) {
            keys.fail("from", "has nothing to do with " + scene::inQuotes(expected.quantity) + "; leave it out");
        }
        return expected;
    }
    [[nodiscard]] static std::vector<std::string> settings(const JsonObject& keys) {
        std::vector<std::string> settings;
        for (const auto& [setting, offset] : course::texts(keys, "set"))
            settings.push_back(setting);
        return settings;
    }

    const std::filesystem::path& file_;
    JsonDocument document_;
    JsonObject top_;
    JsonDocument plain_{R"({"technique": "unshadowed"})", "", 2, ""};
    JsonObject unshadowed_{plain_, plain_.root(), "the case", {"technique"}};
    course::StateReader states_;
};

} // namespace

bool isBefore(const std::string& id, const std::string& otherId) { return partsOf(id) < partsOf(otherId); }

Case parseCase(const std::string& text, const std::filesystem::path& file, const scene::LoadOptions& options) {
    return CaseReader(text, file, options).read();
}

Case loadCase(const std::filesystem::path& file, const scene::LoadOptions& options) {
    return parseCase(scene::readFile(file, picture::limits().sceneFileBytes, "scene-file"), file, options);
}

std::vector<std::filesystem::path> caseFiles(const std::filesystem::path& assetsRoot) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(assetsRoot / "hard", ignored))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::vector<Case> allCases(const scene::LoadOptions& options) {
    std::vector<Case> cases;
    for (const std::filesystem::path& file : caseFiles(options.assetsRoot))
        cases.push_back(loadCase(file, options));
    std::ranges::sort(cases, [](const Case& a, const Case& b) { return isBefore(a.id, b.id); });
    return cases;
}

} // namespace shadowlab::hard
