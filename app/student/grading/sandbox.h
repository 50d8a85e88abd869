// Where code that nobody has looked through runs: in namespaces of its own, made by bubblewrap (bwrap), as far as the system lets a
// user make them.
//
// In it there is no network, no other process, no home folder and no temporary folder but one to write in. System libraries, the
// program, its assets and the plug-in can be read, and nothing else; of the environment only what OpenGL and the program need is left.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace shadowlab::student {

enum class SandboxWanted {
    automatic, ///< where it can be had
    required,  ///< else nothing is run
    none,
};

/// "auto", "on" or "off". Throws Error (usage) for anything else.
SandboxWanted sandboxFromName(std::string_view name);

/// What a process may touch beside the system's libraries and the program.
struct SandboxRoom {
    std::filesystem::path scratch;              ///< a folder to write in; empty: none
    std::vector<std::filesystem::path> readable; ///< files and folders
};

class Sandbox {
public:
    /// Looks whether there is one, by running the program in it once. Throws Error (badInput) where one is required and there is none.
    /// `program`: what is run in it; empty: this one.
    explicit Sandbox(SandboxWanted wanted, std::filesystem::path program = {});

    [[nodiscard]] bool isOn() const { return !bwrap_.empty(); }
    /// Why there is none, and what to do, as the end of a sentence; empty where there is one, or none was wanted.
    [[nodiscard]] const std::string& whyNot() const { return whyNot_; }

    /// The words of a command line that runs the program with `words` in the room; the first is what is to be executed. Without a
    /// sandbox these are the program itself and its words.
    [[nodiscard]] std::vector<std::string> around(const std::vector<std::string>& words, const SandboxRoom& room) const;

private:
    [[nodiscard]] std::string refusal() const;

    std::filesystem::path program_, bwrap_;
    std::string whyNot_;
};

} // namespace shadowlab::student
