// Words and numbers in the figures of exercises: none lies on another one, and what is to be drawn has room on the paper.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <regex>

#include "app/drawing/labels.h"
#include "tests/course/exercise_sheets.h"

namespace shadowlab::course {
namespace {

struct Word {
    std::string text;
    drawing::Box box; ///< pixels
};

/// Letters are taken to be half as wide as high, and as high as digits are: a word that touches another one in such boxes hides part of it.
std::vector<Word> wordsOf(const ExerciseFigure& figure) {
    const std::string markup = figure.drawing.document(figure.title);
    static const std::regex element(R"re(<text x="([-\d.]+)" y="([-\d.]+)" font-size="([\d.]+)"([^>]*)>([^<]*))re");
    std::vector<Word> words;
    for (std::sregex_iterator at(markup.begin(), markup.end(), element), end; at != end; ++at) {
        const double size = std::stod((*at)[3]), width = 0.5 * size * static_cast<double>((*at)[5].length());
        const std::string style = (*at)[4];
        const double shift = style.find("\"middle\"") != std::string::npos ? 0.5 : style.find("\"end\"") != std::string::npos ? 1 : 0;
        const dvec2 start(std::stod((*at)[1]) - shift * width, std::stod((*at)[2]));
        words.push_back({(*at)[5], {start - dvec2(0, 0.7 * size), {width, 0.7 * size}}});
    }
    return words;
}

TEST(ExerciseFigures, NoWordLiesOnAnother) {
    int figures = 0, words = 0;
    for (const std::vector<Exercise>& sheet : sheets())
        for (const Exercise& exercise : sheet) {
            if (!exercise.figure) continue;
            const std::vector<Word> all = wordsOf(*exercise.figure);
            ++figures, words += static_cast<int>(all.size());
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(all[i].box.overlaps(all[j].box))
                        << exercise.kind << ": \"" << all[i].text << "\" on \"" << all[j].text << "\": " << exercise.given;
        }
    EXPECT_EQ(figures, 6 * kSeeds);
    EXPECT_GT(words, 6 * 6 * kSeeds);
}

TEST(ExerciseFigures, ShadowsOfPixelsHaveRoom) {
    int beyond = 0, shadows = 0;
    for (const std::vector<Exercise>& sheet : sheets())
        for (const Exercise& exercise : sheet) {
            if (exercise.kind != "pixels") continue;
            std::vector<double> numbers;
            for (const Word& word : wordsOf(*exercise.figure))
                if (word.text.find_first_not_of("-0123456789") == std::string::npos) numbers.push_back(std::stod(word.text));
            const double least = std::ranges::min(numbers);
            EXPECT_LE(least, std::min(in(exercise.results, "from.x"), in(exercise.results, "from.y"))) << exercise.given;
            EXPECT_GE(std::ranges::max(numbers), in(exercise.results, "to.x")) << exercise.given;
            beyond += in(exercise.results, "from.x") < 0 || in(exercise.results, "from.y") < 0;
            ++shadows;
        }
    EXPECT_EQ(shadows, kSeeds);
    EXPECT_GT(beyond, kSeeds / 10);
}

} // namespace
} // namespace shadowlab::course
