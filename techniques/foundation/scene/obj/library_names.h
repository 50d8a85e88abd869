// The files that one mtllib line names. The format puts blanks between them, but names have blanks too, and quotes and comments are written.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/scene/load/misnamed_files.h"

namespace shadowlab::scene {

/// In order: the whole line, where there is such a file; else the line without a comment, where there is such a file under any
/// spelling; else its words, of which quotes may hold several together. None where the line is a comment alone.
std::vector<std::string> libraryNames(const std::string& line, MisnamedFiles& files);

} // namespace shadowlab::scene
