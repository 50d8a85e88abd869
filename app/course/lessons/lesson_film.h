// A lesson as a sequence of pictures for a slide: the question and its answer, where it asks one, the artefact, the remedy. Each
// has its own words below, and stays long enough for them to be read.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "app/course/lessons/lesson.h"
#include "app/film/film.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

/// What is shown one after the other.
enum class LessonShot {
    question, ///< the question, over a picture that does not give the answer away
    answer,   ///< the same picture with the right choice, or with the true shadow laid over it
    artefact,
    remedy,
};
std::vector<LessonShot> shotsOf(const Lesson& lesson);

/// The unit in which pictures are held: a tenth of a second. A motion goes on by one frame in each.
constexpr image::FrameTime kLessonTick{1, 10};

/// Ticks for which a shot stays, by the number of its words.
int readingTicks(const Lesson& lesson, LessonShot shot);

struct LessonFilmSettings {
    ivec2 size{1280, 720};             ///< of the whole, in pixels
    std::optional<double> holdSeconds; ///< of every shot; without it as long as its words take to be read
};

/// Adds the pictures of all shots, whose unit of time is kLessonTick. Of a lesson about moving pictures the motion follows each
/// of artefact and remedy, to and fro. Throws Error (usage) for a size without room for a picture beside the words, and all that
/// drawing throws. Needs a current GL context.
void filmLesson(const Lesson& lesson, const LessonFilmSettings& settings, const image::Font& font,
                const image::Font& bold, film::Film& film);

} // namespace shadowlab::course
