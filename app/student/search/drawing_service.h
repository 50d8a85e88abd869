// The process in which a plug-in draws the scenes of a search, one after another: starting it anew for each would take longer than the
// drawing.
//
// Requests come as lines of JSON on standard input, and each has a line of JSON as its answer. What a plug-in itself prints does not get
// in between: from the first answer on, its standard output leads nowhere.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::student {

/// The word on the command line that begins it. No command for people, so the help does not list it.
inline constexpr const char* kServeDrawings = "serve-drawings";

/// `words`: the technique, and the backend of OpenGL. Ends when standard input does; the result is the exit status.
///
/// Answers: {"ready": [stages of the technique]} once; then for {"scene": FILE, "scale": N, "draw": [[STAGE, LIGHT], ...], "out": FOLDER} either
/// {"drawn": true}, and FOLDER/0, FOLDER/1 ... hold what was drawn, or {"failed": WHY}. `visibility` is written as bytes, grey and alpha
/// of each pixel; any other stage, and the finished picture (""), as PNG.
int serveDrawings(const std::vector<std::string>& words);

} // namespace shadowlab::student
