// A lesson: one artefact, shown and then removed. What its file says (docs/lessons.md), checked and made complete, as the
// window, pictures and measurements take it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/course/shown_state.h"
#include "app/film/motion.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::course {

/// The shape of picture that a lesson is made for, width over height: its boxes are shares of such a picture.
constexpr double kLessonAspect = lab::kPlacesAspect;

/// The words of a lesson, which are known without its scene.
struct LessonText {
    std::string name; ///< of the file, without folder and ending
    std::filesystem::path file;
    std::string title;
    std::string chapter; ///< of the course; empty: none
    std::string happens; ///< what is wrong, and why
    std::string remedy;  ///< what removes it
    std::vector<std::string> alike{}; ///< names of lessons whose titles would be true of this one's artefact, too
};

/// Where to look: a box in shares of the picture's width and height from its upper left corner.
struct LookBox {
    dvec2 corner{0.0}, size{0.0};
    std::string label;
};

/// The box in a picture of another shape, with the same angle of view from top to bottom; it may reach beyond the picture.
LookBox inPictureOf(double aspect, LookBox box);

/// What a number has to be. At least one of them is there.
struct Bound {
    std::optional<double> atLeast, atMost;
    [[nodiscard]] bool holds(double value) const {
        return (!atLeast || value >= *atLeast) && (!atMost || value <= *atMost);
    }
    /// Is there a number that holds for both?
    [[nodiscard]] bool meets(const Bound& other) const {
        return !(atLeast && other.atMost && *atLeast > *other.atMost) &&
               !(atMost && other.atLeast && *atMost < *other.atLeast);
    }
    [[nodiscard]] std::string text() const; ///< "at least 500"
};

/// One thing that can be measured of both states (lesson_quantities.h says what there is).
struct Expectation {
    std::string quantity;
    int slot = 0;                       ///< whose, counted from 0
    std::optional<int> look{};          ///< only within this box, counted from 0
    std::optional<lab::PaneState> reference; ///< what a picture is compared with
    std::string fact{};                 ///< of a probe, or of a counter: its label
    dvec2 pixel{0.5};                   ///< of a fact: where, in shares of the picture
    Bound before, after;
};

/// What the class is asked before it is shown.
struct Question {
    enum class Kind {
        choice, ///< one of several answers
        mark,   ///< where the shadow will be, painted on the picture without shadows
    };
    Kind kind = Kind::choice;
    std::size_t picture = 0; ///< of a choice: the state that is shown while it is asked
    std::string text;
    std::vector<std::string> choices; ///< of a choice
    int right = 0;                    ///< index of the right one
};

struct Lesson {
    LessonText text;
    std::array<ShownState, 2> states; ///< before, after
    film::Motion motion;                    ///< of artefacts that only show in moving pictures; else a single frame
    std::vector<LookBox> look;
    std::vector<Expectation> expectations;
    ivec2 size{320, 180}; ///< of the pictures that are measured
    std::optional<Question> question;
};

/// One thing that differs between the two states of a lesson, in words: "Bias type", "none", "receiver-plane".
struct LessonChange {
    std::string name, before, after;
};

/// What the remedy changes: techniques and their settings slot by slot, the scene, its camera, its lights.
std::vector<LessonChange> changesOf(const Lesson& lesson);

/// The slot that the lesson's numbers of wrong pixels are about, counted from 0.
int judgedSlot(const Lesson& lesson);

/// The chapters of lessons in the order in which they first occur.
std::vector<std::string> chaptersOf(const std::vector<LessonText>& lessons);

/// The built-in lessons in the order of the course: by their keys "order", then by name. Throws Error (badInput) for one that
/// cannot be read.
std::vector<LessonText> builtInLessons(const std::filesystem::path& assets);

/// A path to a .json, else the name of a built-in lesson. Throws Error (badInput, overLimit) with FILE:LINE:COLUMN for
/// what a lesson may not say, and all that loading its scene throws.
Lesson loadLesson(const std::string& nameOrPath, const scene::LoadOptions& options);

/// The same from a text; `file` is named in errors, and scenes are looked for beside it.
Lesson parseLesson(const std::string& text, const std::filesystem::path& file, const scene::LoadOptions& options);

} // namespace shadowlab::course
