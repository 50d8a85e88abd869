// SPDX-License-Identifier: MIT
#include "app/hard/tables.h"


#include "app/hard/results_json.h"
#include "app/report/csv.h"

namespace shadowlab::hard {

using report::joined;
using report::numberText;

std::string hardJson(const std::vector<CaseResult>& results, const std::string& renderer) {
    Json cases = Json::array();
    for (const CaseResult& result : results)
        cases.push_back(toJson(result));
    return Json{{"renderer", renderer}, {"cases", cases}}.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string hardCsv(const std::vector<CaseResult>& results) {
    std::string csv =
        "case,title,check,technique,settings,quantity,bound,value,naive,naiveSettings,lit,shadowed,ties,verdict,"
        "naiveVerdict,tests,naiveTests\r\n";
    for (const CaseResult& result : results) {
        const std::string tests = joined(result.tests), naiveTests = joined(result.naiveTests);
        for (const Row& row : result.rows)
            for (const Measured& m : row.measured)
                csv += report::csvLine({result.id, result.title, row.title, row.technique, joined(row.settings),
                                        m.quantity, m.bound, numberText(m.value), m.naive ? numberText(*m.naive) : "",
                                        joined(row.naiveSettings), std::to_string(row.counts.lit),
                                        std::to_string(row.counts.shadowed), std::to_string(row.counts.ties),
                                        std::string(toText(row.outcome)), caughtText(row), tests, naiveTests});
        if (result.rows.empty())
            csv += report::csvLine({result.id, result.title, "", "", "", "", "", "", "", "", "", "", "",
                                    "held by tests", "", tests, naiveTests});
    }
    return csv;
}

std::string matrixCsv(const std::vector<CaseResult>& results) {
    std::string csv =
        "case,title,technique,isExact,verdict,wrong,falseLit,falseShadow,stray,coreErrors,servedPercent,ms,"
        "lit,shadowed,turnedAway,ties,reason\r\n";
    for (const CaseResult& result : results)
        for (const Cell& cell : result.cells) {
            const judge::Counts& c = cell.counts;
            csv += report::csvLine({result.id, result.title, cell.column, cell.isExact ? "yes" : "no",
                                    std::string(toText(cell.standing)), std::to_string(cell.wrong()),
                                    std::to_string(c.falseLit), std::to_string(c.falseShadow), std::to_string(c.stray),
                                    std::to_string(cell.coreErrors), numberText(100 * cell.served), numberText(cell.ms),
                                    std::to_string(c.lit), std::to_string(c.shadowed), std::to_string(c.turnedAway),
                                    std::to_string(c.ties), cell.reason});
        }
    return csv;
}

std::string caughtText(const Row& row) { return !row.caught ? "no setting" : *row.caught ? "caught" : "not caught"; }

std::string titleOf(const CaseResult& result, const Row& row) {
    return row.title.empty() ? result.title : result.title + ": " + row.title;
}

} // namespace shadowlab::hard
