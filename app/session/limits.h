// The limits of what is read, by name: for `list limits`, and for `--limit NAME=VALUE`, which sets one for this run.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "techniques/foundation/scene/load.h"

namespace shadowlab::session {

struct NamedLimit {
    std::string name, unit;
    std::uint64_t most; ///< it can be raised to
    std::function<std::uint64_t(const scene::Limits&)> value;
    std::function<void(scene::Limits&, std::uint64_t)> set;
};
const std::vector<NamedLimit>& namedLimits();

/// Those in force.
const scene::Limits& limits();

/// As words of a command line, those that are not what they are by themselves.
std::vector<std::string> limitWords();

/// `NAME=VALUE`, before anything is read. Throws Error (usage): no such limit, no whole number, or beyond what it can be raised to.
void setLimit(const std::string& assignment);

} // namespace shadowlab::session
