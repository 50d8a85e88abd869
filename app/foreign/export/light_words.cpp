// SPDX-License-Identifier: MIT
#include "app/foreign/export/light_words.h"

#include <algorithm>
#include <set>

#include "app/foreign/export/format.h"

namespace shadowlab::foreign {

namespace {

constexpr std::size_t kMostSigns = 64; // names of files end at 255 bytes, and more is put around the word

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool isPlain(char c) { return (small(c) >= 'a' && small(c) <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-'; }

bool isWord(const std::string& name) {
    return !name.empty() && name.size() <= kMostSigns && name.front() != '-' && std::ranges::all_of(name, isPlain);
}

/// The name's letters and digits, with one - in place of all that stands between; "light" where there are none.
std::string wordFrom(const std::string& name) {
    std::string word;
    for (const char c : name) {
        const bool parts = c == '-' || !isPlain(c);
        if (!parts)
            word += c;
        else if (!word.empty() && word.back() != '-')
            word += '-';
    }
    word.resize(std::min(word.size(), kMostSigns));
    if (word.ends_with('-')) word.pop_back();
    return word.empty() ? "light" : word;
}

std::string inSmall(std::string word) {
    for (char& c : word)
        c = small(c);
    return word;
}

} // namespace

std::vector<std::string> lightWords(const std::vector<scene::Light>& lights) {
    std::vector<std::string> words(lights.size());
    std::set<std::string> taken;
    // Names that are words first: whoever asks for such a name means that light.
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (isWord(lights[i].name) && taken.insert(inSmall(lights[i].name)).second) words[i] = lights[i].name;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!words[i].empty()) continue;
        const std::string plain = wordFrom(lights[i].name);
        words[i] = plain;
        for (std::size_t number = i + 1; !taken.insert(inSmall(words[i])).second; ++number)
            words[i] = plain + "-" + std::to_string(number);
    }
    return words;
}

std::string lightOption(const std::string& name) { return name.starts_with('-') ? " " + shellWord("--light=" + name) : " --light " + shellWord(name); }

} // namespace shadowlab::foreign
