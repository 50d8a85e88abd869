// SPDX-License-Identifier: MIT
#include "app/course/exercises/page_filling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shadowlab::course {

namespace {

struct FilledPage {
    double height = 0;
    std::vector<std::size_t> exercises;
};

/// First fit by falling height, the first page last of those that are tried. `isTitleAboveFigures`: whether the first page, part of which
/// the title takes, may hold exercises with a figure; those are so high that nothing else fits beside both.
std::vector<FilledPage> filledPages(const std::vector<Exercise>& exercises, bool isTitleAboveFigures) {
    std::vector<double> heights;
    for (const Exercise& exercise : exercises)
        heights.push_back(heightOnPaper(exercise));
    std::vector<std::size_t> highestFirst(exercises.size());
    std::iota(highestFirst.begin(), highestFirst.end(), std::size_t(0));
    std::ranges::stable_sort(highestFirst, [&](std::size_t a, std::size_t b) { return heights[a] > heights[b]; });
    FilledPage first{kHeaderHeight, {}};
    std::vector<FilledPage> others;
    for (const std::size_t i : highestFirst) {
        const auto fits = [&](const FilledPage& page) { return page.height + heights[i] <= kPageHeight; };
        FilledPage* page = nullptr;
        if (const auto found = std::ranges::find_if(others, fits); found != others.end())
            page = &*found;
        else if (fits(first) && (isTitleAboveFigures || !exercises[i].figure))
            page = &first;
        else
            page = &others.emplace_back();
        page->height += heights[i];
        page->exercises.push_back(i);
    }
    for (FilledPage& page : others)
        std::ranges::sort(page.exercises);
    std::ranges::sort(first.exercises);
    std::ranges::sort(others, {}, [](const FilledPage& page) { return page.exercises.front(); });
    if (const auto emptiest = std::ranges::min_element(others, {}, &FilledPage::height); emptiest != others.end())
        std::rotate(emptiest, emptiest + 1, others.end());
    others.insert(others.begin(), first);
    return others;
}

} // namespace

double heightOnPaper(const Exercise& exercise) {
    // As Chromium sets the style of the page, in millimetres, with margins. Questions are indented, so their lines are shorter.
    constexpr double kLettersOfText = 88, kLettersOfQuestion = 84, kLine = 5.4, kAnswerRoom = 18, kHeading = 12.4,
                     kAroundFigure = 3;
    const auto linesOf = [](const std::string& text, double letters) {
        return kLine * std::ceil(static_cast<double>(text.size()) / letters);
    };
    double height = kHeading + linesOf(exercise.given, kLettersOfText);
    for (const std::string& question : exercise.questions)
        height += linesOf(question, kLettersOfQuestion) + kAnswerRoom;
    if (exercise.figure) height += kMillimetresOfPixel * exercise.figure->drawing.size().y + kAroundFigure;
    return height;
}

std::vector<Exercise> fillPages(std::vector<Exercise> exercises) {
    const std::vector<FilledPage> withFigures = filledPages(exercises, true), without = filledPages(exercises, false);
    std::vector<Exercise> ordered;
    for (const FilledPage& page : withFigures.size() < without.size() ? withFigures : without)
        for (const std::size_t i : page.exercises)
            ordered.push_back(exercises[i]);
    return ordered;
}

} // namespace shadowlab::course
