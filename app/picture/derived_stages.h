// Stages that no technique draws: the session derives them from a technique's `visibility` and the truth, from the
// scene alone, or from what a technique has in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/picture/figure.h"
#include "app/picture/outside/outside_choice.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/picture/wrong_marks.h"

namespace shadowlab::picture {

/// The stages of a technique's own, then those the session derives for it. Their ids are reserved.
std::vector<StageInfo> stagesOf(const TechniqueInfo& info);

/// Is it one that the session makes?
bool isDerived(std::string_view stage);

/// The words under a stage of the technique or one derived from it; empty for what is none of them.
std::string captionOf(const TechniqueInfo& info, std::string_view stage);

/// Is it about View::picked, where there is one?
bool followsPicked(const TechniqueInfo& info, std::string_view stage);

/// What a technique has to publish so that the stage can be shown.
std::vector<StageKey> neededFor(const StageKey& stage);

/// What else a derived stage is made of. The view is the one the slot was rendered with: never supersampled.
struct DerivedRequest {
    StageKey stage;
    View view;
    std::optional<int> row;                 ///< of `scanline`; none: the one with most wrong pixels
    const image::Font* font = nullptr;      ///< for the numbers of `scanline`
    std::optional<scene::Camera> outside{}; ///< of `outside`; none: scene::outsideCameraFor
    ivec2 outsideSize{0};                   ///< of its picture; zero: that of the view
    int markWidth = kOnePixel;              ///< of wrong pixels that stand alone, in `error`
    OutsideChoice outsideChoice{};
    int typeHeight = 0; ///< of the figure that the picture is a part of; 0: its own height
};
Panel derivedPanel(Session& session, Slot& slot, const RenderedFrame& rendered, const PictureEncoder& encoder,
                   const DerivedRequest& request);

} // namespace shadowlab::picture
