// SPDX-License-Identifier: MIT
#include "app/report/assemble.h"

#include <algorithm>

#include "app/report/analysis.h"
#include "app/report/page/chart.h"
#include "app/report/page/page.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"

namespace shadowlab::report {

namespace {

/// A word as a POSIX shell reads it.
std::string quoted(const std::string& word) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=./:,@+";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// The times of the shard that has measured the point.
std::optional<Costs> costsIn(const std::vector<Times>& ofShards, const std::string& point,
                             const std::string& yardstick) {
    for (const Times& times : ofShards)
        if (const std::optional<Costs> costs = costsOf(times, point, yardstick)) return costs;
    return std::nullopt;
}

} // namespace

std::vector<std::string> missingPoints(std::span<const Store> stores, const Plan& plan) {
    std::vector<std::string> missing;
    for (const PlannedGroup& group : plan.groups)
        for (const PointKey& point : group.points)
            if (std::ranges::none_of(stores,
                                     [&](const Store& store) { return store.judged(group, point).has_value(); }))
                missing.push_back(group.title + "@" + group.light + " " + point.name());
    return missing;
}

std::string commandFor(const Plan& plan, const PlannedGroup& group, const PointKey& point) {
    constexpr int kFrames = 30;
    std::string command = "shadowlab measure " + quoted(group.scene) + " -t " + point.technique;
    for (const std::string& setting : point.settings)
        command += " --set " + quoted(point.technique + "." + setting);
    command += " --light " + quoted(group.light) + " --size " + std::to_string(plan.size.x) + "x" +
               std::to_string(plan.size.y) + " --frames " + std::to_string(kFrames) + " --orbit-light " +
               std::to_string(kFrames); // one degree a frame
    for (const std::string& word : plan.furtherWords)
        command += " " + quoted(word);
    return command;
}

Report assemble(const Store& store) {
    const Plan plan = store.plan();
    Report report{plan.size, plan.isQuick, 0, {}, {}};
    const std::vector<Shard> shards = store.shards();
    for (const Shard& shard : shards)
        report.machines.push_back(store.machine(shard));
    for (const PlannedGroup& planned : plan.groups) {
        std::vector<Times> times;
        for (const Shard& shard : shards) {
            times.push_back(store.times(planned, shard));
            report.rounds = std::max(report.rounds, static_cast<int>(times.back().rounds.size()));
        }
        const std::string yardstick = planned.points.front().name();
        for (const judge::TruthOf truth : {judge::TruthOf::centre, judge::TruthOf::area}) {
            Group group{planned.title, planned.light, truth, {}, {}, {}};
            for (const PointKey& key : planned.points) {
                const std::optional<Judge::Judged> judged = store.judged(planned, key);
                if (!judged || judged->errors.truth != truth) continue;
                group.points.push_back({key, judged->errors, costsIn(times, key.name(), yardstick),
                                        commandFor(plan, planned, key), judged->picturePng, judged->errorPng, false,
                                        key.technique == kYardstick});
            }
            if (group.points.empty()) continue;
            analyse(group);
            report.groups.push_back(std::move(group));
        }
    }
    return report;
}

void writeOutputs(const Store& store, const Report& report) {
    const std::filesystem::path& folder = store.folder();
    image::writeWhole(folder / "report.json", reportJson(report));
    image::writeWhole(folder / "points.csv", reportCsv(report));
    image::makeFolders(folder / "charts");
    for (const Group& group : report.groups)
        image::writeWhole(folder / "charts" / (fileName(group.name()) + ".svg"), costErrorChart(group, report.size));
    image::writeWhole(folder / "index.html", htmlPage(report));
}

} // namespace shadowlab::report
