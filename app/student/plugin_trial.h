// Loading a plug-in for the first time is running unknown code: its static constructors, and its list of techniques. So it is done
// in a process of its own, which may crash, throw, or never end.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace shadowlab::student {

/// Runs `work` in a child process, for at most ten seconds, with nothing to say to anybody. Returns nothing where it came to its
/// end; else what happened: the text of what it threw, or "it crashes (segmentation fault)", "it does not come to an end within
/// 10 s". To be called while there is one thread only.
std::optional<std::string> tryInChild(const std::function<void()>& work);

/// "segmentation fault" for SIGSEGV; for the less usual ones "signal 31".
std::string signalText(int signal);

} // namespace shadowlab::student
