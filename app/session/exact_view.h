// The truth of what a view shows: made when it is first asked for, kept as long as nothing changes.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/measure/truth.h"
#include "techniques/foundation/gl/id_buffer.h"
#include "techniques/technique.h"

namespace shadowlab::session {

class ExactView {
public:
    /// For each pixel of the whole view: the visibility of the light by definition, and the ties. Needs a current GL
    /// context, for the picture of triangle numbers that is drawn with the techniques' own draw calls.
    const measure::Truth& truth(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers, const View& view,
                                int light);
    /// Without ties, which are by far the most of the work.
    measure::Truth truthAtCentres(const scene::Snapshot& snapshot, const View& view, int light);
    /// Which of a few pixels are ties, as far as rays tell.
    std::vector<std::uint8_t> tiesAmong(const scene::Snapshot& snapshot, const View& view, int light,
                                        const std::vector<ivec2>& pixels);
    /// What the rasteriser has to say about the view. Needs a current GL context; everything else about a truth does not.
    measure::Rasterised rasterise(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers, const View& view);

private:
    struct Key {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0};
        int light = kNoLight;
        friend bool operator==(const Key&, const Key&) = default;
    };

    trace::SceneTracer tracer_;
    gl::IdBuffer ids_;
    Key madeFor_;
    measure::Truth truth_;
};

} // namespace shadowlab::session
