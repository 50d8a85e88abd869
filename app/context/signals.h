// Interruption and other signals. Ctrl-C sets a flag that long work tests between frames and tiles, so that objects are
// destroyed in order. The second Ctrl-C ends the program at once, and so does the first when the flag was not tested for two
// seconds. In every case half-written files are removed.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// Thrown to unwind to main after SIGINT, SIGTERM, SIGHUP or SIGXCPU. Not a std::exception, so that no handler treats it as a failure.
struct Interrupted {
    int exitStatus; ///< 128 + signal number, as shells count: 130 for SIGINT, 143 for SIGTERM, 129 for SIGHUP, 152 for SIGXCPU
};

/// Called once, first thing in main. What was ignored before (SIGHUP by nohup) stays so. SIGPIPE and SIGXFSZ are ignored from then
/// on, so that a closed pipe or a file size limit is a failed write with a reason instead of a silent death.
void installSignalHandlers();

/// Whether one of the four has come. Cheap enough for inner loops, from any thread.
[[nodiscard]] bool interrupted();
void throwIfInterrupted();

} // namespace shadowlab::context
