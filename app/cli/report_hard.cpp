// `shadowlab report --hard`: every hard case, each technique as it should be and its careless version, and all techniques before it.
// SPDX-License-Identifier: MIT
#include "app/cli/common_options.h"
#include "app/cli/report.h"

#include "app/cli/messages.h"
#include "app/cli/progress.h"
#include "app/context/signals.h"
#include "app/hard/page.h"
#include "app/hard/parts.h"
#include "app/hard/run_case.h"
#include "app/hard/tables.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::cli {

int reportHard(const ReportOptions& options) {
    const scene::LoadOptions loading = loadOptions(options.allowed);
    const std::vector<hard::Case> cases = hard::allCases(loading);
    const std::unique_ptr<context::Context> context = context::createContext(options.backend);
    const std::string renderer = context::glRenderer();
    const std::vector<hard::Column> columns = hard::columns();
    const hard::Parts parts(options.output, hard::madeBy(renderer, options.isQuick, columns), cases);
    Progress progress("hard case", static_cast<int>(cases.size()), Progress::Remaining::told);
    std::vector<hard::CaseResult> results;
    int red = 0;
    for (const hard::Case& one : cases) {
        context::throwIfInterrupted();
        std::optional<hard::CaseResult> result = parts.find(one);
        if (!result) {
            result = hard::runWholeCase(one, options.isQuick, columns);
            parts.keep(one, *result);
        }
        red += result->red();
        results.push_back(std::move(*result));
        progress.done(static_cast<int>(results.size()));
    }
    image::writeWhole(options.output / "hard.json", hard::hardJson(results, renderer));
    image::writeWhole(options.output / "hard.csv", hard::hardCsv(results));
    image::writeWhole(options.output / "hard-matrix.csv", hard::matrixCsv(results));
    image::writeWhole(options.output / "hard.html", hard::hardPage(results, renderer));
    parts.discard(cases);
    if (red == 0) return 0;
    complain(std::to_string(red) + " checks of hard cases are red; see " + (options.output / "hard.html").string());
    return 1;
}

} // namespace shadowlab::cli
