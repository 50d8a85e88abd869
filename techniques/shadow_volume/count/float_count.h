// A count in a texture of floats, for scenes in which more volumes may overlap than the stencil can count.
//
// Blending adds +1 and -1 exactly up to 2^24. The result, zero or not, is written to the stencil, so all later passes are
// the same as for a count in the stencil.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/count/face_counter.h"

namespace shadowlab::shadow_volume {

class FloatCount {
public:
    /// Sets the count of every pixel to `start`. The counts use the depth buffer of the target.
    void clear(const Frame& frame, int start);
    /// Counts faces within a pass of the frame, and leaves the count bound for drawing.
    void count(const Frame& frame, const FaceCounter& counter, int light, std::span<const CountedVolume> volumes,
               const CountRules& rules, bool allAdd = false) const;
    /// Writes 1 to the target's stencil where the count is not zero, 0 elsewhere.
    void writeStencil(const Frame& frame) const;
    /// The counts, rows from below.
    [[nodiscard]] std::vector<float> read() const;

private:
    gl::Texture2D counts_;
    gl::Framebuffer framebuffer_;
    gl::Program notZero_{"fullscreen.vert", "shadow_volume/not_zero.frag"};
};

} // namespace shadowlab::shadow_volume
