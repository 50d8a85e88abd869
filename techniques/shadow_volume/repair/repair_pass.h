// The pass that mends a count: reads the stencil back, has doubtful pixels decided with rays, and writes their bits.
//
// The count itself is lost in the pixels that are written: only zero or not zero is left, which is all that the light pass
// asks for. The stencil comes to the processor and the answer goes back, so the graphics card waits in between.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <set>

#include "techniques/frame.h"
#include "techniques/shadow_volume/count/face_counter.h"
#include "techniques/shadow_volume/repair/repair.h"

namespace shadowlab::shadow_volume {

// Of each technique that can be mended.
inline constexpr PassInfo kRepairPass = {
    .id = "repair",
    .title = "Decide again, with rays, where the count may be wrong",
    .why = "Between faces that share an edge the rasteriser leaves a crack now and then: one pixel is counted wrong. "
           "Pixels that differ from a neighbour, or that a silhouette edge touches, are asked again with a ray from "
           "the eye and one to the light. Only with repair = true.",
    .glState =
        "stencil read back; stencil ZERO where it is not, INCR where it is zero, in the pixels to be changed alone",
    .perLight = true,
    .shownBy = "repair",
    .anchors = "decide-with-rays"};
inline constexpr StageInfo kRepairStage = {"repair", "What rays decided again, and where they changed the picture",
                                           StageKind::swatches, true};

class RepairPass {
public:
    /// The count knows nothing of holes in casters, and what mends it must not either: it would go on and on, pixel by pixel,
    /// through all that shines through them.
    RepairPass() { tracer_.castWhole(); }

    /// Makes ready for asking with rays. False when the time came before it was done.
    bool prepare(const scene::Snapshot& snapshot, Deadline deadline) { return tracer_.advance(snapshot, deadline); }

    /// What was decided for the frame before is kept where that has counted the very same.
    void beginFrame(bool sameAsBefore) {
        if (!sameAsBefore) decided_.clear();
        told_.clear();
    }

    /// Mends the count that the target's stencil holds for a light. `volumes` are those that were counted. A second time only
    /// writes what the first one found: the same volumes give the same count.
    void apply(Frame& frame, int light, std::span<const CountedVolume> volumes, const StencilRule& stencil);

    /// The same count, and what mending it does, as a stage; the stencil stays as it is.
    void publish(Frame& frame, int light, std::span<const CountedVolume> volumes, const StencilRule& stencil);

private:
    const Repair& decided(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                          const StencilRule& stencil);
    void writeBits(const Frame& frame, const Repair& repair, const StencilRule& stencil) const;

    trace::SceneTracer tracer_;
    std::map<int, Repair> decided_; ///< per light
    std::set<int> told_;            ///< lights whose counters this frame has
    gl::Program flip_{"fullscreen.vert", "shadow_volume/marked.frag"};
};

} // namespace shadowlab::shadow_volume
