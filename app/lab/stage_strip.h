// All stages of a technique as small pictures, to choose from.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

#include "app/lab/pane.h"

namespace shadowlab::lab {

/// One small picture.
struct Thumbnail {
    picture::StageRef stage; ///< of the light that all stages are about
    std::string caption;     ///< what is seen there
    PanePicture picture;     ///< without a texture where the stage could not be drawn
};

class StageStrip {
public:
    /// Draws the stages of what the pane shows again if anything but its stage has changed: all of them from one frame of
    /// that size. True if something was drawn, or is not finished. Work beyond the deadline waits for the next call; until the
    /// technique is ready there are no thumbnails. What throws is not tried again before something changes.
    bool update(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& pane, ivec2 size,
                Deadline deadline);
    [[nodiscard]] const std::vector<Thumbnail>& thumbnails() const { return thumbnails_; }

private:
    bool draw(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
              Deadline deadline);
    Pane pane_; ///< its slots are of their own: small targets, not those of the window
    PaneRequest drawnFor_;
    bool isFinished_ = true; ///< of what was asked for last
    std::vector<Thumbnail> thumbnails_;
};

} // namespace shadowlab::lab
