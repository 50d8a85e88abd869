// What the window writes into the current folder, and the files that are dropped on it.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/window/own_program.h"
#include "app/window/screen.h"

namespace shadowlab::window {

/// Nothing here throws: what fails is said on the screen.
class WindowFiles {
public:
    WindowFiles(WindowState& ui, Screen& screen) : ui_(ui), screen_(screen) {}

    /// Writes the scene as it is seen.
    void saveScene();
    /// Writes the scene and the command line that makes the picture, and runs that command line, which writes the picture.
    void saveScreenshot();
    /// Says how saving a screenshot has ended since the last call. True if one has.
    bool takeWhatArrived();
    /// Requests the last scene or mesh among the dropped files.
    void openDropped(int count, const char** paths);

private:
    /// "still-life-3" in the current folder: the first number for which no file with one of the endings exists.
    [[nodiscard]] std::filesystem::path freeName(const std::vector<std::string>& endings) const;
    [[nodiscard]] std::string sceneText() const;
    /// Removes scene and command line: without the picture they are of no use.
    void discardScreenshot(const OwnProgram::Ended& ended);

    WindowState& ui_;
    Screen& screen_;
    OwnProgram program_;
};

} // namespace shadowlab::window
