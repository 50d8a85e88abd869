// SPDX-License-Identifier: MIT
#include "app/context/mesa.h"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <latch>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "app/context/backends.h"

namespace shadowlab::context {

namespace {

bool isAnything(std::string_view value) { return !value.empty(); }

bool isYes(std::string_view value) {
    constexpr std::array<std::string_view, 5> kNo{"", "0", "n", "no", "false"};
    return std::ranges::find(kNo, value) == kNo.end();
}

bool takesAway(std::string_view value) { return value.find('-') != std::string_view::npos; }

/// Widths in bits that llvmpipe has code for; 0 and others crash it.
bool isNoVectorWidth(std::string_view value) {
    constexpr std::array<std::string_view, 4> kWidths{"", "128", "256", "512"};
    return std::ranges::find(kWidths, value) == kWidths.end();
}

struct Setting {
    const char* name;
    bool (*isBad)(std::string_view value);
    const char* what;
};
/// Each was tried with Mesa 22.3.
constexpr std::array<Setting, 5> kSettings{{
    {"GALLIUM_NOOP", isYes, "lets nothing be drawn"},
    {"LP_PERF", isAnything, "leaves parts of the drawing out"},
    {"ST_DEBUG", isAnything, "may draw edges in place of faces"},
    {"LP_NATIVE_VECTOR_WIDTH", isNoVectorWidth, "is no width that the driver has code for"},
    {"MESA_EXTENSION_OVERRIDE", takesAway, "takes away what the driver itself counts on"},
}};

/// The threads that llvmpipe starts: for rows of tiles, and for its caches of shaders.
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

void requireUsableSettings() {
    for (const auto& [name, isBad, what] : kSettings)
        if (const char* value = std::getenv(name); value && isBad(value))
            throw Unavailable("the environment variable " + std::string(name) + " " + what,
                              "unset " + std::string(name));
}

void doWithoutRefusedThreads() {
    static const bool asked = [] {
        if (!areGiven(threadsOfDriver())) ::setenv("LP_NUM_THREADS", "0", 1);
        return true;
    }();
    static_cast<void>(asked);
}

void spareAddresses() {
    rlimit addresses{};
    if (::getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY) ::mallopt(M_ARENA_MAX, 1);
}

} // namespace shadowlab::context
