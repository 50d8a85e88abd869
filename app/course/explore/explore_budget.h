// How much of an explorable slide fits into so many bytes: fewer positions of the lamp, smaller pictures, fewer pixels to ask.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "app/course/explore/explored_slide.h"

namespace shadowlab::course {

struct FittedSlide {
    ExploredSlide explored;
    ExploreSize size;
    std::string lessThanAsked; ///< "24 of 48 positions of the lamp, pictures of 512 x 288"; empty: all that was asked for
};

/// The first of a few sizes, from all that is asked for to very little, whose bytes stay within `mostBytes`. A trial with three positions
/// of the lamp says which may. `request.size` is not read. Throws Error (overLimit) where even the least is too much, and all that
/// exploredSlide() throws.
FittedSlide fittedSlide(const Slide& slide, const Explore& explore, ExploreRequest request, std::size_t mostBytes, const image::Font& font,
                        const image::Font& bold, FrameTimes& times);

/// The first of these sizes: all that is asked for.
ExploreSize askedSize(const Explore& explore);

/// Bytes that a slide takes in a page: its pieces in base64, and what its script reads.
std::size_t pageBytes(const ExploredSlide& explored);

} // namespace shadowlab::course
