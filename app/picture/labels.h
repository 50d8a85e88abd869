// What is written on the pictures of a figure: titles, colour bars, colour keys, each on a dark plate.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>

#include "app/picture/figure.h"
#include "techniques/foundation/image/image.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::picture {

/// So many significant digits, more only before the point: legends are read from afar.
std::string shortNumber(double value, int digits = 3);

/// A plate that is laid out but not yet drawn, so that one can first test whether there is room for it.
struct Plate {
    int width = 0, height = 0;
    int lines = 0;                                                    ///< of text
    std::function<void(image::Image& figure, int x, int y)> drawText; ///< (x, y): the plate's upper left corner
    [[nodiscard]] bool isEmpty() const { return lines == 0; }
};

// `em` is the type size in pixels. A text that is wider than `widest` is wrapped. What cannot be wrapped may come out
// wider. The plates refer to the font and the panel.
Plate titlePlate(const std::string& title, const image::Font& font, double em, int widest);
/// A bar with its numbers and unit, or the key of the colours; empty for a panel that needs neither.
Plate legendPlate(const Panel& panel, const image::Font& font, double em, int widest);

/// Darkens what is below, so that text is legible on any picture, and writes on it.
void drawPlate(image::Image& figure, const Plate& plate, int x, int y);

} // namespace shadowlab::picture
