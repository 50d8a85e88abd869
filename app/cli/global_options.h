// The options that belong to no command and may stand anywhere: `--plugin FILE`, `--limit NAME=VALUE` and `--software`. They are
// taken out before the other words are parsed: a plug-in adds names that those may use, and the other two hold for every command.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::cli {

struct TakenWords {
    std::vector<std::string> values; ///< of `--option VALUE` and `--option=VALUE`, in order
    std::vector<std::string> words;  ///< all others; the program's own name first
};

/// Words after `--` are left as they are. Throws Error (usage) for the option without a value, and for a value that is given
/// twice; `example` is an example of a value, for the message.
TakenWords takeWordsOf(const std::string& option, const std::string& example, const std::vector<std::string>& argv);

/// Takes out an option that has no value; returns whether it was there. Throws Error (usage) for one with a value.
bool takeFlag(const std::string& option, std::vector<std::string>& argv);

} // namespace shadowlab::cli
