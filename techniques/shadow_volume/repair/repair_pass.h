// The repair pass: reads the stencil back, decides doubtful pixels with rays, and writes their bits.
//
// In the pixels that are written the count itself is lost; only zero or not zero is left, which is all that the light pass
// tests. The stencil is read back to the processor, so the graphics card is idle meanwhile.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <set>

#include "techniques/frame.h"
#include "techniques/shadow_volume/count/face_counter.h"
#include "techniques/shadow_volume/repair/repair.h"

namespace shadowlab::shadow_volume {

// The repair pass as each of the techniques describes it.
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
    /// Shadow volumes ignore holes in casters, so the rays have to ignore them, too. Otherwise every pixel lit through a
    /// hole would count as wrong, and repair would spread through all of them.
    RepairPass() { tracer_.castWhole(); }

    /// Prepares the ray tracer. False if the deadline came before the end.
    bool prepare(const scene::Snapshot& snapshot, Deadline deadline) { return tracer_.advance(snapshot, deadline); }

    /// The decisions of the last frame are kept if this frame has the same counts (`sameAsBefore`).
    void beginFrame(bool sameAsBefore) {
        if (!sameAsBefore) decided_.clear();
        told_.clear();
    }

    /// Corrects the count that the target's stencil holds for a light. `volumes` are those that were counted, in `counted`: outside
    /// of it all counts are zero (none: nothing is known of that, and all of the stencil is read). A second call in a frame only writes what the first one found, because the same volumes give the same count.
    void apply(Frame& frame, int light, std::span<const CountedVolume> volumes, const std::optional<scene::PicturePart>& counted,
               const StencilRule& stencil);

    /// Publishes the decisions as a stage; the stencil stays as it is.
    void publish(Frame& frame, int light, std::span<const CountedVolume> volumes, const std::optional<scene::PicturePart>& counted,
                 const StencilRule& stencil);

private:
    const Repair& decided(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                          const std::optional<scene::PicturePart>& counted, const StencilRule& stencil);
    void readCount(const Frame& frame, const std::optional<scene::PicturePart>& counted, const StencilRule& stencil);
    void writeBits(const Frame& frame, const Repair& repair, const StencilRule& stencil) const;

    trace::SceneTracer tracer_;
    trace::PixelRays rays_;
    CountedPart part_;              ///< what was read last; its memory, and that of the marks, is used again
    PixelMask marked_;
    std::map<int, Repair> decided_; ///< per light
    std::set<int> told_;            ///< lights whose counters this frame has
    gl::Program flip_{"shadow_volume/pixel.vert", "shadow_volume/pixel.frag"};
};

} // namespace shadowlab::shadow_volume
