// The three forms of `shadowlab report`: of scenes, of the hard cases, and the merging of parts.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/context/context.h"
#include "app/report/plan.h"
#include "app/report/store.h"

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

/// Measures every technique's sweeps on the scenes, and writes the report into a folder. Goes on with a report that was begun there.
int reportScenes(const ReportOptions& options);

/// Runs the hard cases and writes their tables. 0: every check passed; 1: some did not.
int reportHard(const ReportOptions& options);

/// Writes all outputs of a report, and prints where its page is.
void writeReport(const report::Store& store);

} // namespace shadowlab::cli
