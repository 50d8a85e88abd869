// What stands on sheets of random exercises, and in their keys.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string_view>

#include "app/course/exercises/kinds.h"
#include "app/course/exercises/page_filling.h"
#include "app/course/exercises/sheet_page.h"
#include "app/drawing/prose.h"
#include "techniques/foundation/base/error.h"
#include "tests/course/exercise_sheets.h"

namespace shadowlab::course {
namespace {

/// Does the number stand there as a whole, not as a part of a longer one, nor with the other sign?
bool hasNumber(const std::string& text, const std::string& number) {
    constexpr std::string_view kOfNumbers = "0123456789.-";
    for (std::size_t at = text.find(number); at != std::string::npos; at = text.find(number, at + 1)) {
        const std::size_t end = at + number.size();
        const bool isPartOfOther = (at > 0 && kOfNumbers.find(text[at - 1]) != std::string_view::npos) ||
                                   (end < text.size() && kOfNumbers.find(text[end]) != std::string_view::npos);
        if (!isPartOfOther) return true;
    }
    return false;
}

TEST(Exercises, KeySaysWhatWasComputed) {
    const std::set<std::string> inWords{"asked", "one", "A.lit",
                                        "B.lit", "F12", "F21"}; // and millionths, of form factors
    int found = 0;
    for (const std::vector<Exercise>& sheet : sheets())
        for (const Exercise& exercise : sheet) {
            std::string answers;
            for (const std::string& answer : exercise.answers)
                answers += answer + "\n";
            for (const NamedNumber& result : exercise.results) {
                if (inWords.contains(result.name) && exercise.kind != "two-patches") continue;
                if (exercise.kind == "extrusion" && result.name == "pushed.y") continue;
                ASSERT_TRUE(hasNumber(answers, printed(result.value)))
                    << exercise.kind << ", " << result.name << " = " << result.value << ": " << answers;
                ++found;
            }
            for (const std::string name : {"F12", "F21"})
                if (exercise.kind == "form-factor")
                    ASSERT_TRUE(hasNumber(answers, printed(1e6 * in(exercise.results, name)))) << answers;
        }
    EXPECT_GT(found, 40 * kSeeds);
}

// Of what is drawn on squared paper a student reads whole numbers.
TEST(Exercises, SheetSaysAllThatIsNeeded) {
    int read = 0;
    for (const std::vector<Exercise>& sheet : sheets())
        for (const Exercise& exercise : sheet) {
            std::string told = exercise.given;
            for (const std::string& question : exercise.questions)
                told += "\n" + question;
            for (const NamedNumber& number : exercise.data) {
                if (number.name == "upright") continue; // the normals say it
                const bool isDrawn =
                    exercise.figure && number.value == std::round(number.value) && std::abs(number.value) <= 20;
                ASSERT_TRUE(isDrawn || told.find(printed(number.value)) != std::string::npos)
                    << exercise.kind << ", " << number.name << " = " << number.value << ": " << told;
                ++read;
            }
        }
    EXPECT_GT(read, 60 * kSeeds);
}

TEST(Exercises, AllKindsOfAnswersOccur) {
    std::map<std::string, std::set<std::string>> answers;
    int eyeInShadow = 0, lit = 0, wraps = 0;
    for (const std::vector<Exercise>& sheet : sheets())
        for (const Exercise& exercise : sheet) {
            for (const std::string& answer : exercise.answers)
                answers[exercise.kind].insert(answer);
            if (exercise.kind != "counts") continue;
            const double before = in(exercise.results, "frontsBefore") - in(exercise.results, "backsBefore");
            eyeInShadow += in(exercise.results, "eyeCount") > 0;
            lit += in(exercise.results, "backsBeyond") == in(exercise.results, "frontsBeyond");
            wraps += before < 0;
            EXPECT_EQ(before + in(exercise.results, "eyeCount"),
                      in(exercise.results, "backsBeyond") - in(exercise.results, "frontsBeyond"));
        }
    EXPECT_GT(eyeInShadow, kSeeds / 5);
    EXPECT_GT(lit, kSeeds / 5);
    EXPECT_LT(lit, 4 * kSeeds / 5);
    EXPECT_GT(wraps, kSeeds / 20);
    for (const auto& [kind, different] : answers)
        EXPECT_GT(different.size(), 12u) << kind;
}

TEST(Exercises, NoTwoSeedsMakeTheSameSheet) {
    std::set<std::string> given, bytes;
    for (std::size_t seed = 0; seed < sheets().size(); ++seed) {
        std::string all;
        for (const Exercise& exercise : sheets()[seed])
            all += exercise.given + "\n";
        given.insert(all);
        bytes.insert(sheetPage(sheets()[seed], 1, Paper::a4)); // one title for all: what differs are the exercises
    }
    EXPECT_EQ(given.size(), static_cast<std::size_t>(kSeeds));
    EXPECT_EQ(bytes.size(), static_cast<std::size_t>(kSeeds));
    const std::vector<Exercise> again = makeExercises(17, static_cast<int>(exerciseKinds().size()), allKinds());
    EXPECT_EQ(sheetPage(again, 17, Paper::a4), sheetPage(sheets()[16], 17, Paper::a4));
    EXPECT_EQ(keyPage(again, 17, Paper::a4), keyPage(sheets()[16], 17, Paper::a4));
}

// The sheet is the same whatever the answers are, and its key is not.
TEST(Exercises, SheetHoldsNoAnswer) {
    int longAnswers = 0;
    for (std::size_t seed = 0; seed < sheets().size(); ++seed) {
        const std::string sheet = sheetPage(sheets()[seed], seed + 1, Paper::a4),
                          key = keyPage(sheets()[seed], seed + 1, Paper::a4);
        std::vector<Exercise> without = sheets()[seed];
        for (Exercise& exercise : without) {
            for (std::string& answer : exercise.answers) {
                ASSERT_NE(key.find(drawing::proseMarkup(answer)), std::string::npos);
                if (answer.size() >= 16) { // a number alone may stand anywhere
                    ASSERT_EQ(sheet.find(drawing::proseMarkup(answer)), std::string::npos)
                        << exercise.kind << ": " << answer;
                    ++longAnswers;
                }
                answer.clear();
            }
            ASSERT_EQ(exercise.questions.size(), exercise.answers.size());
            ASSERT_EQ(sheet.find(drawing::proseMarkup(exercise.working)), std::string::npos);
            exercise.working.clear(), exercise.mistake.clear(), exercise.results.clear();
        }
        ASSERT_EQ(sheetPage(without, seed + 1, Paper::a4), sheet);
    }
    EXPECT_GT(longAnswers, 10 * kSeeds);
}

/// Tags that are opened are closed, in the opposite order.
void expectBalanced(const std::string& markup, const std::string& what) {
    std::vector<std::string> open;
    for (std::size_t at = markup.find('<'); at != std::string::npos; at = markup.find('<', at + 1)) {
        const std::size_t end = markup.find('>', at);
        ASSERT_NE(end, std::string::npos) << what;
        const std::string tag = markup.substr(at + 1, end - at - 1);
        if (tag.starts_with('!') || tag.starts_with("meta") || tag.ends_with('/')) continue;
        const std::string name = tag.substr(tag.starts_with('/'), tag.find_first_of(" >", 1) - tag.starts_with('/'));
        if (!tag.starts_with('/')) {
            open.push_back(name);
            continue;
        }
        ASSERT_FALSE(open.empty()) << what << ": " << tag;
        ASSERT_EQ(open.back(), name) << what;
        open.pop_back();
    }
    EXPECT_TRUE(open.empty()) << what;
}

TEST(Exercises, PagesAreWellFormedAndAskForNothing) {
    int figures = 0;
    for (std::size_t seed = 0; seed < sheets().size(); seed += 10)
        for (const bool isKey : {false, true}) {
            const std::string page =
                isKey ? keyPage(sheets()[seed], seed, Paper::letter) : sheetPage(sheets()[seed], seed, Paper::letter);
            expectBalanced(page, "sheet " + std::to_string(seed));
            for (const char* never : {"src=", "href=", "url(#clip", "@import", "nan", "<script"})
                EXPECT_EQ(page.find(never), std::string::npos) << never;
            EXPECT_NE(page.find("size: letter"), std::string::npos);
            for (std::size_t at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1))
                ++figures;
        }
    EXPECT_GE(figures, 20 * 6);
}

TEST(Exercises, NumbersAreShort) {
    EXPECT_EQ(printed(2.0), "2");
    EXPECT_EQ(printed(-0.00001234), "0");
    EXPECT_EQ(printed(0.1234567), "0.123");
    EXPECT_EQ(printed(2.0 / 3), "0.667");
    for (const auto& [value, text] : std::map<double, std::string>{{0.1875, "0.1875"}, {0.0625, "0.0625"}, {0.5625, "0.5625"},
                                                                   {-0.03125, "-0.03125"}, {1.25, "1.25"}, {0.1 + 0.2, "0.3"}})
        for (const double rounding : {-1e-13, 0.0, 1e-13}) // that of doubles, thousandfold
            EXPECT_EQ(printed(value + rounding), text);
    EXPECT_EQ(printed(1000.0), "1000");
    EXPECT_EQ(printed(dvec3(1, -2.5, 0)), "(1, -2.5, 0)");
}

TEST(Exercises, EachKindComesBeforeOneComesAgain) {
    const std::vector<Exercise> many = makeExercises(3, 40, allKinds());
    std::map<std::string, int> times;
    for (const Exercise& exercise : many)
        ++times[exercise.kind];
    EXPECT_EQ(times.size(), exerciseKinds().size());
    for (const auto& [kind, count] : times)
        EXPECT_TRUE(count == 2 || count == 3) << kind;
    EXPECT_EQ(makeExercises(3, 3, {&findExerciseKind("texel")}).size(), 3u);
    EXPECT_THROW(static_cast<void>(findExerciseKind("texels")), Error);
}

TEST(Exercises, NoExerciseComesTwiceOnASheet) {
    ASSERT_GE(exerciseKinds().size(), 16u);
    for (const ExerciseKind& kind : exerciseKinds()) {
        std::set<std::string> asked;
        for (const Exercise& exercise : makeExercises(5, 48, {&kind})) {
            std::string all = exercise.given;
            for (const NamedNumber& number : exercise.data)
                all += "\n" + number.name + " " + printed(number.value);
            asked.insert(all);
        }
        EXPECT_EQ(asked.size(), 48u) << kind.name;
    }
    EXPECT_THROW(makeExercises(5, 65, {&findExerciseKind("refraction")}), Error) << "there are 64";
}

/// Pages as a browser breaks them: an exercise that does not fit on one goes to the next.
std::vector<double> pageHeights(const std::vector<Exercise>& exercises) {
    std::vector<double> pages{kHeaderHeight};
    for (const Exercise& exercise : exercises) {
        const double height = heightOnPaper(exercise);
        if (pages.back() + height > kPageHeight) pages.push_back(0);
        pages.back() += height;
    }
    return pages;
}

TEST(Exercises, PagesAreFilled) {
    int pagesInOrder = 0, pagesFilled = 0, compared = 0;
    for (int seed = 1; seed <= 40; ++seed) {
        const std::vector<Exercise> made = makeExercises(static_cast<std::uint64_t>(seed), 8, allKinds()),
                                    filled = fillPages(made);
        ASSERT_EQ(filled.size(), made.size());
        std::multiset<std::string> before, after;
        for (std::size_t i = 0; i < made.size(); ++i)
            before.insert(made[i].given), after.insert(filled[i].given);
        EXPECT_EQ(before, after) << "nothing is lost";
        const std::vector<double> pages = pageHeights(filled);
        for (std::size_t page = 1; page + 1 < pages.size(); ++page) {
            EXPECT_GT(pages[page], kPageHeight / 2) << "seed " << seed << ", page " << page + 1;
            ++compared;
        }
        for (const Exercise& exercise : filled)
            EXPECT_LT(heightOnPaper(exercise), kPageHeight) << exercise.kind;
        pagesInOrder += static_cast<int>(pageHeights(made).size());
        pagesFilled += static_cast<int>(pages.size());
    }
    EXPECT_GT(compared, 60);
    EXPECT_LT(pagesFilled, pagesInOrder) << "of 40 sheets";
}

} // namespace
} // namespace shadowlab::course
