// What `measure` is asked to do: its options, described and checked.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/motion_options.h"
#include "app/context/context.h"
#include "techniques/foundation/math/types.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct MeasureOptions {
    std::string scene;
    std::vector<std::string> techniques{"shadow-volume-zfail"};
    ivec2 size{1280, 720};
    std::vector<std::string> settings; ///< [SLOT:]ID.PARAM=VALUE
    std::string light;                 ///< empty: the first
    context::Backend backend = context::Backend::automatic;
    MotionOptions motion;
    bool json = false;
    std::vector<std::filesystem::path> allowed;
};

/// Sets aside the memory that truth and verdicts of such pictures take. Throws Error (overLimit).
void reserveForMeasured(ivec2 size);

/// Ids with commas between them; `all` stands for every technique that says what it makes of a light.
std::vector<std::string> measuredTechniquesFrom(const std::vector<std::string>& texts);

void describeMeasure(CLI::App& command);

/// From what was written to what is meant. Throws Error (usage, overLimit).
MeasureOptions measureOptions(const CLI::App& command);

} // namespace shadowlab::cli
