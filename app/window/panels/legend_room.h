// How many lines the legends on show need. Their band is taken from the pictures before these are laid out, so it is known a frame
// earlier: from the legends of the last frame.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/lab/errors/live_errors.h"
#include "app/window/pane_frames.h"

namespace shadowlab::window {

class LegendRoom {
public:
    /// After the pictures are drawn. True if the next frame has other bands than this one. While the same is on show the bands
    /// only grow: counts in a legend change with the picture's size, and must not change it back and forth.
    bool follow(const WindowState& ui, const lab::LiveErrors& errors, const Area& whole, const Theme& theme);
    [[nodiscard]] const LegendLines& lines() const { return lines_; }

private:
    /// What a legend depends on, but for counts.
    struct OnShow {
        picture::Layout layout = picture::Layout::single;
        std::vector<std::pair<std::string, picture::StageRef>> panes; ///< technique and stage
        ivec2 size{0};
        float em = 0;
        friend bool operator==(const OnShow&, const OnShow&) = default;
    };
    OnShow onShow_;
    bool isNew_ = true; ///< nothing of what is on show has been measured yet
    LegendLines lines_{0, 0};
};

} // namespace shadowlab::window
