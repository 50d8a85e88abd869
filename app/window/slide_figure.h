// What a slide shows that is no live picture: the drawing of its pixel, made from what the window knows of that pixel, or a slide of
// words and formulas alone.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/window/window_state.h"

namespace shadowlab::window {

enum class SlideFigureKind {
    none,
    ofPixel,    ///< beside the live picture, in which the pixel is marked
    wholeSlide, ///< the slide has no picture: its words stand in the picture's place
};

/// What the slide on show needs; none while no slide is told of.
SlideFigureKind slideFigureKind(const WindowState& ui);

class SlideFigure {
public:
    /// Draws it for that room in pixels, if it is another than before. `em` is the window's type size: the least type of the
    /// drawing is hardly smaller. True if there is something new to be seen.
    bool update(const WindowState& ui, ivec2 room, float em, const image::Font& font);

    /// On the graphics card, row 0 at the bottom; empty: nothing is drawn yet, or it cannot be.
    [[nodiscard]] const gl::Texture2D& texture() const { return texture_; }
    /// Why it cannot be drawn; else empty.
    [[nodiscard]] const std::string& fault() const { return fault_; }

private:
    /// What the texture is a picture of.
    struct Subject {
        std::string slide; ///< its deck, name and picture
        ivec2 room{0};
        float em = 0;
        std::optional<lab::PaneRequest> pane; ///< of a drawing of a pixel
        std::optional<ivec2> pixel, partner;
        friend bool operator==(const Subject&, const Subject&) = default;
    };

    Subject drawn_;
    gl::Texture2D texture_;
    std::string fault_;
};

} // namespace shadowlab::window
