// `--plugin FILE`, `--limit NAME=VALUE` and `--software`, wherever they stand on the command line: taken out before the words are
// read, because what else they may say depends on the first, and the others concern all commands alike.
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
/// twice; `example` is a value that would do.
TakenWords takeWordsOf(const std::string& option, const std::string& example, const std::vector<std::string>& argv);

/// Takes out an option that has no value. Was it there? Throws Error (usage) for one with a value.
bool takeFlag(const std::string& option, std::vector<std::string>& argv);

} // namespace shadowlab::cli
