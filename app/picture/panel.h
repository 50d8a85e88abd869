// One picture of a figure, from a slot to finished pixels: which frame is requested of the slot, and how the result is displayed.
//
// Captures, lessons and slides use all of it. The window requests the same frame and displays it in the same way (lab/pane.cpp), but
// leaves its picture on the graphics card, stops at a deadline and continues in the next frame.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "app/picture/figure.h"
#include "app/picture/outside/outside_choice.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/picture/stage_ref.h"
#include "app/picture/wrong_marks.h"

namespace shadowlab::picture {

/// What a slot's frame has to do so that the stage can be shown: publish it, or stop after the pass.
FrameRequest frameFor(const ResolvedStage& stage);

/// How a picture of the stage is read: what its values are, its legend, and the words under it.
struct StageLook {
    StageKind kind = StageKind::radiance;
    Display display{};     ///< of a derived stage empty: its panel has its own
    std::string caption{}; ///< empty: the finished picture, or a pass
};
/// Throws std::logic_error when the frame has not published the stage.
StageLook lookOf(const ResolvedStage& stage, const TechniqueInfo& info, const RenderedFrame& rendered);

/// What one cell of a figure shows, and how finely.
struct PanelRequest {
    ResolvedStage stage{};
    scene::Camera camera{};
    int supersample = 1;                      ///< N x N samples a pixel; 1 for derived stages, which are about single pixels
    std::optional<ivec2> picked{}, partner{}; ///< samples of the picture; only stages about one pixel take notice
    std::optional<int> row{};                 ///< of the stage `scanline`; none: the one with most wrong pixels
    std::optional<scene::Camera> outside{};   ///< of the stage `outside`; none: as the program chooses it
    OutsideChoice outsideChoice{};            ///< likewise
    int typeHeight = 0;                       ///< of the figure that the picture is a part of; 0: its own height
    const image::Font* font = nullptr;        ///< for the numbers of the stage `scanline`
    int markWidth = kOnePixel;                ///< of wrong pixels that stand alone, in the stage `error`
    std::optional<dvec2> range{};             ///< least and greatest value of a stage's colours; none: as the technique chose them
    bool timePasses = false;
    bool liftsSteps = false; ///< a step before any light is on is shown brighter, as step mode does, and the panel's note says so
};

/// The view that the cell's picture is drawn with.
View viewOf(const Cell& cell, const TechniqueInfo& info, const PanelRequest& request);

struct RenderedPanel {
    Panel panel; ///< without title
    RenderedFrame rendered;
};
/// Renders the slot and makes the picture of it. What the second camera sees is a picture of its own and no band of a larger
/// one: then the cell is changed to hold it whole. Throws Error (usage) for a pass that does not run with the slot's settings.
RenderedPanel renderPanel(Session& session, Slot& slot, const PictureEncoder& encoder, Cell& cell, const PanelRequest& request);

} // namespace shadowlab::picture
