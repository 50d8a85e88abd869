// From the words of a command line to the work they ask for.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/cli/command.h"

namespace shadowlab::cli {

/// Parses and checks the words, before anything is done. Throws Error (usage, overLimit).
/// The first word is the program's own name; `plugins`: the files of --plugin.
Work workFor(const std::vector<std::string>& words, const std::vector<std::string>& plugins);

/// Loads plug-ins, sets limits, and does what the other words ask for. Throws Error.
int run(int argc, char** argv);

} // namespace shadowlab::cli
