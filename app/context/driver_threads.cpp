// SPDX-License-Identifier: MIT
#include "app/context/driver_threads.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <latch>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace shadowlab::context {

namespace {

/// For rows of tiles, as llvmpipe counts them, and for its caches of shaders.
int threadsOfDriver() {
    constexpr int kMost = 32, kForCaches = 3;
    int rows = static_cast<int>(std::thread::hardware_concurrency());
    if (const char* given = std::getenv("LP_NUM_THREADS")) {
        const std::string_view text(given);
        std::from_chars(text.data(), text.data() + text.size(), rows);
    }
    return std::clamp(rows, 0, kMost) + kForCaches;
}

bool areGiven(int count) {
    std::latch end(1);
    std::vector<std::jthread> threads; // joined when it goes
    bool given = true;
    try {
        for (int i = 0; i < count; ++i)
            threads.emplace_back([&end] { end.wait(); });
    } catch (const std::system_error&) {
        given = false;
    }
    end.count_down();
    return given;
}

} // namespace

void doWithoutRefusedThreads() {
    static const bool asked = [] {
        if (!areGiven(threadsOfDriver())) ::setenv("LP_NUM_THREADS", "0", 1);
        return true;
    }();
    static_cast<void>(asked);
}

} // namespace shadowlab::context
