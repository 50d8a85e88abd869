// The scene as a second camera sees it from outside: the eye with its view, the lights, and what a technique has in the
// scene for one of them, such as the frusta of a shadow map or the faces of shadow volumes.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/picture/outside/label_painter.h"
#include "app/picture/outside/outside_choice.h"
#include "app/picture/session.h"

namespace shadowlab::picture {

/// Type of the labels, as a share of OutsideLook::typeHeight.
inline constexpr double kOutsideTypeShare = 1.0 / 38;

/// How such a picture is drawn, apart from what it is of.
struct OutsideLook {
    OutsideChoice choice{};
    int typeHeight = 0; ///< that the labels' type is a share of: the height of the figure that the picture is a part of; 0: its own.
                        ///< A window has type of a size of its own
    int draft = 1;      ///< the picture is shown that many times as large
};

/// Draws such pictures, and keeps between them what it takes long to make. Needs a current GL context for its whole life.
class OutsideView {
public:
    /// The finished picture of the slot's technique from `outside.camera` in `outside.size` (and region), a little darker,
    /// and over it the shapes. `eye` is the view that is looked at; its size gives the shape of its frustum, and
    /// of its picked pixel, if it has one, the rays are shown. `light` is an
    /// index, or kNoLight for a scene without lights. Returns a picture of linear display colours, to be shown as
    /// StageKind::swatches, in which the things are labelled; its key is of those that found no room for a label. Or nothing,
    /// when the technique was not ready by the deadline. The slot's own picture stays as it is.
    std::optional<Stage> render(Session& session, Slot& slot, const View& eye, const View& outside, int light,
                                const OutsideLook& look = {}, Deadline deadline = Deadline::max());

    /// Is all of the last picture drawn? Else its technique has more to do, and the next call goes on.
    [[nodiscard]] bool isWhole() const { return isWhole_; }
    /// 0..1 of what the technique draws of it.
    [[nodiscard]] double drawnShare() const { return drawnShare_; }
    /// The labels of the last picture.
    [[nodiscard]] const std::vector<PlacedLabel>& labels() const { return labels_; }
    /// The technique's shapes in it.
    [[nodiscard]] const std::vector<SceneShape>& shownShapes() const { return ofTechnique_; }

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
        OutsideChoice choice;
        friend bool operator==(const ShapesOf&, const ShapesOf&) = default;
    };
    bool updateShapes(Session& session, Slot& slot, const View& eye, int light, const OutsideChoice& choice,
                      Deadline deadline);
    std::vector<KeyEntry> label(const View& eye, const View& outside, std::span<const SceneShape> lights,
                                std::span<const SceneShape> ofPixel, const OutsideLook& look);
    void drawGround(const gl::Texture2D& radiance, float exposure) const;
    void drawDepth(const Session& session, const View& outside) const;

    gl::Target target_; ///< of the technique
    bool isWhole_ = true;
    double drawnShare_ = 1;
    ShapesOf madeFor_;
    scene::Bounds things_;
    std::vector<SceneShape> ofTechnique_, ofEye_;
    Probe probe_; ///< of the picked pixel, if there is one
    std::vector<PlacedLabel> labels_;
    LabelPainter labelPainter_;
    ShapePainter painter_;
    gl::Program ground_{"fullscreen.vert", "picture/outside_ground.frag"};
    gl::Program depthOnly_{"position.vert", "nothing.frag"};
};

} // namespace shadowlab::picture
