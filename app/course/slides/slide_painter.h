// Draws a slide: its pictures with their techniques, and everything around them.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/course/slides/slide_pictures.h"
#include "app/drawing/paint.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::course {

struct SlideLook {
    ivec2 size{1920, 1080};
    int supersample = 2; ///< N x N samples for a pixel of a picture
};

/// What stands at a slide's foot.
struct SlideFoot {
    std::string deck;
    std::size_t number = 1, of = 1;
};

struct DrawnSlide {
    image::Image slide;
    image::Image pictures; ///< its pictures with their callouts, without any other words; empty where it has none
    Box picturesAt;        ///< where they are on the slide, in shares of it
    image::Image content;  ///< its pictures with the words beside them
};

class SlidePainter {
public:
    /// `fonts`: the folder of the project's own. Throws Error (badInput) when one is missing.
    SlidePainter(const std::filesystem::path& fonts, const SlideLook& look);

    /// Throws Error (badInput, usage) for what cannot be drawn as it is asked for. Needs a current GL context.
    [[nodiscard]] DrawnSlide draw(const Slide& slide, const SlideFoot& foot) const;

private:
    void drawPart(image::Image& slide, const DrawnPictures& pictures, std::size_t part) const;
    [[nodiscard]] ivec2 pixels(dvec2 place) const;
    [[nodiscard]] image::Image cut(const image::Image& slide, const Box& box) const;

    SlideLook look_;
    image::Font upright_, bold_;
    drawing::Painter painter_;
    double scale_; ///< pixels for a unit of the layout
};

} // namespace shadowlab::course
