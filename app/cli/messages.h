// What the program prints: data on standard output, messages on standard error, a line for each.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace shadowlab::cli {

/// Called once, first thing in main: a standard descriptor that the caller has closed gets a stand-in. Otherwise the
/// next file to be opened would take its number, and messages would end up inside a picture.
void keepStandardDescriptors();

/// Writes data to standard output at once. Throws Error (cannotWrite) with the reason when that fails; a reader that
/// has closed its end of the pipe (`list parameters | head -1`) has what it wanted, and is no failure.
void print(std::string_view text);

/// How many columns the terminal has that standard output is; none where it is a pipe or a file, which programs read.
std::optional<std::size_t> terminalColumns();

/// "shadowlab: note: ..." on standard error: a remark about something that is not an error.
void note(std::string_view sentence);

/// "shadowlab: ..." on standard error: the error that ends the program.
void complain(std::string_view sentence);

} // namespace shadowlab::cli
