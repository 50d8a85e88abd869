// SPDX-License-Identifier: MIT
#include "app/student/grading/likely_blanks.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace shadowlab::student {

namespace {

struct Pattern {
    std::string_view family, failing; ///< as failingCases()
    std::string_view blanks;
};

// Measured: SHADOWLAB_LONG=1 tests/plugins/plugins_check.py compares its plug-ins with this table.
constexpr std::array kPatterns = std::to_array<Pattern>({
    {"planar", "111111111", "1 2"},
    {"planar", "111111101", "3"},
    {"planar", "110111101", "4"},
    {"shadow-map", "01110000", "1"},
    {"shadow-map", "10001111", "2"},
    {"shadow-map", "00000001", "2"},
    {"shadow-map", "00001000", "4"},
    {"shadow-map", "11111111", "3 4 5"},
    {"shadow-volume", "01010010", "1 3"},
    {"shadow-volume", "00000001", "3"},
    {"shadow-volume", "00001001", "4"},
    {"shadow-volume", "00010000", "7"},
    {"shadow-volume", "11111111", "1 2 3 5 6 7"},
    {"ray-tracing", "11111111", "1"},
    {"ray-tracing", "11111110", "2"},
    {"ray-tracing", "00100000", "2"},
    {"ray-tracing", "00011111", "3 6 7"},
    {"ray-tracing", "00001100", "4 5"},
    {"ray-tracing", "00000100", "5"},
    {"ray-tracing", "00000111", "6"},
    {"ray-tracing", "00001101", "7"},
    {"ray-tracing", "00011110", "8"},
    {"radiosity", "00011110", "2"},
    {"radiosity", "01111111", "1 3"},
    {"radiosity", "11111001", "4"},
    {"radiosity", "11111111", "1 3 4 5"},
});

} // namespace

std::string failingCases(const Sheet& sheet) {
    std::string failing;
    for (const CaseResult& result : sheet.results)
        failing += result.isRight() ? '0' : '1';
    return failing;
}

std::vector<int> likelyBlanks(const Sheet& sheet) {
    const std::string failing = failingCases(sheet);
    // Without pictures nothing can be told by them.
    if (std::ranges::any_of(sheet.results, [](const CaseResult& result) { return !result.wrong; })) return {};
    for (const Pattern& pattern : kPatterns)
        if (pattern.family == sheet.family->id && pattern.failing == failing)
            return numbersIn(pattern.blanks);
    return {};
}

std::string likelyText(const Sheet& sheet, const std::vector<Blank>& blanks) {
    const std::string names = namesOf(likelyBlanks(sheet), blanks);
    return names.empty() ? "" : "Of the mistakes that were tried, " + names + " left empty or filled in wrongly gives just these failures: look there first.";
}

} // namespace shadowlab::student
