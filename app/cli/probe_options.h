// What `probe` is asked about: its options, described and checked.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct ProbeOptions {
    std::string scene;
    ivec2 pixel{0};               ///< column and row, from the upper left corner
    std::optional<ivec2> partner; ///< a second one
    std::string technique = "shadow-volume-zfail";
    ivec2 size{1280, 720};
    std::vector<std::string> settings; ///< [SLOT:]ID.PARAM=VALUE
    std::string light;                 ///< empty: the first
    bool json = false;
    std::filesystem::path diagram; ///< empty: none
    std::string figure = "pixel";  ///< what is drawn there (figures/figures.h)
    std::vector<std::filesystem::path> allowed;
};

/// Is the diagram wanted as a picture, not as SVG?
bool isPicture(const std::filesystem::path& diagram);

void describeProbe(CLI::App& command);

/// Throws Error (usage, overLimit) for what is wrong in itself; what depends on the scene is seen later.
ProbeOptions probeOptions(const CLI::App& command);

} // namespace shadowlab::cli
