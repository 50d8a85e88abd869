// The reader of lessons: what a file may say, and every fault with its line and column.
// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson.h"

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::course {
namespace {

constexpr const char* kLesson = R"({
  "title": "T", // a comment
  "scene": "still-life",
  "slots": [{"technique": "shadow-map"}],
  "set": ["shadow-map.resolution=512"],
  "before": {"set": ["shadow-map.bias-mode=none"]},
  "after": {"set": [], "stage": "visibility@key", "lights": [{"name": "key", "intensity": 3}]},
  "happens": "H.", "mends": "M.",
  "look": [{"box": [0.1, 0.2, 0.3, 0.4], "label": "here"}],
  "expect": [{"quantity": "falseShadow", "look": 1, "before": {"atLeast": 5}, "after": {"atMost": 1}}]
})";

Lesson parsed(const std::string& text) {
    return parseLesson(text, "x.json", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}
std::string with(std::string text, const std::string& what, const std::string& instead) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), instead);
}

TEST(Lesson, StatesShareWhatStandsAboveThem) {
    const Lesson lesson = parsed(kLesson);
    EXPECT_EQ(lesson.text.name, "x");
    EXPECT_EQ(lesson.text.title, "T");
    const auto& [before, after] = lesson.states;
    EXPECT_EQ(before.slots[0].values(), (lab::Values{{"bias-mode", "none"}, {"resolution", "512"}}));
    EXPECT_EQ(after.slots[0].values(), (lab::Values{{"resolution", "512"}}));
    EXPECT_TRUE(before.slots[0].stage.isPicture());
    EXPECT_EQ(after.slots[0].stage.text(), "visibility@key");
    EXPECT_EQ(before.scene->lights[0].intensity, 18);
    EXPECT_EQ(after.scene->lights[0].intensity, 3);
    EXPECT_EQ(before.settings, std::vector<std::string>{"shadow-map.bias-mode=none"}); // those of the state alone
    ASSERT_EQ(lesson.expectations.size(), 1u);
    EXPECT_EQ(lesson.expectations[0].look, 0);
    EXPECT_TRUE(lesson.expectations[0].before.holds(5));
    EXPECT_FALSE(lesson.expectations[0].before.holds(4.9));
    EXPECT_FALSE(lesson.expectations[0].after.holds(1.1));
    EXPECT_FALSE(lesson.question);
}

TEST(Lesson, Utf16IsReadAsUtf8IsAndKeepsItsPlaces) {
    const auto utf16 = [](const std::string& ascii) {
        std::string bytes = "\xff\xfe"; // the mark of the order in which a pair begins with its low byte
        for (const char c : ascii)
            bytes += {c, '\0'};
        return bytes;
    };
    EXPECT_EQ(parsed(utf16(kLesson)).text.title, "T");
    try {
        (void)parsed(utf16(with(kLesson, "\"scene\"", "\"scenery\"")));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("x.json:3:3: unknown key")) << error.what();
    }
}

TEST(Lesson, BoxesKeepTheirPlaceOnThingsInPicturesOfOtherShapes) {
    const LookBox box =
        inPictureOf(8.0 / 9, {{0.4, 0.2}, {0.2, 0.5}, ""}); // half as wide: what is seen is twice as wide
    EXPECT_NEAR(box.corner.x, 0.3, 1e-12);
    EXPECT_NEAR(box.size.x, 0.4, 1e-12);
    EXPECT_EQ(box.corner.y, 0.2);
    EXPECT_EQ(box.size.y, 0.5);
}

TEST(Lesson, EveryFaultIsToldWithItsPlace) {
    struct Case {
        const char *what, *instead, *place, *message;
    };
    const Case cases[] = {
        {R"("title": "T")", R"("titel": "T")", "x.json:2:3: ", "titel"},
        {R"("title": "T",)", R"("title": "T", "title": "U",)", "x.json:2:17: ", "title"},
        {R"("title": "T")", R"("title": "")", "x.json:2:12: ", "empty"},
        {R"("still-life")", R"("still-lif")", "x.json:3:12: ", "did you mean"},
        {R"("still-life")", R"("/etc/x.json")", "x.json:3:12: ", "outside"},
        {R"("shadow-map"})", R"("shadow-mop"})", "x.json:4:", "shadow-map"},
        {R"("slots": [{"technique": "shadow-map"}])", R"("slots": [])", "x.json:4:12: ", "missing or empty"},
        {R"("shadow-map.resolution=512")", R"("shadow-map.resolution=5")", "x.json:5:11: ", "64..32768"},
        {R"("shadow-map.bias-mode=none")", R"("planar.once=false")", "x.json:6:22: ", "no slot"},
        {R"("set": [], )", R"("set": [7], )", "x.json:7:21: ", "quotes"},
        {R"("visibility@key")", R"("visibility@kez")", "x.json:7:33: ", "key"},
        {R"({"name": "key")", R"({"name": "kez")", "x.json:7:71: ", "no such light"},
        {R"([0.1, 0.2, 0.3, 0.4])", R"([0.1, 0.2, 0.3, 0.9])", "x.json:9:20: ", "beyond the picture"},
        {R"([0.1, 0.2, 0.3, 0.4])", R"([0.1, 0.2, 0.3])", "x.json:9:20: ", "four numbers"},
        {R"("falseShadow")", R"("falseShade")", "x.json:10:27: ", "falseShadow"},
        {R"("look": 1)", R"("look": 2)", "x.json:10:50: ", "1"},
        {R"({"atLeast": 5})", R"({})", "x.json:10:", "no bound"},
        {R"({"atLeast": 5})", R"({"atLeast": 0})", "x.json:10:", "nothing has to change"},
        {R"("look": 1)", R"("pixel": [0.5, 0.5])", "x.json:10:", "nothing to do with"},
        {R"("falseShadow")", R"("flips")", "x.json:10:27: ", "motion"},
        {R"("happens": "H.",)", R"("happens": "H.", "question": {"text": "?", "choices": ["a", "b"], "right": 3},)",
         "x.json:8:", "right"},
        {R"("happens": "H.",)", R"("happens": "H.", "question": {"text": "?", "kind": "mark", "choices": ["a", "b"]},)",
         "x.json:8:", "leave it out"},
        {R"("happens": "H.",)", R"("happens": "H.", "layout": "grid",)", "x.json:8:30: ", "4 techniques"},
    };
    int told = 0;
    for (const Case& one : cases) {
        try {
            parsed(with(kLesson, one.what, one.instead));
            ADD_FAILURE() << one.instead << " was taken";
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_EQ(error.status(), ExitStatus::badInput) << message;
            EXPECT_TRUE(message.starts_with(one.place)) << message << "\nnot at " << one.place;
            EXPECT_NE(message.find(one.message), std::string::npos) << message << "\ndoes not say " << one.message;
            EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
            ++told;
        }
    }
    EXPECT_EQ(told, 23);
}

TEST(Lesson, UnknownNamesAreToldWithTheirNeighbours) {
    try {
        loadLesson("acna", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("acne"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace shadowlab::course
