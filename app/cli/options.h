// The options of one command: described for the help text, and read back as they were written.
// Only options.cpp and command_line.cpp include CLI11, whose header takes seconds to compile.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace shadowlab::cli {

/// The options of one command, as they are described for the help text.
class DescribedOptions {
public:
    explicit DescribedOptions(CLI::App& command) : command_(command) {}

    /// Adds an option, or a positional argument, that takes one word each time it is written. `value` stands for that word in
    /// the help text.
    void option(const std::string& names, const std::string& value, const std::string& help);
    /// Adds an option without a value.
    void flag(const std::string& name, const std::string& help);
    /// Adds a positional argument that takes any number of words.
    void arguments(const std::string& name, const std::string& help);
    /// Sets the text below the options: remarks and examples.
    void footer(const std::string& text);

private:
    CLI::App& command_;
};

/// What was written for the options of one command.
class GivenOptions {
public:
    /// `plugins`: the files of --plugin, which belong to no command.
    GivenOptions(const CLI::App& command, const std::vector<std::string>& plugins)
        : command_(command), plugins_(plugins) {}

    /// Whether an option, a flag or an argument was written.
    [[nodiscard]] bool has(const std::string& option) const;
    /// The text of an option, or `fallback` without it. Throws Error (usage) for an option that is given twice, or empty.
    [[nodiscard]] std::string text(const std::string& option, const std::string& fallback = "") const;
    /// The text of an option, or of a positional argument, that may not be missing. `example` is part of the error's message.
    [[nodiscard]] std::string required(const std::string& option, const std::string& example) const;
    /// All texts of an option that may be repeated, in order.
    [[nodiscard]] std::vector<std::string> texts(const std::string& option) const;
    /// The folders of --allow. Throws Error (usage) for one that does not exist, before a mesh in it is refused for another reason.
    [[nodiscard]] std::vector<std::filesystem::path> allowedFolders() const;
    [[nodiscard]] const std::vector<std::string>& plugins() const { return plugins_; }

private:
    const CLI::App& command_;
    const std::vector<std::string>& plugins_;
};

} // namespace shadowlab::cli
