// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/mtl_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "techniques/foundation/scene/obj/statement_lines.h"

namespace shadowlab::scene {

namespace {

/// An option, and how many words follow it at least and at most. Of two bounds that differ, only numbers are taken.
struct Option {
    std::string_view name;
    std::size_t least, most;
    bool isSilent = false; ///< it changes nothing here
};
constexpr std::array kOptions{Option{"-s", 1, 3},
                              Option{"-o", 1, 3},
                              Option{"-clamp", 1, 1},
                              Option{"-mm", 2, 2},
                              Option{"-imfchan", 1, 1},
                              Option{"-bm", 1, 1, true},
                              Option{"-blendu", 1, 1, true}, // how its smaller copies are made; there are none
                              Option{"-blendv", 1, 1, true},
                              Option{"-boost", 1, 1},
                              Option{"-texres", 1, 1},
                              Option{"-t", 1, 3},
                              Option{"-cc", 1, 1},
                              Option{"-type", 1, 1},
                              Option{"-colorspace", 1, 1}};

/// The words of a statement, and where each stands in it.
struct Words {
    std::string_view text;
    std::vector<std::string_view> all;
    explicit Words(std::string_view statement) : text(statement) {
        constexpr std::string_view kBlanks = " \t\v\f";
        for (std::size_t at = 0; (at = text.find_first_not_of(kBlanks, at)) != std::string_view::npos;) {
            const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
            all.push_back(text.substr(at, end - at));
            at = end;
        }
    }
    [[nodiscard]] std::string_view from(std::size_t first, std::size_t end) const {
        if (first >= end) return {};
        const char* begin = all[first].data();
        return {begin, static_cast<std::size_t>(all[end - 1].data() + all[end - 1].size() - begin)};
    }
};

const Option* optionNamed(std::string_view word) {
    const auto found = std::ranges::find(kOptions, word, &Option::name);
    return found == kOptions.end() ? nullptr : &*found;
}

std::optional<double> finiteNumber(std::string_view word) {
    const auto number = readNumber(word);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

void ignore(const Option& option, MtlMap& map) {
    if (std::ranges::find(map.ignored, option.name) == map.ignored.end()) map.ignored.emplace_back(option.name);
}

void apply(const Option& option, std::span<const std::string_view> values, MtlMap& map) {
    const auto number = [&](std::size_t i, double otherwise) {
        return i < values.size() ? finiteNumber(values[i]).value_or(otherwise) : otherwise;
    };
    if (option.name == "-s") map.placement.scale = {number(0, 1), number(1, 1)};
    else if (option.name == "-o") map.placement.offset = {number(0, 0), number(1, 0)};
    else if (option.name == "-clamp") map.placement.clamped = values[0] == "on";
    else if (option.name == "-mm") std::tie(map.base, map.gain) = std::pair(number(0, 0), number(1, 1));
    else if (option.name == "-imfchan") {
        using enum MaskChoice::Channel;
        constexpr std::array kChannels{std::pair{'r', red},   std::pair{'g', green},      std::pair{'b', blue},
                                       std::pair{'m', alpha}, std::pair{'l', brightness}, std::pair{'z', brightness}};
        for (const auto& [letter, channel] : kChannels)
            if (values[0] == std::string_view(&letter, 1)) {
                map.channel = channel;
                return;
            }
        ignore(option, map);
    } else if (!option.isSilent)
        ignore(option, map);
}

/// Applies the options that begin at `word`; the first word after them.
std::size_t applyOptions(const Words& words, std::size_t word, MtlMap& map) {
    while (word < words.all.size()) {
        const Option* option = optionNamed(words.all[word]);
        if (!option || word + option->least >= words.all.size()) break;
        std::size_t count = option->least;
        while (count < option->most && word + 1 + count < words.all.size() && finiteNumber(words.all[word + 1 + count]))
            ++count;
        apply(*option, std::span(words.all).subspan(word + 1, count), map);
        word += 1 + count;
    }
    return word;
}

/// Where options begin that go on to the end of the statement; the number of words if there are none.
std::size_t trailingOptions(const Words& words, std::size_t first) {
    for (std::size_t word = first + 1; word < words.all.size(); ++word) {
        MtlMap ignored;
        if (optionNamed(words.all[word]) && applyOptions(words, word, ignored) == words.all.size()) return word;
    }
    return words.all.size();
}

} // namespace

MtlMap parseMtlMap(std::string_view statement) {
    const Words words(statement);
    MtlMap map;
    const std::size_t name = applyOptions(words, 0, map);
    const std::size_t end = trailingOptions(words, name);
    applyOptions(words, end, map);
    const std::string_view file = words.from(name, end);
    map.file = file;
    map.fileAt = file.empty() ? 0 : static_cast<std::size_t>(file.data() - statement.data());
    return map;
}

} // namespace shadowlab::scene
