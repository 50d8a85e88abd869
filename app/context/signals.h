// Interruption and other signals. Ctrl-C sets a flag that long work asks for between frames and tiles, so that objects
// are destroyed in order and no half-written file stays. The second Ctrl-C ends the program at once, and so does the first
// where nobody has asked for two seconds: also then no half-written file stays.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// Thrown to unwind to main after SIGINT, SIGTERM, SIGHUP or SIGXCPU. Not a std::exception: nobody may take it for a failure.
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
