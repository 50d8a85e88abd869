// `--plugin FILE` and `--limit NAME=VALUE`, wherever they stand on the command line: taken out before the words are read, because
// what else they may say depends on the one, and the other concerns all commands alike.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::commands {

struct TakenWords {
    std::vector<std::string> values; ///< of `--option VALUE` and `--option=VALUE`, in order
    std::vector<std::string> words;  ///< all others; the program's own name first
};

/// Words after `--` are left as they are. Throws Error (usage) for the option without a value, and for a value that is given
/// twice; `example` is a value that would do.
TakenWords takeWordsOf(const std::string& option, const std::string& example, const std::vector<std::string>& argv);

} // namespace shadowlab::commands
