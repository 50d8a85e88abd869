// What a capture writes beside its picture: settings into the PNG, times and counters into a JSON file.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/cli/capture/capture.h"
#include "app/cli/json/json_values.h"
#include "app/judge/metrics/frame_times.h"
#include "app/picture/session.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::cli {

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
        Json parameters;
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
