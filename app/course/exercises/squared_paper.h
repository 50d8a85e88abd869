// Squared paper for the figures of exercises: one square to a metre, with numbers at two of its borders, on which students read places
// and draw with a ruler.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "app/drawing/drawing.h"

namespace shadowlab::course {

class SquaredPaper {
public:
    /// From `lower` to `upper`, whole numbers. The second axis goes up, or down as the rows of a picture do.
    SquaredPaper(dvec2 lower, dvec2 upper, std::string_view firstAxis, std::string_view secondAxis,
                 bool secondGoesDown = false);

    [[nodiscard]] dvec2 at(dvec2 place) const;
    void line(dvec2 from, dvec2 to, const drawing::Stroke& stroke);
    /// A box between two corners.
    void box(dvec2 lower, dvec2 upper, const std::string& fill);
    /// A dot with its name beside it.
    void point(dvec2 place, std::string_view name, const std::string& color, dvec2 labelOffsetPx = {12, -12});
    void label(dvec2 place, std::string_view text, drawing::Anchor anchor = drawing::Anchor::middle);
    [[nodiscard]] drawing::Drawing& drawing() { return drawing_; }

    static constexpr double kSquare = 56, kLabel = 27; ///< pixels; a square is 7 mm wide on paper

private:
    dvec2 lower_, upper_;
    bool secondGoesDown_;
    drawing::Drawing drawing_;
};

} // namespace shadowlab::course
