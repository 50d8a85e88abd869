// What `report` is asked for: its options, described and checked.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/context/context.h"
#include "app/report/plan.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct ReportOptions {
    std::vector<std::string> scenes;     ///< names or files; empty: all that are built in
    std::vector<std::string> techniques; ///< empty: all that say what they make of a light
    std::string light;                   ///< of every scene; empty: the first
    ivec2 size{1280, 720};
    std::filesystem::path output; ///< a folder
    bool isQuick = false;
    bool isHard = false; ///< the hard cases instead of scenes
    report::Shard shard;
    context::Backend backend = context::Backend::automatic;
    std::vector<std::filesystem::path> allowed;
    std::vector<std::filesystem::path>
        merged; ///< folders of reports; not empty: they are put together, nothing is drawn
};

void describeReport(CLI::App& command);

/// Throws Error (usage, overLimit).
ReportOptions reportOptions(const CLI::App& command);

} // namespace shadowlab::cli
