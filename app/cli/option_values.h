// From the text of an option to a checked value. Each function throws Error (usage) with a message that names the option and
// what it takes.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::cli {

/// Throws Error (usage).
[[noreturn]] void refuseUsage(const std::string& message);

/// Does the name end as those of pictures and films do, in whatever format?
bool endsAsPicture(const std::filesystem::path& path);

/// Refuses an output whose name does not end in `ending`, with the name that would do: "x.png" for "x.jpg".
void requireEnding(const std::string& option, const std::filesystem::path& path, const std::string& ending);

/// "320,180": a pixel of a picture of that size.
ivec2 pixelFrom(const std::string& option, const std::string& text, ivec2 size);

/// "1280x720". Throws Error (overLimit) for a side beyond the limit of that name (picture/limits.h).
ivec2 sizeFrom(const std::string& option, const std::string& text, std::string_view limit);
bool booleanFrom(const std::string& option, const std::string& text);
/// An angle within a million degrees.
double degreesFrom(const std::string& option, const std::string& text);
/// A time that a picture can stay, in seconds: from 0.01 to 60.
double secondsFrom(const std::string& option, const std::string& text);
/// A size in megabytes, 10^6 bytes, from 0.1 to 500; in bytes.
std::size_t megabytesFrom(const std::string& option, const std::string& text);
/// A whole number from 1 to `most`.
int countFrom(const std::string& option, const std::string& text, int most);
/// A seed that random choices follow from is a count up to this: a round number that an int holds.
inline constexpr int kMostSeed = 2'000'000'000;
/// A whole number from 1. Throws Error (overLimit) beyond the limit of that name.
int limitedCountFrom(const std::string& option, const std::string& text, std::string_view limit);
/// Index of the text among `choices`.
int choiceFrom(const std::string& option, const std::string& text, const std::vector<std::string>& choices);
/// "a,b,c" in its parts.
std::vector<std::string> splitAtCommas(const std::vector<std::string>& texts);

} // namespace shadowlab::cli
