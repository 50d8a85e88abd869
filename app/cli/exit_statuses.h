// What the program's exit statuses mean. The help, the man page (app/install/shadowlab.1) and docs/errors.md say it in these words.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

namespace shadowlab::cli {

struct ExitMeaning {
    const char* status; ///< "130", or several: "129, 130"
    const char* meaning;
};

inline constexpr std::array kExitMeanings{
    ExitMeaning{"0", "done"},
    ExitMeaning{"1", "judged, and found wanting (grade, judge, report --hard)"},
    ExitMeaning{"2", "the command line is wrong"},
    ExitMeaning{"3", "an input is missing or wrong, or a lesson does not hold (lesson --measure)"},
    ExitMeaning{"4", "an output cannot be written"},
    ExitMeaning{"5", "there is no OpenGL 3.3, or with --software none on the processor"},
    ExitMeaning{"6", "something is over a limit"},
    ExitMeaning{"70", "a fault of the program, or of a plug-in"},
    ExitMeaning{"129, 130, 143, 152", "ended by SIGHUP, SIGINT (Ctrl-C), SIGTERM or SIGXCPU"},
};

} // namespace shadowlab::cli
