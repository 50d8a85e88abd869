// A report as JSON and as CSV (RFC 4180).
// SPDX-License-Identifier: MIT
#include "app/report/assemble.h"
#include "app/report/csv.h"
#include "app/report/json_parts.h"

namespace shadowlab::report {

namespace {

Json spreadJson(const Spread& spread) {
    return {{"median", spread.median}, {"lower", spread.lower}, {"upper", spread.upper}, {"p95", spread.p95}};
}

Json costsJson(const Costs& costs) {
    Json passes = Json::object();
    for (const Costs::Pass& pass : costs.passes)
        passes[pass.id] = pass.ms;
    return {{"frames", costs.frames},
            {"frameMs", spreadJson(costs.frame)},
            {"prepareMs", spreadJson(costs.prepare)},
            {"drawMs", spreadJson(costs.draw)},
            {"encodeMs", spreadJson(costs.encode)},
            {"shadowMs", spreadJson(costs.shadow)},
            {"atRestMs", spreadJson(costs.atRest)},
            {"firstMs", costs.firstMs},
            {"passMs", passes},
            {"residentMegabytes", costs.residentMegabytes}};
}

Json exactnessJson(const Group& group) {
    const auto name = [&](const std::optional<std::size_t>& point) {
        return point ? Json(group.points[*point].key.name()) : Json(nullptr);
    };
    const ExactAgainstInexact& exactness = group.exactness;
    return {{"exact", name(exactness.exact)},
            {"inexact", name(exactness.inexact)},
            {"frameRatio", exactness.frameRatio},
            {"shadowRatio", exactness.shadowRatio},
            {"why", exactness.why}};
}

} // namespace

std::string reportJson(const Report& report) {
    Json groups = Json::array();
    for (const Group& group : report.groups) {
        Json points = Json::array();
        for (const Point& point : group.points) {
            Json json = toJson(point.key);
            json["errors"] = toJson(point.errors);
            json["command"] = point.command;
            json["costs"] = point.costs ? costsJson(*point.costs) : Json(nullptr);
            json["onFront"] = point.onFront;
            points.push_back(std::move(json));
        }
        Json growth = Json::array();
        for (const Growth& g : group.growth)
            growth.push_back({{"technique", g.technique},
                              {"sweep", g.sweep},
                              {"varies", g.varies},
                              {"from", g.from},
                              {"to", g.to},
                              {"costPower", g.costPower},
                              {"errorPower", g.errorPower ? Json(*g.errorPower) : Json(nullptr)}});
        groups.push_back({{"scene", group.scene},
                          {"light", group.light},
                          {"truth", group.truth == judge::TruthOf::area ? "area" : "centre"},
                          {"points", points},
                          {"growth", growth},
                          {"exactness", exactnessJson(group)}});
    }
    Json machines = Json::array();
    for (const Machine& machine : report.machines)
        machines.push_back(toJson(machine));
    const Json root = {{"size", {report.size.x, report.size.y}},
                       {"quick", report.isQuick},
                       {"rounds", report.rounds},
                       {"machines", machines},
                       {"groups", groups}};
    return root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string reportCsv(const Report& report) {
    std::string csv =
        "scene,light,truth,technique,settings,sweep,pixels,lit,shadowed,turnedAway,ties,falseLit,falseShadow,"
        "coreErrors,served,rmse,edgeErrorPx,glMegabytes,frames,frameMs,frameMsLower,frameMsUpper,frameMsP95,"
        "prepareMs,drawMs,encodeMs,shadowMs,shadowMsLower,shadowMsUpper,atRestMs,firstMs,residentMegabytes,"
        "onFront,command\r\n";
    for (const Group& group : report.groups)
        for (const Point& point : group.points) {
            const Errors& e = point.errors;
            std::vector<std::string> fields = {group.scene,
                                               group.light,
                                               group.truth == judge::TruthOf::area ? "area" : "centre",
                                               point.key.technique,
                                               joined(point.key.settings),
                                               point.key.sweep};
            for (const int count :
                 {e.pixels, e.lit, e.shadowed, e.turnedAway, e.ties, e.falseLit, e.falseShadow, e.core})
                fields.push_back(std::to_string(count));
            fields.insert(fields.end(), {numberText(e.served), numberText(e.rmse), e.edgeErrorPx ? numberText(*e.edgeErrorPx) : "",
                                         numberText(e.glMegabytes)});
            if (const std::optional<Costs>& c = point.costs) {
                fields.push_back(std::to_string(c->frames));
                for (const double ms :
                     {c->frame.median, c->frame.lower, c->frame.upper, c->frame.p95, c->prepare.median, c->draw.median,
                      c->encode.median, c->shadow.median, c->shadow.lower, c->shadow.upper, c->atRest.median,
                      c->firstMs, c->residentMegabytes})
                    fields.push_back(numberText(ms));
            } else {
                fields.insert(fields.end(), 14, "");
            }
            fields.push_back(point.onFront ? "true" : "false");
            fields.push_back(point.command);
            csv += csvLine(fields);
        }
    return csv;
}

} // namespace shadowlab::report
