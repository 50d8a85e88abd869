// Writes labels into a picture on the graphics card: a dark plate with the text, a bar in the colour of the thing, and a line
// of that colour to it.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/picture/outside/label_layout.h"
#include "app/picture/outside/shape_painter.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::picture {

class LabelPainter {
public:
    /// Loads DejaVu Sans, as all pictures of the program have it. Throws Error (badInput) when it is missing.
    LabelPainter();
    /// Width and height of a label, pixels. `em`: size of the type.
    [[nodiscard]] dvec2 sizeOf(const std::string& text, double em) const;
    /// Into the bound framebuffer of that size, of linear display colours. Changes blending, depth test and viewport, and puts
    /// the viewport back.
    void draw(const std::vector<PlacedLabel>& labels, double em, const ShapePainter& lines, ivec2 size) const;

private:
    [[nodiscard]] image::Image plateOf(const PlacedLabel& label, double em) const;
    image::Font font_;
    gl::Program plate_{"fullscreen.vert", "picture/label.frag"};
};

} // namespace shadowlab::picture
