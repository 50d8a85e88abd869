// A scene as a folder for another renderer: its files, the calibration board's in the same format, and a README.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "app/foreign/export/format.h"

namespace shadowlab::foreign {

struct ExportRequest {
    const Format* format = nullptr;
    std::string scene;   ///< as commands that run in the folder name it, with the options that go with it
    std::string command; ///< the whole command line, as it was given
    ivec2 size{640, 360};
    std::filesystem::path threeModule; ///< see ExportJob
};

/// Writes into the folder, which is there and empty. Throws Error (cannotWrite, badInput).
void exportScene(const scene::Scene& scene, const ExportRequest& request, const std::filesystem::path& folder);

} // namespace shadowlab::foreign
