// Where `capture` writes: names of files, and what must not be overwritten.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "app/cli/capture/capture.h"

namespace shadowlab::cli {

/// `name_####.png` with the hashes replaced by the frame's number, counted from 1, padded with zeros to their width.
std::filesystem::path numbered(const std::filesystem::path& pattern, int frame);

/// Throws Error (usage) when several pictures would have one name.
void requirePlaceForNumbers(const CaptureOptions& options, int frames);

/// Before any work: can the outputs be written, and would they overwrite something that is read? Throws Error.
void checkOutputs(const CaptureOptions& options);

/// Checks the further pictures of a sequence. How many there are follows from the path, which may depend on the scene.
void checkFurtherOutputs(const CaptureOptions& options, int frames);

} // namespace shadowlab::cli
