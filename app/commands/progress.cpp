// SPDX-License-Identifier: MIT
#include "app/commands/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace shadowlab::commands {

Progress::Progress(std::string what, int total)
    : what_(std::move(what)), total_(total), shown_(total > 1 && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr); // back to the start of the line, and erase it
}

void Progress::done(int count) {
    if (!shown_) return;
    std::fprintf(stderr, "\r%s %d of %d", what_.c_str(), count, total_);
    std::fflush(stderr);
}

} // namespace shadowlab::commands
