// Radiosity by patches: form factors, and each solver until its error is certainly below a thousandth. Of the built-in scene
// cornell-room, so it is to be run from the folder that holds assets/.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <map>
#include <memory>

#include "techniques/radiosity/solvers/solvers.h"
#include "tests/speed/cornell_room.h"

namespace shadowlab::radiosity {
namespace {

/// Finding it takes longer than most solvers: once for each number of patches.
struct Exchanged {
    CornellRoom room;
    ExchangeMatrix exchange;
    explicit Exchanged(std::size_t patches) : room(patches), exchange(exactExchange(room)) {}
};
const Exchanged& exchanged(std::int64_t patches) {
    static std::map<std::int64_t, std::unique_ptr<const Exchanged>> known;
    std::unique_ptr<const Exchanged>& found = known[patches];
    if (!found) found = std::make_unique<const Exchanged>(static_cast<std::size_t>(patches));
    return *found;
}

/// Every pair of patches is looked at: quadratic.
void formFactors(benchmark::State& state) {
    const CornellRoom room(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(exactExchange(room));
    state.SetComplexityN(static_cast<std::int64_t>(room.patches.size()));
}
BENCHMARK(formFactors)
    ->RangeMultiplier(2)
    ->Range(80, 640)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime() // on all cores
    ->Complexity(benchmark::oNSquared);

void solver(benchmark::State& state, SolverKind kind) {
    const Exchanged& known = exchanged(state.range(0));
    const Problem problem = known.room.problem(known.exchange);
    constexpr double kWanted = 1e-3;
    for (auto _ : state) {
        const auto solver = makeSolver(kind, problem);
        // More steps than any of them takes: who has not solved the room then never will.
        if (!solve(*solver, kWanted, 1000 * known.room.patches.size())) state.SkipWithError("the room is not solved");
    }
    state.SetComplexityN(static_cast<std::int64_t>(known.room.patches.size()));
}

const int registered = [] {
    for (const SolverKind kind : kSolverKinds)
        // A sweep, or as many shots as there are patches, is a product with the matrix, and how many it takes depends on
        // reflectances alone: quadratic. The direct solver factors the matrix: cubic.
        benchmark::RegisterBenchmark(("solver/" + std::string(nameOf(kind))).c_str(), solver, kind)
            ->RangeMultiplier(2)
            ->Range(80, 640)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime() // on all cores
            ->Complexity(kind == SolverKind::direct ? benchmark::oNCubed : benchmark::oNSquared);
    return 0;
}();

} // namespace
} // namespace shadowlab::radiosity
