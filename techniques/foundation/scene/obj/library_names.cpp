// Cutting an mtllib line into names of files.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/library_names.h"

#include <algorithm>

#include "techniques/foundation/scene/load/unusual_characters.h"

namespace shadowlab::scene {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Words between blanks; blanks between two straight quotes separate none.
std::vector<std::string> wordsOf(std::string_view line) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < line.size();) {
        if (isBlank(line[i])) {
            ++i;
            continue;
        }
        std::size_t end = line[i] == '"' ? line.find('"', i + 1) : std::string_view::npos;
        end = end == std::string_view::npos ? i : end + 1;
        while (end < line.size() && !isBlank(line[end]))
            ++end;
        words.emplace_back(line.substr(i, end - i));
        i = end;
    }
    return words;
}

/// Words that are the end of a name. A line with two of them names two files, not one with a blank in it.
std::size_t endings(const std::vector<std::string>& words) {
    return static_cast<std::size_t>(std::ranges::count_if(
        words, [](const std::string& word) { return inSmallLetters(unquoted(word)).ends_with(".mtl"); }));
}

} // namespace

std::vector<std::string> libraryNames(const std::string& line, MisnamedFiles& files) {
    std::vector<std::string> words = wordsOf(line);
    if (words.size() > 1 && files.isThere(line)) return {line};
    const auto comment = std::ranges::find_if(
        words, [&](const std::string& word) { return word.starts_with('#') && !files.isThere(word); });
    if (comment == words.begin()) return {};
    const std::string names(comment == words.end() ? std::string_view(line) : withoutComment(line));
    words.erase(comment, words.end());
    if (words.size() > 1 && endings(words) < 2 && (files.isThere(names) || files.find(names))) return {names};
    return words;
}

} // namespace shadowlab::scene
