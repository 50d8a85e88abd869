// The scene as a second camera sees it from outside: the eye with its view, the lights, and what a technique has in the
// scene for one of them, such as the frusta of a shadow map or the faces of shadow volumes.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/picture/outside/shape_painter.h"
#include "app/picture/session.h"

namespace shadowlab::picture {

/// Draws such pictures, and keeps between them what it takes long to make. Needs a current GL context for its whole life.
class OutsideView {
public:
    /// The finished picture of the slot's technique from `outside.camera` in `outside.size` (and region), a little darker,
    /// and over it the shapes. `eye` is the view that is looked at; its size gives the shape of its frustum, and
    /// of its picked pixel, if it has one, the rays are shown. `light` is an
    /// index, or kNoLight for a scene without lights. Returns a picture of linear display colours, to be shown as
    /// StageKind::swatches, with the key of the colours; or nothing, when the technique was not ready by the deadline. The
    /// slot's own picture stays as it is.
    std::optional<Stage> render(Session& session, Slot& slot, const View& eye, const View& outside, int light,
                                Deadline deadline = Deadline::max());

private:
    /// All that shapes depend on.
    struct ShapesOf {
        const TechniqueInfo* info = nullptr;
        const Technique* technique = nullptr;
        std::vector<double> values; ///< of its parameters
        scene::Snapshot snapshot;
        scene::Camera eye;
        ivec2 eyeSize{0};
        std::optional<ivec2> picked, partner;
        int light = kNoLight;
        friend bool operator==(const ShapesOf&, const ShapesOf&) = default;
    };
    void updateShapes(const Session& session, Slot& slot, const View& eye, int light);
    void drawGround(const gl::Texture2D& radiance, float exposure) const;
    void drawDepth(const Session& session, const View& outside) const;

    gl::Target target_; ///< of the technique
    ShapesOf madeFor_;
    scene::Bounds things_;
    std::vector<SceneShape> shapes_; ///< the eye's and the technique's
    Probe probe_;                    ///< of the picked pixel, if there is one
    ShapePainter painter_;
    gl::Program ground_{"fullscreen.vert", "picture/outside_ground.frag"};
    gl::Program depthOnly_{"position.vert", "nothing.frag"};
};

} // namespace shadowlab::picture
