// How far a long command is, for whoever sits at a terminal; silent when standard error goes anywhere else.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <string>

namespace shadowlab::cli {

class Progress {
public:
    /// Of steps that take about the same time: "step 12 of 80, about 3 min left".
    enum class Remaining { untold, told };
    /// "frame 3 of 60". A single piece of work has no progress to tell.
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
    int already_ = -1; ///< steps that were done before the first that is told here
};

} // namespace shadowlab::cli
