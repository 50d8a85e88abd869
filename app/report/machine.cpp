// SPDX-License-Identifier: MIT
#include "app/report/machine.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "app/context/context.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::report {

namespace {

/// "model name : AMD EPYC" of /proc/cpuinfo; where there is none, "unknown".
std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            if (const std::size_t colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "unknown";
}

/// Mesa's software rasteriser takes as many threads as there are cores, up to 16, or what LP_NUM_THREADS says; 0: not one of
/// processors.
int rasterThreads(const std::string& renderer, int cores) {
    if (renderer.find("llvmpipe") == std::string::npos) return 0;
    constexpr int kMost = 16;
    const char* asked = std::getenv("LP_NUM_THREADS");
    return asked ? std::atoi(asked) : std::min(cores, kMost);
}

} // namespace

Machine thisMachine(const std::string& backend) {
    Machine machine;
    machine.processor = processorName();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.threads = trace::threadCount();
    machine.renderer = context::glRenderer();
    machine.glVersion = context::glVersion();
    machine.backend = backend;
    machine.rasterThreads = rasterThreads(machine.renderer, machine.cores);
    machine.memoryGigabytes =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 30);
#ifdef __clang__
    machine.compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
    machine.compiler = "gcc " __VERSION__;
#endif
    machine.program = SHADOWLAB_VERSION;
    return machine;
}

} // namespace shadowlab::report
