// SPDX-License-Identifier: MIT
#include "app/hard/words.h"

#include <array>
#include <charconv>

namespace shadowlab::hard {

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

std::string caughtText(const Row& row) { return !row.caught ? "no setting" : *row.caught ? "caught" : "not caught"; }

std::string titleOf(const CaseResult& result, const Row& row) {
    return row.title.empty() ? result.title : result.title + ": " + row.title;
}

} // namespace shadowlab::hard
