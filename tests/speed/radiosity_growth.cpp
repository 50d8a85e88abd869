// Time, memory and error of the radiosity of a room, against the number of its patches.
//
// From row to row the edges of all patches are halved, so that patches of one run are made of whole patches of the finer ones. (Where
// they are not, the mean of a finer run over a patch is itself uncertain, by more than what is looked for.) The error is that of
// cutting into patches: against the radiosity B' of the finest run, on all surfaces but the lamp.
//   means   of each patch: B against the mean of B' over the patch
//   flat    of each point: B of its patch against B' there, which is what a picture with one colour for a patch is wrong by
// Both are root mean squares over the area and the three colours, as a share of that of B'.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <fstream>

#include "tests/speed/log_log_plot.h"
#include "tests/speed/radiosity_bench.h"

namespace shadowlab::radiosity {

namespace {

constexpr std::size_t kCoarsest = 320; // patches; with contacts 340, then 1300, 5100, 20300

struct Run {
    std::vector<Patch> patches;
    std::vector<dvec3> radiosity;
    std::vector<bool> isLamp;
    double cutMs = 0, exchangeMs = 0, solveMs = 0, bytes = 0;
};

Run runOf(int halvings) {
    Run run;
    std::optional<CornellRoom> room;
    run.cutMs = clockMs([&] { room.emplace(kCoarsest, halvings); });
    std::optional<ExchangeMatrix> exchange;
    run.exchangeMs = clockMs([&] { exchange = exactExchange(*room); });
    const Problem problem = room->problem(*exchange);
    std::vector<double> times;
    for (int round = 0; round < 3; ++round)
        times.push_back(clockMs([&] { run.radiosity = solved(problem); }));
    run.solveMs = median(times);
    run.bytes = static_cast<double>(exchange->bytes());
    run.patches = room->patches;
    for (std::size_t i = 0; i < run.patches.size(); ++i)
        run.isLamp.push_back(room->isLamp(i));
    return run;
}

/// What two patches of one face have in common, m^2.
double commonArea(const Patch& a, const Patch& b) {
    constexpr double kTolerance = 1e-12; // metres
    Polygon rest = b.polygon;
    for (std::size_t i = 0; i < a.polygon.count() && !rest.isEmpty(); ++i) {
        const dvec3& from = a.polygon[i];
        const dvec3 along = a.polygon[(i + 1) % a.polygon.count()] - from;
        rest = partBefore({from, glm::normalize(glm::cross(a.normal, along))}, rest, kTolerance);
    }
    return rest.isEmpty() ? 0 : glm::length(areaVector(rest));
}

struct Errors {
    double ofMeans = 0, flat = 0;
};

Errors errorsOf(const Run& run, const Run& finest) {
    double all = 0, ofMeans = 0, flat = 0, area = 0;
    std::vector<trace::CentredBox> boxes;
    for (const Patch& patch : finest.patches)
        boxes.push_back(boxOf(patch.polygon));
    std::size_t first = 0;
    for (std::size_t i = 0; i < run.patches.size(); ++i) {
        const Patch& patch = run.patches[i];
        while (finest.patches[first].face < patch.face)
            ++first;
        if (run.isLamp[i]) continue;
        trace::CentredBox box = boxOf(patch.polygon);
        box.grow(1e-9); // boxes of walls are flat
        dvec3 sum(0);
        double covered = 0;
        for (std::size_t k = first; k < finest.patches.size() && finest.patches[k].face == patch.face; ++k) {
            if (!box.touches(boxes[k])) continue;
            const double common = commonArea(patch, finest.patches[k]);
            const dvec3 b = finest.radiosity[k], wrong = run.radiosity[i] - b;
            sum += common * b;
            covered += common;
            all += common * glm::dot(b, b);
            flat += common * glm::dot(wrong, wrong);
        }
        const dvec3 wrong = run.radiosity[i] - sum / covered;
        ofMeans += covered * glm::dot(wrong, wrong);
        area += patch.area - covered;
    }
    if (std::abs(area) > 1e-6) std::printf("%g m^2 of the patches are not those of the finest run\n", area);
    return {std::sqrt(ofMeans / all), std::sqrt(flat / all)};
}

void draw(const std::vector<Run>& runs, const std::vector<Errors>& errors, const std::filesystem::path& folder) {
    const auto patchesOf = [](const Run& run) { return static_cast<double>(run.patches.size()); };
    LogLogPlot time{.xLabel = "patches",
                    .yLabel = "seconds",
                    .firstX = 0.8 * patchesOf(runs.front()),
                    .lastX = 1.2 * patchesOf(runs.back()),
                    .xMarks = {},
                    .firstPower = -4,
                    .lastPower = 3,
                    .lines = {{"exchange areas", "#d55e00", {}, {}}, {"conjugate gradients", "#0072b2", {}, {}}},
                    .remark = {}};
    LogLogPlot error{.xLabel = "patches",
                     .yLabel = "relative RMS error of the radiosity",
                     .firstX = time.firstX,
                     .lastX = time.lastX,
                     .xMarks = {},
                     .firstPower = -3,
                     .lastPower = 0,
                     .lines = {{"one colour for a patch", "#d55e00", {}, {}}, {"means of patches", "#0072b2", {}, {}}},
                     .remark = {}};
    for (const Run& run : runs) {
        time.xMarks.push_back(patchesOf(run));
        error.xMarks.push_back(patchesOf(run));
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double patches = patchesOf(runs[i]);
        for (std::size_t line = 0; line < 2; ++line) {
            time.lines[line].x.push_back(patches);
            time.lines[line].y.push_back((line == 0 ? runs[i].exchangeMs : runs[i].solveMs) / 1000);
            if (i + 1 == runs.size()) continue; // the finest has no error against itself
            error.lines[line].x.push_back(patches);
            error.lines[line].y.push_back(line == 0 ? errors[i].flat : errors[i].ofMeans);
        }
    }
    std::ofstream(folder / "radiosity-growth-time.svg") << logLogPlot(time);
    std::ofstream(folder / "radiosity-growth-error.svg") << logLogPlot(error);
}

} // namespace

void benchGrowth(int halvings, const std::filesystem::path& plots) {
    std::printf("cornell-room; each once, solving: median of three\n");
    std::printf("| %7s | %8s | %10s | %8s | %8s |\n", "patches", "cut ms", "exchange s", "solve ms", "MiB");
    std::vector<Run> runs;
    for (int i = 0; i <= halvings; ++i) {
        runs.push_back(runOf(i));
        const Run& run = runs.back();
        std::printf("| %7zu | %8.1f | %10.2f | %8.1f | %8.1f |\n", run.patches.size(), run.cutMs, run.exchangeMs / 1000,
                    run.solveMs, run.bytes / (1 << 20));
        std::fflush(stdout);
    }
    std::printf("error against %zu patches\n| %7s | %9s | %9s |\n", runs.back().patches.size(), "patches", "means",
                "flat");
    std::vector<Errors> errors;
    for (const Run& run : runs) {
        errors.push_back(errorsOf(run, runs.back()));
        if (&run == &runs.back()) break;
        std::printf("| %7zu | %9.5f | %9.5f |\n", run.patches.size(), errors.back().ofMeans, errors.back().flat);
    }
    if (!plots.empty()) draw(runs, errors, plots);
}

} // namespace shadowlab::radiosity
