// What a capture writes beside its picture: settings into the PNG, times and counters into a JSON file.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/cli/capture_options.h"
#include "app/judge/metrics/frame_times.h"
#include "app/picture/session.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/params/param_json.h"

namespace shadowlab::cli {

/// {"frame", "prepare", "passes": {...}}, in milliseconds.
nlohmann::ordered_json timesJson(const judge::FrameTimes& times);
/// {"casters": {"built", "of", "unit"}, ...}
nlohmann::ordered_json countersJson(const std::vector<Counter>& counters);

class CaptureStats {
public:
    CaptureStats(const scene::Scene& scene, const CaptureOptions& options, const context::Context& context,
                 const std::vector<picture::Slot>& slots);

    /// One frame of one slot.
    void add(std::size_t slot, const picture::RenderedFrame& rendered);

    /// Text chunks: scene, techniques and every parameter. Nothing that differs from run to run or between backends.
    [[nodiscard]] const std::vector<image::PngText>& pngText() const { return pngText_; }

    /// One JSON object; times are medians over the frames, in milliseconds.
    [[nodiscard]] std::string json() const;

private:
    struct SlotStats {
        std::string technique;
        nlohmann::ordered_json parameters;
        judge::FrameTimes times;
        std::vector<Counter> counters; ///< of the last frame
        std::vector<Note> notes;       ///< of the last frame
    };
    std::string scene_, renderer_, version_, backend_;
    ivec2 size_;
    std::vector<SlotStats> slots_;
    std::vector<image::PngText> pngText_;
};

} // namespace shadowlab::cli
