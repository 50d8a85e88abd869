// The pictures of a slide, drawn in the sizes that its layout gives them.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/course/slides/slide_layout.h"
#include "app/course/slides/slide_parts.h"
#include "app/course/state_picture.h"
#include "app/figures/pixel_diagram.h"

namespace shadowlab::course {

/// A part as it was drawn: a drawing, or a picture in one panel, or in a band for each technique.
struct DrawnPart {
    std::optional<figures::Diagram> diagram;
    double diagramBorder = 0; ///< pixels of its sheet that stay empty on all sides
    StatePicture::Parts parts;
};

struct PicturesRequest {
    double slideWidth = 1920; ///< in units of the layout
    double scale = 1;         ///< pixels for a unit
    int supersample = 2;
};

struct DrawnPictures {
    SlideLayout layout;
    std::vector<SlidePart> parts;
    std::vector<DrawnPart> drawn; ///< of each part
};

/// Lays the slide out and draws its pictures. They are drawn small first: of a picture with colours that mean something, its own shape and
/// its legend are known only then. Colours with the same unit have the same scale in all pictures, and neighbouring sections as well.
/// Throws Error (badInput, usage) for what cannot be drawn. Needs a current GL context.
DrawnPictures drawPictures(const Slide& slide, const Fonts& fonts, const PicturesRequest& request);

} // namespace shadowlab::course
