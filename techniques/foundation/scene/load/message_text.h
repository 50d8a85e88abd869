// Pieces of one-line messages: text from a file made safe to print, and numbers that no locale can change.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace shadowlab::scene {

/// Text from a file as part of a one-line message: control characters and ill-formed UTF-8 as \xNN, the tail of long
/// text as "...".
std::string shown(std::string_view text, std::size_t longest = 60);

/// The same between double quotes.
std::string inQuotes(std::string_view text, std::size_t longest = 60);

/// A path as the user wrote it, but always on one line.
std::string shownPath(const std::filesystem::path& path);

/// Shortest text that reads back as the same number.
std::string numberText(double value);

/// "1 face", "2 faces".
std::string counted(std::uint64_t count, std::string_view singular);

} // namespace shadowlab::scene
