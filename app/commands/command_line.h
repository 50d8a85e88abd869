// The command line: one function per subcommand, all options described once.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/context/context.h"
#include "app/session/figure.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::commands {

struct CaptureOptions {
    std::string scene;
    std::filesystem::path output;
    std::vector<std::string> techniques;
    session::Layout layout = session::Layout::single;
    bool labels = true;
    std::string stage; ///< empty: the picture
    ivec2 size{1280, 720};
    int supersample = 1;
    std::vector<std::string> settings; ///< [SLOT:]ID.PARAM=VALUE
    std::string light;                 ///< empty: the first
    context::Backend backend = context::Backend::automatic;
    std::filesystem::path stats; ///< empty: none
    int frames = 1;
    std::optional<double> orbitLightDegrees, orbitCameraDegrees;
    std::vector<std::filesystem::path> allowed;
};
int capture(const CaptureOptions& options);

struct ListOptions {
    std::string what;
    bool json = false;
};
int list(const ListOptions& options);

/// Writes NAME-comparison.png into the current folder and its path to standard output.
int demo(const std::string& sceneNameOrPath);

/// Parses argv and runs the subcommand; its result is the exit status. Throws Error.
int run(int argc, char** argv);

} // namespace shadowlab::commands
