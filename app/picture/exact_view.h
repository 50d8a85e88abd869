// The truth of what a view shows: made when it is first asked for, kept as long as nothing changes.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "app/judge/outline.h"
#include "app/judge/truth.h"
#include "techniques/foundation/gl/scene/id_buffer.h"
#include "techniques/technique.h"

namespace shadowlab::picture {

/// Which light, and what of it.
struct LightTruth {
    LightTruth(int light, judge::TruthOf of = judge::TruthOf::centre) : light(light), of(of) {}
    int light;
    judge::TruthOf of;
    friend bool operator==(const LightTruth&, const LightTruth&) = default;
};

class ExactView {
public:
    /// Makes ready to send rays. False when the time came before it was done: call again to go on.
    bool prepare(const scene::Snapshot& snapshot, Deadline deadline) { return tracer_.advance(snapshot, deadline); }
    /// What sends them, once prepare() has returned true.
    [[nodiscard]] const trace::SceneTracer& tracer() const { return tracer_; }
    /// Share of it that is done, 0..1.
    [[nodiscard]] double prepared() const { return tracer_.done(); }
    /// For each pixel of the whole view: the visibility of the light by definition, and the ties. Valid until the next call
    /// about the same thing, the centre or the area. Needs a current GL
    /// context, for the picture of triangle numbers that is drawn with the techniques' own draw calls.
    const judge::Truth& truth(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers, const View& view,
                                const LightTruth& light);
    /// Without ties, which are by far the most of the work.
    judge::Truth truthAtCentres(const scene::Snapshot& snapshot, const View& view, const LightTruth& light);
    /// Which of a few pixels are ties, found by rays alone.
    std::vector<std::uint8_t> tiesAmong(const scene::Snapshot& snapshot, const View& view, const LightTruth& light,
                                        const std::vector<ivec2>& pixels);
    /// Where the light's shadows end in the whole view. Valid until the next call.
    const std::vector<judge::OutlineSegment>& outline(const scene::Snapshot& snapshot, const View& view, int light);
    /// The rasterised picture of the view. Needs a current GL context; everything else about a truth does not.
    judge::Rasterised rasterise(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers, const View& view);

private:
    struct Key {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0};
        LightTruth light = kNoLight;
        friend bool operator==(const Key&, const Key&) = default;
    };

    trace::SceneTracer tracer_;
    gl::IdBuffer ids_;
    /// The last truth about the light's centre, and about its area.
    struct Made {
        Key key;
        judge::Truth truth;
    };
    std::array<Made, 2> made_;
    Key outlinedFor_;
    std::vector<judge::OutlineSegment> outline_;
};

} // namespace shadowlab::picture
