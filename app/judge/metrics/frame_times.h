// Times of one technique over several frames. The median is reported: a frame that the system interrupted does not affect it.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "techniques/foundation/gl/pass_timer.h"

namespace shadowlab::judge {

/// The middle of the values, or the mean of the two in the middle; 0 of none.
double median(std::vector<double> values);

/// Wall time that has passed since.
double elapsedMs(std::chrono::steady_clock::time_point since);

class FrameTimes {
public:
    void addFrame(double frameMs, double prepareMs);
    void addPasses(const std::vector<gl::PassTimer::Result>& passMs);

    [[nodiscard]] std::size_t frames() const { return frameMs_.size(); }
    [[nodiscard]] double frameMs() const { return median(frameMs_); }
    [[nodiscard]] double prepareMs() const { return median(prepareMs_); }
    /// Medians, in the order in which the passes first ran.
    [[nodiscard]] std::vector<gl::PassTimer::Result> passMs() const;

private:
    std::vector<double> frameMs_, prepareMs_;
    std::vector<std::pair<std::string, std::vector<double>>> passMs_;
};

} // namespace shadowlab::judge
