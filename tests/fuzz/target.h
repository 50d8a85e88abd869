// A fuzz target: one function that takes any bytes, hands them to the readers that they are meant for, and goes on to use what
// was read. clang's libFuzzer makes up bytes (`./check --long`), and replay_main.cpp feeds those that are kept in corpus/.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace shadowlab::fuzz {

/// Were the bytes taken, or refused with a message that helps? Nothing else may come of them.
enum class Outcome { refused, taken };

/// Defined by each target.
Outcome feed(std::string_view bytes);

/// Something is wrong although nothing crashed. Caught by nobody: it ends the run, as a crash does.
struct Fault : std::logic_error {
    using std::logic_error::logic_error;
};
inline void require(bool holds, const std::string& what) {
    if (!holds) throw Fault(what);
}

/// Refused, if the action throws an Error. Requires of that what is promised of all: it says how to fix what is wrong, and its
/// exit status blames what was given and not the program.
Outcome outcomeOf(const std::function<void()>& action);

/// Assets with small scenes alone, `plain` and `lamps`: decks and lessons load those that they name.
inline constexpr const char* kOwnAssets = SHADOWLAB_SOURCE_DIR "/tests/fuzz/assets";

/// A folder of this process alone, for bytes that are read from a file; it vanishes with the process.
const std::filesystem::path& ownFolder();

/// Writes a file there and returns its path.
std::filesystem::path written(const char* name, std::string_view bytes);

} // namespace shadowlab::fuzz
