// SPDX-License-Identifier: MIT
#include "app/context/driver_settings.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

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

} // namespace

void requireUsableSettings() {
    for (const auto& [name, isBad, what] : kSettings)
        if (const char* value = std::getenv(name); value && isBad(value))
            throw Unavailable("the environment variable " + std::string(name) + " " + what,
                              "unset " + std::string(name));
}

} // namespace shadowlab::context
