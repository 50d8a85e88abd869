// What each solver knows of its error, and what the error is, against time.
//
// Errors are those of the largest of all patches and colours, as shares of the largest radiosity, the lamp's. The true one is that
// against conjugate gradients at their end, which is right to some 1e-15. Both are asked for after 1, 2, 3, 4, 5 steps and then
// after a fifth more each time, with the clock stopped. Three rounds in which all solvers take turns; medians.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "techniques/radiosity/solvers/solvers.h"
#include "tests/speed/log_log_plot.h"
#include "tests/speed/radiosity_bench.h"

namespace shadowlab::radiosity {

namespace {

constexpr int kRounds = 3;
constexpr double kWanted = 1e-10;          // bound at which a solver is done
constexpr std::size_t kMostSteps = 400000; // some seconds of shots

struct Point {
    std::size_t steps;
    double bound, error;
    std::vector<double> ms; ///< of each round
};

double largest(const dvec3& v) { return std::max({v.x, v.y, v.z}); }

double largestDifference(const std::vector<dvec3>& a, const std::vector<dvec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, largest(glm::abs(a[i] - b[i])));
    return most;
}

/// As said above, until it is solved.
std::vector<Point> pointsOf(SolverKind kind, const Problem& problem, const std::vector<dvec3>& truth, double scale) {
    std::vector<Point> points;
    const auto solver = makeSolver(kind, problem);
    for (std::size_t next = 1; solver->steps() < kMostSteps; next = std::max(next + 1, next * 6 / 5)) {
        while (solver->steps() < next)
            solver->step();
        points.push_back({next,
                          largest(solver->errorBound().largest) / scale,
                          largestDifference(solver->radiosity(), truth) / scale,
                          {}});
        if (points.back().bound <= kWanted || kind == SolverKind::direct) break;
    }
    return points;
}

void time(SolverKind kind, const Problem& problem, std::vector<Point>& points) {
    const auto solver = makeSolver(kind, problem);
    double ms = 0;
    for (Point& point : points) {
        ms += clockMs([&] {
            while (solver->steps() < point.steps)
                solver->step();
        });
        point.ms.push_back(ms);
    }
}

void draw(const std::vector<std::vector<Point>>& all, const std::filesystem::path& file) {
    // Okabe and Ito's colours, which survive colour blindness.
    const char* const colors[] = {"#000000", "#e69f00", "#56b4e9", "#009e73", "#cc79a7", "#d55e00"};
    LogLogPlot plot{.xLabel = "milliseconds",
                    .yLabel = "largest error, of the largest radiosity",
                    .firstX = 1,
                    .lastX = 20000,
                    .xMarks = {1, 10, 100, 1000, 10000},
                    .firstPower = -12, // rounding is less than what is drawn
                    .lastPower = 1,
                    .lines = {},
                    .remark = "dashed: bound"};
    for (std::size_t kind = 0; kind < all.size(); ++kind) {
        LogLogLine error{std::string(nameOf(kSolverKinds[kind])), colors[kind], {}, {}},
            bound{"", colors[kind], {}, {}, true};
        for (const Point& point : all[kind]) {
            const double ms = median(point.ms);
            if (ms < plot.firstX) continue;
            error.x.push_back(ms);
            error.y.push_back(point.error);
            bound.x.push_back(ms);
            bound.y.push_back(point.bound);
        }
        plot.lines.push_back(error);
        plot.lines.push_back(bound);
    }
    std::ofstream(file) << logLogPlot(plot);
}

} // namespace

void benchSolvers(std::size_t count, const std::filesystem::path& plots) {
    const CornellRoom room(count);
    const ExchangeMatrix exchange = exactExchange(room);
    const Problem problem = room.problem(exchange);
    const auto best = makeSolver(SolverKind::conjugateGradients, problem);
    for (int step = 0; step < 100; ++step)
        best->step();
    const std::vector<dvec3> truth = best->radiosity();
    double scale = 0;
    for (const dvec3& b : truth)
        scale = std::max(scale, largest(b));
    std::vector<std::vector<Point>> all;
    for (const SolverKind kind : kSolverKinds)
        all.push_back(pointsOf(kind, problem, truth, scale));
    for (int round = 0; round < kRounds; ++round)
        for (std::size_t kind = 0; kind < all.size(); ++kind)
            time(kSolverKinds[kind], problem, all[kind]);

    std::printf("cornell-room, %zu patches: steps and milliseconds until the bound is below, and the error then\n",
                room.patches.size());
    std::printf("| %-19s | %-29s | %-29s | %-29s | %9s |\n", "solver", "1e-3", "1e-6", "1e-10", "ms a step");
    for (std::size_t kind = 0; kind < all.size(); ++kind) {
        std::printf("| %-19s |", std::string(nameOf(kSolverKinds[kind])).c_str());
        for (const double wanted : {1e-3, 1e-6, 1e-10}) {
            const auto found = std::ranges::find_if(all[kind], [&](const Point& p) { return p.bound <= wanted; });
            if (found == all[kind].end())
                std::printf(" %29s |", "-");
            else
                std::printf(" %7zu %9.1f ms %8.1e |", found->steps, median(found->ms), found->error);
        }
        const Point& last = all[kind].back();
        std::printf(" %9.4f |\n", median(last.ms) / static_cast<double>(last.steps));
    }
    if (!plots.empty()) draw(all, plots / "radiosity-solvers.svg");
}

} // namespace shadowlab::radiosity
