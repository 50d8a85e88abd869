// SPDX-License-Identifier: MIT
#include "app/report/json_parts.h"

#include <limits>
#include <stdexcept>

namespace shadowlab::report {

namespace {

void require(bool holds, const char* what) {
    if (!holds) throw std::domain_error(what);
}

int countOf(const Json& json) {
    require(json.is_number_integer() && json >= 0 && json <= std::numeric_limits<int>::max(), "no count of pixels");
    return json.get<int>();
}

double notNegative(const Json& json) {
    require(json.is_number() && json >= 0, "less than nothing");
    return json.get<double>();
}

} // namespace

Json toJson(const PointKey& point) {
    return {{"technique", point.technique},
            {"settings", point.settings},
            {"sweep", point.sweep},
            {"varies", point.varies},
            {"value", point.value}};
}

PointKey pointFromJson(const Json& json) {
    return {json.at("technique"), json.at("settings"), json.at("sweep"), json.at("varies"), json.at("value")};
}

Json toJson(const Plan& plan) {
    Json groups = Json::array();
    for (const PlannedGroup& group : plan.groups) {
        Json points = Json::array();
        for (const PointKey& point : group.points)
            points.push_back(toJson(point));
        groups.push_back({{"scene", group.scene},
                          {"title", group.title},
                          {"light", group.light},
                          {"digest", group.digest},
                          {"points", points}});
    }
    return {{"program", plan.program}, {"build", plan.build},       {"size", {plan.size.x, plan.size.y}},
            {"quick", plan.isQuick},   {"renderer", plan.renderer}, {"furtherWords", plan.furtherWords},
            {"groups", groups}};
}

Plan planFromJson(const Json& json) {
    Plan plan{json.at("program"),
              json.at("build"),
              ivec2(json.at("size").at(0).get<int>(), json.at("size").at(1).get<int>()),
              json.at("quick"),
              json.at("renderer"),
              json.at("furtherWords").get<std::vector<std::string>>(),
              {}};
    for (const Json& group : json.at("groups")) {
        PlannedGroup planned{group.at("scene"), group.at("title"), group.at("light"), group.at("digest"), {}};
        for (const Json& point : group.at("points"))
            planned.points.push_back(pointFromJson(point));
        plan.groups.push_back(std::move(planned));
    }
    return plan;
}

Json toJson(const Errors& errors) {
    Json counters = Json::array();
    for (const Errors::Counter& counter : errors.counters)
        counters.push_back({{"id", counter.id}, {"unit", counter.unit}, {"built", counter.built}, {"of", counter.of}});
    return {{"truth", errors.truth == judge::TruthOf::area ? "area" : "centre"},
            {"pixels", errors.pixels},
            {"lit", errors.lit},
            {"shadowed", errors.shadowed},
            {"turnedAway", errors.turnedAway},
            {"ties", errors.ties},
            {"falseLit", errors.falseLit},
            {"falseShadow", errors.falseShadow},
            {"coreErrors", errors.core},
            {"served", errors.served},
            {"rmse", errors.rmse},
            {"edgeErrorPx", errors.edgeErrorPx ? Json(*errors.edgeErrorPx) : Json(nullptr)},
            {"converged", errors.converged},
            {"glMegabytes", errors.glMegabytes},
            {"counters", counters}};
}

Errors errorsFromJson(const Json& json) {
    Errors errors;
    errors.truth = json.at("truth") == "area" ? judge::TruthOf::area : judge::TruthOf::centre;
    errors.pixels = countOf(json.at("pixels")), errors.lit = countOf(json.at("lit"));
    errors.shadowed = countOf(json.at("shadowed")), errors.turnedAway = countOf(json.at("turnedAway"));
    errors.ties = countOf(json.at("ties")), errors.falseLit = countOf(json.at("falseLit"));
    errors.falseShadow = countOf(json.at("falseShadow")), errors.core = countOf(json.at("coreErrors"));
    const std::int64_t dark = std::int64_t{errors.shadowed} + errors.turnedAway;
    require(errors.lit + dark + errors.ties == errors.pixels, "pixels that are neither lit, dark nor ties");
    require(errors.falseLit <= dark && errors.falseShadow <= errors.lit, "more wrong pixels than there are");
    require(errors.core <= std::int64_t{errors.falseLit} + errors.falseShadow, "more core errors than wrong pixels");
    errors.served = notNegative(json.at("served")), errors.rmse = notNegative(json.at("rmse"));
    require(errors.served <= 1 && errors.rmse <= 1, "more than all");
    if (!json.at("edgeErrorPx").is_null()) errors.edgeErrorPx = notNegative(json.at("edgeErrorPx"));
    errors.converged = json.at("converged"), errors.glMegabytes = notNegative(json.at("glMegabytes"));
    for (const Json& counter : json.at("counters"))
        errors.counters.push_back({counter.at("id"), counter.at("unit"), counter.at("built"), counter.at("of")});
    return errors;
}

Json toJson(const Times& times) {
    Json rounds = Json::array();
    for (const Times::Round& round : times.rounds) {
        Json points = Json::object();
        for (const auto& [name, turn] : round) {
            Json passes = Json::array();
            for (const Costs::Pass& pass : turn.passes)
                passes.push_back({pass.id, pass.ms});
            points[name] = {{"frame", turn.frame},   {"prepare", turn.prepare}, {"draw", turn.draw},
                            {"encode", turn.encode}, {"atRest", turn.atRest},   {"passes", passes}};
        }
        rounds.push_back(std::move(points));
    }
    return {{"rounds", rounds}, {"firstMs", times.firstMs}, {"residentMegabytes", times.residentMegabytes}};
}

Times timesFromJson(const Json& json) {
    Times times;
    for (const Json& points : json.at("rounds")) {
        Times::Round round;
        for (const auto& [name, turn] : points.items()) {
            Turn& read = round[name];
            const auto msOf = [&turn](const char* key) {
                std::vector<double> ms;
                for (const Json& one : turn.at(key))
                    ms.push_back(notNegative(one));
                return ms;
            };
            read.frame = msOf("frame"), read.prepare = msOf("prepare"), read.draw = msOf("draw");
            read.encode = msOf("encode"), read.atRest = msOf("atRest");
            for (const Json& pass : turn.at("passes"))
                read.passes.push_back({pass.at(0), notNegative(pass.at(1))});
        }
        times.rounds.push_back(std::move(round));
    }
    times.firstMs = json.at("firstMs").get<std::map<std::string, double>>();
    times.residentMegabytes = json.at("residentMegabytes").get<std::map<std::string, double>>();
    return times;
}

Json toJson(const Machine& machine) {
    return {{"processor", machine.processor},
            {"cores", machine.cores},
            {"threads", machine.threads},
            {"rasterThreads", machine.rasterThreads},
            {"memoryGigabytes", machine.memoryGigabytes},
            {"renderer", machine.renderer},
            {"glVersion", machine.glVersion},
            {"backend", machine.backend},
            {"compiler", machine.compiler},
            {"program", machine.program}};
}

Machine machineFromJson(const Json& json) {
    Machine machine;
    machine.processor = json.at("processor"), machine.renderer = json.at("renderer");
    machine.glVersion = json.at("glVersion"), machine.backend = json.at("backend");
    machine.compiler = json.at("compiler"), machine.program = json.at("program");
    machine.cores = json.at("cores"), machine.threads = json.at("threads");
    machine.rasterThreads = json.at("rasterThreads"), machine.memoryGigabytes = json.at("memoryGigabytes");
    return machine;
}

} // namespace shadowlab::report
