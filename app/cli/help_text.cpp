// SPDX-License-Identifier: MIT
#include "app/cli/help_text.h"

#include <sstream>

#include "app/cli/text_table.h"

namespace shadowlab::cli {

namespace {

constexpr std::size_t kColumns = 80;    ///< of a terminal that nobody has made wider
constexpr std::size_t kHelpBegins = 30; ///< column; a longer name has a line of its own
constexpr std::size_t kNameBegins = 2;

std::string entryLines(const HelpEntry& entry) {
    std::string text = std::string(kNameBegins, ' ') + entry.name;
    bool isFirst = true;
    for (const std::string& line : wrapped(entry.help, kColumns - kHelpBegins)) {
        const bool fits = isFirst && text.size() + 2 <= kHelpBegins;
        if (isFirst && !fits) text += "\n";
        text += std::string(fits ? kHelpBegins - text.size() : kHelpBegins, ' ') + line + "\n";
        isFirst = false;
    }
    return isFirst ? text + "\n" : text;
}

/// A command line of a shell, in pieces that end in a backslash. An option stays with its value.
std::string commandLines(const std::string& command) {
    constexpr const char *kFirst = "  ", *kLater = "      ";
    std::vector<std::string> pieces; // words, an option and its value in one
    std::istringstream words(command);
    for (std::string word; words >> word;) {
        const bool isValue = !pieces.empty() && pieces.back().starts_with('-') &&
                             pieces.back().find(' ') == std::string::npos && !word.starts_with('-');
        if (isValue)
            pieces.back() += " " + word;
        else
            pieces.push_back(word);
    }
    std::string text, line = kFirst;
    bool isEmpty = true;
    for (const std::string& piece : pieces) {
        if (!isEmpty && line.size() + 1 + piece.size() + 2 > kColumns) { // 2: blank and backslash
            text += line + " \\\n";
            line = kLater;
            isEmpty = true;
        }
        line += (isEmpty ? "" : " ") + piece;
        isEmpty = false;
    }
    return text + line + "\n";
}

std::string footerLines(const std::string& footer) {
    std::string text;
    std::istringstream lines(footer);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  ")) {
            text += commandLines(line);
            continue;
        }
        if (line == "Examples:" && !text.empty()) text += "\n";
        for (const std::string& part : wrapped(line, kColumns))
            text += part + "\n";
        if (line.empty()) text += "\n";
    }
    return text;
}

} // namespace

std::string helpText(const HelpPage& page) {
    std::string text;
    for (const std::string& line : wrapped(page.about, kColumns))
        text += line + "\n";
    text += "\nUsage: " + page.usage + "\n";
    for (const auto& [heading, entries] : page.sections) {
        if (entries.empty()) continue;
        text += "\n" + heading + ":\n";
        for (const HelpEntry& entry : entries)
            text += entryLines(entry);
    }
    if (!page.footer.empty()) text += "\n" + footerLines(page.footer);
    return text;
}

} // namespace shadowlab::cli
