// The last so many frames, for a plot over time: how long each took, and how wrong it was.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace shadowlab::lab {

/// One slot at one time. Errors stand for the picture that was judged last, and are missing until one was.
struct SlotSample {
    double frameMs = 0;
    std::optional<double> edgeErrorPx{};
    std::optional<int> wrongPixels{};
};

struct Sample {
    double seconds = 0; ///< on any clock that does not go back
    std::vector<SlotSample> slots;
};

/// The oldest sample goes when a new one has no room.
class History {
public:
    explicit History(std::size_t capacity) : capacity_(capacity) {}
    void add(Sample sample) {
        samples_.push_back(std::move(sample));
        if (samples_.size() > capacity_) samples_.pop_front();
    }
    void clear() { samples_.clear(); }
    /// Oldest first.
    [[nodiscard]] const std::deque<Sample>& samples() const { return samples_; }

private:
    std::size_t capacity_;
    std::deque<Sample> samples_;
};

} // namespace shadowlab::lab
