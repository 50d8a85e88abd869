// The alias-free shadow map as a pass: every visible point is tested in the light's picture, and no map is drawn.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>

#include "techniques/frame.h"
#include "techniques/shadow_map/irregular/alias_free.h"

namespace shadowlab::shadow_map {

class AliasFreePass {
public:
    /// Makes ready for a scene. False when the time came before it was done.
    bool prepare(const scene::Snapshot& snapshot, Deadline deadline) { return tracer_.advance(snapshot, deadline); }
    /// Of the scene that it was prepared for.
    [[nodiscard]] const trace::SceneTracer& tracer() const { return tracer_; }
    /// What was found belongs to the frame before.
    void beginFrame();

    /// Decides every pixel of the part that is drawn: a texture of visibility, kept until the next frame.
    const gl::Texture2D& decide(Frame& frame, int light);
    /// Where in the light's picture the points lie that the eye asks for, as a stage.
    void publishSamples(Frame& frame, int light);

private:
    const std::vector<trace::SurfacePoint>& visiblePoints(Frame& frame);

    trace::SceneTracer tracer_;
    std::vector<trace::SurfacePoint> points_; ///< one per pixel of the drawn region, rows from the top
    std::map<int, gl::Texture2D> decided_;
};

} // namespace shadowlab::shadow_map
