// Command lines: words with a NUL byte after each. They are understood, or refused, up to the point where work would begin.
// Words with an equals sign are also tried as settings of every technique's parameters.
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "app/cli/global_options.h"
#include "app/lab/settings.h"
#include "tests/fuzz/target.h"

namespace shadowlab::fuzz {

namespace {

std::vector<std::string> wordsOf(std::string_view bytes) {
    std::vector<std::string> words{"shadowlab"};
    while (!bytes.empty()) {
        const std::size_t end = std::min(bytes.find('\0'), bytes.size());
        words.emplace_back(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    return words;
}

/// A parameter that was set is in its range, and what is written of it sets it to the same again.
void trySetting(const std::string& word) {
    static std::vector<picture::Slot> slots = [] {
        std::vector<picture::Slot> all;
        for (const RegisteredTechnique& registered : registeredTechniques())
            all.push_back(picture::Session::makeSlot(registered.info->id));
        return all;
    }();
    static_cast<void>(outcomeOf([&] {
        lab::applySettings(slots, {word});
        for (picture::Slot& slot : slots)
            for (params::Param& param : slot.params) {
                const double value = param.get();
                require(param.kind == params::Kind::boolean || (value >= param.minimum && value <= param.maximum),
                        "a parameter is in its range");
                params::setFromText(param, params::valueText(param), slot.info->id);
                require(param.get() == value, "a parameter is set again as it was written");
            }
    }));
}

} // namespace

Outcome feed(std::string_view bytes) {
    const std::vector<std::string> words = wordsOf(bytes);
    for (const std::string& word : words)
        if (word.find('=') != std::string::npos) trySetting(word);
    return outcomeOf([&] {
        const cli::TakenWords given = cli::takeWordsOf("--plugin", "FILE.so", words);
        require(static_cast<bool>(cli::workFor(given.words, given.values)), "there is something to do");
    });
}

} // namespace shadowlab::fuzz
