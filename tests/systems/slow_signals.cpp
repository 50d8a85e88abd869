// A library to be loaded before all others (LD_PRELOAD): llvmpipe's threads that say that they have drawn are stopped meanwhile, as a busy
// machine may stop them. At the end it says how often, and how often what they were waking others by had been freed by then.
//
// It takes what is filled with MALLOC_PERTURB_ = 90 for freed: run the program with that.
// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstring>

namespace {

constexpr unsigned char kFreed = 90;
constexpr useconds_t kStopped = 2000; // microseconds: longer than it takes to begin the next picture

std::atomic<int> signals, freed;

struct Report {
    ~Report() { std::fprintf(stderr, "signals %d, freed %d\n", signals.load(), freed.load()); }
} report;

bool isOfLlvmpipe() {
    std::array<char, 16> name{};
    pthread_getname_np(pthread_self(), name.data(), name.size());
    return std::strncmp(name.data(), "llvmpipe", 8) == 0;
}

} // namespace

extern "C" int pthread_cond_broadcast(pthread_cond_t* condition) {
    static const auto real = reinterpret_cast<int (*)(pthread_cond_t*)>(dlsym(RTLD_NEXT, "pthread_cond_broadcast"));
    if (!isOfLlvmpipe()) return real(condition);
    ++signals;
    usleep(kStopped);
    std::array<unsigned char, sizeof(pthread_cond_t)> bytes{};
    std::memcpy(bytes.data(), condition, bytes.size());
    // malloc keeps its own notes in the first bytes of what is freed; in a condition that lives few are not 0.
    if (std::ranges::count(bytes, kFreed) < static_cast<int>(bytes.size() / 3)) return real(condition);
    ++freed;
    return 0;
}
