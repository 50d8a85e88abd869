// All stages of a technique as small pictures, to choose from.
//
// They are drawn on the thread that draws the window, so their work is cut into slices: the finished picture first, then as many
// stages at a time as fit into the time that is given. A technique that gets better sample by sample shows what it has, and how
// far it has come. What the session derives from the exact answer comes last, one picture at a time.
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
    PanePicture picture;     ///< without a texture before it is drawn
    bool isToCome = false;   ///< it will be drawn, or drawn better; a picture that is there is of a moment ago, or of fewer samples
};

class StageStrip {
public:
    /// Draws the stages of what the pane shows again if anything but its stage has changed. True if something was drawn, or is
    /// not finished. Work beyond the deadline waits for the next call, which goes on there. The thumbnails are all there from the
    /// first call on, and get their pictures one after another. What throws is not tried again before something changes.
    bool update(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& pane, ivec2 size,
                Deadline deadline);
    [[nodiscard]] const std::vector<Thumbnail>& thumbnails() const { return thumbnails_; }
    /// 0..1 of what the technique prepares and draws for pictures that are to come.
    [[nodiscard]] double progress() const { return progress_; }

private:
    void begin(const picture::Slot& slot, const PaneRequest& request);
    bool draw(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
              Deadline deadline);
    bool drawDerived(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
                     Deadline deadline);

    Pane pane_; ///< its slots are of their own: small targets, not those of the window
    PaneRequest drawnFor_;
    bool isFinished_ = true; ///< of what was asked for last
    std::vector<Thumbnail> thumbnails_;
    double progress_ = 1;
    std::size_t own_ = 0;      ///< the first thumbnails: the finished picture and the technique's own stages
    std::size_t next_ = 0;     ///< the first thumbnail that is not finished
    std::size_t atOnce_ = 1;   ///< thumbnails of the next frame
    bool takesLong_ = false;   ///< one frame has not been enough: the technique goes on with a picture of which all stages are made
};

} // namespace shadowlab::lab
