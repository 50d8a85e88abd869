// `shadowlab report --hard`: every hard case, each technique as it should be and its careless version.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <system_error>

#include "app/commands/command_line.h"
#include "app/commands/messages.h"
#include "app/commands/progress.h"
#include "app/context/signals.h"
#include "app/hard/tables.h"
#include "app/session/assets.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::commands {

int reportHard(const ReportOptions& options) {
    const scene::LoadOptions loading{.assetsRoot = session::assetsRoot(), .allowed = options.allowed, .limits = {}};
    const std::vector<hard::Case> cases = hard::allCases(loading);
    std::error_code error;
    std::filesystem::create_directories(options.output, error);
    if (error)
        throw Error(ExitStatus::cannotWrite, "-o: the folder '" + options.output.string() +
                                                 "' cannot be made: " + error.message() + "; choose another");
    const std::unique_ptr<context::Context> context = context::createContext(options.backend);
    Progress progress("hard case", static_cast<int>(cases.size()), Progress::Remaining::told);
    std::vector<hard::CaseResult> results;
    int red = 0;
    for (const hard::Case& one : cases) {
        context::throwIfInterrupted();
        results.push_back({one.id, one.title, one.why, hard::runCase(one, options.isQuick), one.tests});
        for (const hard::Row& row : results.back().rows)
            red += !row.isGreen();
        progress.done(static_cast<int>(results.size()));
    }
    const std::string renderer = context::glRenderer();
    image::writeWhole(options.output / "hard.json", hard::hardJson(results, renderer));
    image::writeWhole(options.output / "hard.csv", hard::hardCsv(results));
    image::writeWhole(options.output / "hard.html", hard::hardPage(results, renderer));
    if (red == 0) return 0;
    complain(std::to_string(red) + " checks of hard cases are red; see " + (options.output / "hard.html").string());
    return 1;
}

} // namespace shadowlab::commands
