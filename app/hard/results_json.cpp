// SPDX-License-Identifier: MIT
#include "app/hard/results_json.h"

#include <array>

namespace shadowlab::hard {

namespace {

template <typename Value>
Json orNull(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// The value that has this text; the last one where none has.
template <typename Value, std::size_t N>
Value fromText(const std::string& text, const std::array<Value, N>& values) {
    for (const Value value : values)
        if (toText(value) == text) return value;
    return values.back();
}

Json countsJson(const judge::Counts& counts) {
    return {{"pixels", counts.pixels},           {"lit", counts.lit},     {"shadowed", counts.shadowed},
            {"turnedAway", counts.turnedAway},   {"ties", counts.ties},   {"falseLit", counts.falseLit},
            {"falseShadow", counts.falseShadow}, {"stray", counts.stray}, {"rmse", counts.rmse}};
}

judge::Counts countsFromJson(const Json& json) {
    judge::Counts counts;
    counts.pixels = json.at("pixels"), counts.lit = json.at("lit"), counts.shadowed = json.at("shadowed");
    counts.turnedAway = json.at("turnedAway"), counts.ties = json.at("ties"), counts.falseLit = json.at("falseLit");
    counts.falseShadow = json.at("falseShadow"), counts.stray = json.at("stray"), counts.rmse = json.at("rmse");
    return counts;
}

Json rowJson(const Row& row) {
    Json measured = Json::array();
    for (const Measured& m : row.measured)
        measured.push_back({{"quantity", m.quantity},
                            {"unit", m.unit},
                            {"bound", m.bound},
                            {"value", m.value},
                            {"holds", m.holds},
                            {"naive", orNull(m.naive)},
                            {"naiveHolds", m.naiveHolds}});
    return {{"title", row.title},
            {"technique", row.technique},
            {"settings", row.settings},
            {"naiveSettings", row.naiveSettings},
            {"measured", measured},
            {"counts", countsJson(row.counts)},
            {"verdict", toText(row.outcome)},
            {"caught", orNull(row.caught)},
            {"ms", row.ms},
            {"picture", row.right.name},
            {"naivePicture", row.naive ? Json(row.naive->name) : Json(nullptr)}};
}

Row rowFromJson(const Json& json, const std::string& caseId) {
    Row row;
    row.caseId = caseId, row.title = json.at("title"), row.technique = json.at("technique");
    row.settings = json.at("settings").get<std::vector<std::string>>();
    row.naiveSettings = json.at("naiveSettings").get<std::vector<std::string>>();
    for (const Json& m : json.at("measured")) {
        Measured measured{m.at("quantity"), m.at("unit"), m.at("bound"), m.at("value"), {}};
        if (!m.at("naive").is_null()) measured.naive = m.at("naive").get<double>();
        measured.holds = m.at("holds"), measured.naiveHolds = m.at("naiveHolds");
        row.measured.push_back(measured);
    }
    row.counts = countsFromJson(json.at("counts"));
    row.outcome = fromText(json.at("verdict"), std::array{Outcome::right, Outcome::provesNothing, Outcome::wrong});
    if (!json.at("caught").is_null()) row.caught = json.at("caught").get<bool>();
    row.ms = json.at("ms"), row.right.name = json.at("picture");
    if (!json.at("naivePicture").is_null()) row.naive = Pictures{json.at("naivePicture"), {}, {}};
    return row;
}

Json cellJson(const Cell& cell) {
    return {{"technique", cell.column},
            {"isExact", cell.isExact},
            {"verdict", toText(cell.standing)},
            {"wrong", cell.wrong()},
            {"coreErrors", cell.coreErrors},
            {"served", cell.served},
            {"ms", cell.ms},
            {"reason", cell.reason},
            {"counts", countsJson(cell.counts)},
            {"picture", cell.pictures.name}};
}

Cell cellFromJson(const Json& json) {
    Cell cell;
    cell.column = json.at("technique"), cell.isExact = json.at("isExact");
    cell.standing = fromText(json.at("verdict"), std::array{Standing::exact, Standing::edges, Standing::provesNothing,
                                                            Standing::refused, Standing::wrong});
    cell.counts = countsFromJson(json.at("counts"));
    cell.coreErrors = json.at("coreErrors"), cell.served = json.at("served"), cell.ms = json.at("ms");
    cell.reason = json.at("reason"), cell.pictures.name = json.at("picture");
    return cell;
}

} // namespace

Json toJson(const CaseResult& result) {
    Json rows = Json::array(), cells = Json::array();
    for (const Row& row : result.rows)
        rows.push_back(rowJson(row));
    for (const Cell& cell : result.cells)
        cells.push_back(cellJson(cell));
    return {{"case", result.id},
            {"title", result.title},
            {"why", result.why},
            {"checks", rows},
            {"techniques", cells},
            {"tests", result.tests},
            {"naiveTests", result.naiveTests},
            {"withoutNaive", result.withoutNaive}};
}

CaseResult caseResultFromJson(const Json& json) {
    CaseResult result;
    result.id = json.at("case"), result.title = json.at("title"), result.why = json.at("why");
    for (const Json& row : json.at("checks"))
        result.rows.push_back(rowFromJson(row, result.id));
    for (const Json& cell : json.at("techniques"))
        result.cells.push_back(cellFromJson(cell));
    result.tests = json.at("tests").get<std::vector<std::string>>();
    result.naiveTests = json.at("naiveTests").get<std::vector<std::string>>();
    result.withoutNaive = json.at("withoutNaive");
    return result;
}

} // namespace shadowlab::hard
