// What of a lesson can be measured, described once: the reader of lessons, the page about them and the measurement walk
// this list.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>

#include "app/course/lessons/lesson.h"

namespace shadowlab::course {

struct LessonQuantity {
    enum class Of { visibility, motion, picture, reference, fact };
    std::string_view id, name; ///< as it is written in files, and for people
    Of of;
    std::string_view unit, help;
    [[nodiscard]] constexpr bool countsPixels() const { return unit.find("pixels") != std::string_view::npos; }
};

constexpr LessonQuantity kLessonQuantities[] = {
    {"falseLit", "Lit, but should be dark", LessonQuantity::Of::visibility, "pixels", "lit, but should be dark; in the box, if there is one"},
    {"falseShadow", "Dark, but should be lit", LessonQuantity::Of::visibility, "pixels", "dark, but should be lit; in the box, if there is one"},
    {"wrong", "Wrong pixels", LessonQuantity::Of::visibility, "pixels", "both together"},
    {"wrongPercent", "Share of wrong pixels", LessonQuantity::Of::visibility, "% of pixels",
     "both together, of all pixels that are judged; in the box, if there is one"},
    {"coreErrors", "Wrong pixels that are no aliasing", LessonQuantity::Of::visibility, "pixels", "wrong pixels that are no aliasing"},
    {"edgeErrorPx", "Edge error", LessonQuantity::Of::visibility, "px", "wrong pixels for each pixel of true boundary"},
    {"rmse", "RMS error of visibility", LessonQuantity::Of::visibility, "", "of visibility, 0 to 1"},
    {"flips", "Pixels that flicker", LessonQuantity::Of::motion, "per pixel of boundary and frame",
     "pixels that change from one frame to the next although the truth does not"},
    {"crawl", "Points that crawl", LessonQuantity::Of::motion, "% of points",
     "points of surfaces, followed from frame to frame while the eye moves, whose light changes although the truth "
     "does not"},
    {"meanLevel", "Mean level", LessonQuantity::Of::picture, "of 255",
     "the mean of the picture as it is shown; in the box, if there is one"},
    {"levelDeviation", "Spread of levels", LessonQuantity::Of::picture, "of 255",
     "how much the picture varies about that mean (standard deviation): noise, on an even surface"},
    {"pictureRmse", "RMS difference from the reference", LessonQuantity::Of::reference, "of 255",
     "how far the picture is from that of the reference (root mean square); in the box, if there is one"},
    {"differing", "Pixels unlike the reference", LessonQuantity::Of::reference, "pixels",
     "pixels of the picture that are not the same bytes as those of the reference; in the box, if there is one"},
    {"fact", "A number of the probe", LessonQuantity::Of::fact, "",
     "the number that a probe of the pixel has under that label, the largest of several"},
    {"counter", "A count", LessonQuantity::Of::fact, "", "what the technique counted under that name"},
};

constexpr std::span<const LessonQuantity> lessonQuantities() { return kLessonQuantities; }

/// What an expectation of a lesson is about.
const LessonQuantity& quantityOf(const Expectation& expected);

} // namespace shadowlab::course
