// SPDX-License-Identifier: MIT
#include "app/window/line_breaks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace shadowlab::window {

namespace {

bool isDigit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }
bool endsClause(const std::string& word) { return std::string_view(",;:.").find(word.back()) != std::string_view::npos; }

/// "12", "-0.5", "(3,"
bool isNumber(const std::string& word) {
    const std::size_t first = word.find_first_not_of("-+(");
    return first != std::string::npos && isDigit(word[first]);
}

bool isUnit(std::string word) {
    constexpr std::array<std::string_view, 10> kUnits = {"m", "m^2", "mm", "cm", "%", "ms", "s", "px", "W/m^2", "degrees"};
    while (!word.empty() && endsClause(word))
        word.pop_back();
    return std::ranges::find(kUnits, word) != kUnits.end();
}

constexpr std::array<std::string_view, 4> kSigns = {"-", "+", "*", "/"};
constexpr std::array<std::string_view, 5> kRelations = {"=", "<", ">", ">=", "<="};
template <std::size_t count>
bool isOneOf(const std::array<std::string_view, count>& all, const std::string& word) {
    return std::ranges::find(all, word) != all.end();
}

/// How closely two words belong together that follow each other.
enum class Bond { none, named, sum };

/// A relation begins a line, "= 1", but never ends one.
Bond bondOf(const std::string& word, const std::string& next) {
    if (isOneOf(kSigns, word) || isOneOf(kRelations, word) || isOneOf(kSigns, next)) return Bond::sum;
    if (word.front() == '(' && word.find(')') == std::string::npos) return Bond::sum; // the coordinates of a place
    if (isNumber(word)) return !endsClause(word) && isUnit(next) ? Bond::sum : Bond::none;
    return isNumber(next) && !endsClause(word) ? Bond::named : Bond::none; // "entered 1", "of 16"
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin) words.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

/// Words that belong together at least so closely, as one piece.
std::vector<std::string> piecesOf(const std::vector<std::string>& words, Bond least) {
    std::vector<std::string> pieces;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (i > 0 && bondOf(words[i - 1], words[i]) >= least)
            pieces.back() += " " + words[i];
        else
            pieces.push_back(words[i]);
    return pieces;
}

} // namespace

std::vector<std::string> brokenText(const std::string& text, float width, const TextWidth& widthOf) {
    std::vector<std::string> lines;
    const auto add = [&](const std::string& piece) {
        const std::string longer = lines.empty() ? piece : lines.back() + " " + piece;
        if (lines.empty() || widthOf(longer) > width)
            lines.push_back(piece);
        else
            lines.back() = longer;
    };
    const auto addAll = [&](const std::vector<std::string>& pieces, const auto& breakFurther) {
        for (const std::string& piece : pieces)
            if (widthOf(piece) <= width)
                add(piece);
            else
                breakFurther(wordsOf(piece));
    };
    const auto addWords = [&](const std::vector<std::string>& words) { std::ranges::for_each(words, add); };
    const auto addSums = [&](const std::vector<std::string>& words) { addAll(piecesOf(words, Bond::sum), addWords); };
    addAll(piecesOf(wordsOf(text), Bond::named), addSums);
    return lines;
}

} // namespace shadowlab::window
