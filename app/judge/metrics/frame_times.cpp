// SPDX-License-Identifier: MIT
#include "app/judge/metrics/frame_times.h"

#include <algorithm>

namespace shadowlab::judge {

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double elapsedMs(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since).count();
}

void FrameTimes::addFrame(double frameMs, double prepareMs) {
    frameMs_.push_back(frameMs);
    prepareMs_.push_back(prepareMs);
}

void FrameTimes::addPasses(const std::vector<gl::PassTimer::Result>& passMs) {
    for (const gl::PassTimer::Result& pass : passMs) {
        const auto known = std::ranges::find(passMs_, pass.name, [](const auto& entry) { return entry.first; });
        if (known != passMs_.end())
            known->second.push_back(pass.elapsedMs);
        else
            passMs_.push_back({pass.name, {pass.elapsedMs}});
    }
}

std::vector<gl::PassTimer::Result> FrameTimes::passMs() const {
    std::vector<gl::PassTimer::Result> medians;
    for (const auto& [name, times] : passMs_)
        medians.push_back({name, median(times)});
    return medians;
}

} // namespace shadowlab::judge
