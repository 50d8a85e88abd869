// From the words of the command line to checked values. Every refusal is an Error (usage) that names the option and
// what it takes.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

/// Throws Error (usage).
[[noreturn]] void refuseUsage(const std::string& message);

/// What was written for the options of one subcommand.
class GivenOptions {
public:
    explicit GivenOptions(const CLI::App& command) : command_(command) {}

    /// The text of an option, or `fallback` without it. An option that is given twice, or empty, is refused.
    [[nodiscard]] std::string text(const std::string& option, const std::string& fallback = "") const;
    /// The text of an option, or of a positional argument, that may not be missing. `example` is part of the refusal.
    [[nodiscard]] std::string required(const std::string& option, const std::string& example) const;
    /// All texts of an option that may be repeated, in order.
    [[nodiscard]] std::vector<std::string> texts(const std::string& option) const;
    /// Those of --allow. Throws Error (usage) for one that is no folder: else what it was to allow would be refused later on.
    [[nodiscard]] std::vector<std::filesystem::path> allowedFolders() const;
    [[nodiscard]] bool has(const std::string& option) const;

private:
    const CLI::App& command_;
};

/// Adds an option that takes one word at each occurrence, and leaves the next word to whom it belongs.
/// `value` stands for the word in the help text. How often it may be given is up to those who ask.
void addOption(CLI::App& command, const std::string& names, const std::string& value, const std::string& help);

/// Adds an argument without a name of its own that may be written several times.
void addArguments(CLI::App& command, const std::string& name, const std::string& help);

/// Refuses an output whose name does not end in `ending`.
void requireEnding(const std::string& option, const std::filesystem::path& path, const std::string& ending);

/// "320,180": a pixel of a picture of that size.
ivec2 pixelFrom(const std::string& option, const std::string& text, ivec2 size);

/// "1280x720". Throws Error (overLimit) for a side beyond the limit of that name (picture/limits.h).
ivec2 sizeFrom(const std::string& option, const std::string& text, std::string_view limit);
bool booleanFrom(const std::string& option, const std::string& text);
/// An angle within a million degrees.
double degreesFrom(const std::string& option, const std::string& text);
/// A time that a picture can stay, in seconds: from 0.01 to 60.
double secondsFrom(const std::string& option, const std::string& text);
/// A whole number from 1 to `most`.
int countFrom(const std::string& option, const std::string& text, int most);
/// A whole number from 1. Throws Error (overLimit) beyond the limit of that name.
int limitedCountFrom(const std::string& option, const std::string& text, std::string_view limit);
/// Index of the text among `choices`.
int choiceFrom(const std::string& option, const std::string& text, const std::vector<std::string>& choices);
/// "a,b,c" in its parts.
std::vector<std::string> splitAtCommas(const std::vector<std::string>& texts);

} // namespace shadowlab::cli
