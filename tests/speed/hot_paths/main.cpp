// How the time of every hot path grows with what it works on: Google Benchmark, with a fit of the growth for each.
//
//   ninja -C build/release benchmarks
//   build/release/tests/benchmarks [--benchmark_filter=REGEX] [--benchmark_format=json]
//   build/release/tests/benchmarks --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true
//                                  --benchmark_report_aggregates_only=true
//
// The second form is for a machine on which others work as well: all benchmarks take turns at random, and medians are printed.
// Lines that end in _BigO are the fit, those in _RMS how far the times are from it. N is what the name says: triangles, lights,
// objects, pixels, texels, patches, rays. To be run from the folder that holds assets/. Frames are drawn on the graphics card if there is one, else by Mesa; which it is, is printed first.
// The benches beside this folder, of one question each, hold ways to do one thing against each other.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cstdio>

#include "app/context/context.h"
#include "techniques/foundation/base/error.h"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        const auto context = shadowlab::context::createContext(shadowlab::context::Backend::automatic);
        benchmark::AddCustomContext("GL_RENDERER", shadowlab::context::glRenderer());
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
    } catch (const shadowlab::Error& error) {
        std::fprintf(stderr, "benchmarks: %s\n", error.what());
        return 1;
    }
    return 0;
}
