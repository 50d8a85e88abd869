// SPDX-License-Identifier: MIT
#include "app/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace shadowlab::cli {

Progress::Progress(std::string what, int total, Remaining remaining)
    : what_(std::move(what)), total_(total), remaining_(remaining), shown_(total > 1 && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr); // back to the start of the line, and erase it
}

void Progress::done(int count) {
    if (!shown_) return;
    if (already_ < 0) already_ = std::max(count - 1, 0);
    std::fprintf(stderr, "\r%s %d of %d%s\033[K", what_.c_str(), count, total_, remainingText(count).c_str());
    std::fflush(stderr);
}

std::string Progress::remainingText(int count) const {
    constexpr double kSettled = 3; // seconds, before which an estimate jumps about
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (remaining_ == Remaining::untold || seconds < kSettled || count <= already_ || count >= total_) return "";
    const double left = seconds / (count - already_) * (total_ - count);
    constexpr double kMinute = 60;
    if (left < kMinute) return ", about " + std::to_string(static_cast<int>(left) + 1) + " s left";
    return ", about " + std::to_string(static_cast<int>(left / kMinute) + 1) + " min left";
}

} // namespace shadowlab::cli
