// The help of the program and of each command, laid out for a terminal of 80 columns.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::cli {

/// A line of two columns: a command, an argument or an option, and what it is.
struct HelpEntry {
    std::string name, help;
};

struct HelpPage {
    std::string about; ///< a sentence
    std::string usage; ///< "shadowlab capture [OPTIONS] SCENE"
    /// Sections: a heading ("Options") and its lines.
    std::vector<std::pair<std::string, std::vector<HelpEntry>>> sections;
    /// Paragraphs below, a line each. Lines that begin with two blanks are command lines: they are broken before an option, with
    /// the backslash that a shell wants there.
    std::string footer;
};

/// No line is longer than 80 characters, but for a word that is longer.
std::string helpText(const HelpPage& page);

} // namespace shadowlab::cli
