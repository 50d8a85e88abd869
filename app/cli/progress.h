// Shows on a terminal how far a long command is; prints nothing when standard error is no terminal.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <string>

namespace shadowlab::cli {

class Progress {
public:
    /// `told` for steps that take about the same time: "step 12 of 80, about 3 min left".
    enum class Remaining { untold, told };
    /// "frame 3 of 60". Prints nothing when there is only one.
    Progress(std::string what, int total, Remaining remaining = Remaining::untold);
    /// Wipes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void done(int count);

private:
    [[nodiscard]] std::string remainingText(int count) const;

    std::string what_;
    int total_;
    Remaining remaining_;
    bool shown_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    int already_ = -1; ///< steps that were done before this run began
};

} // namespace shadowlab::cli
