// SPDX-License-Identifier: MIT
#include "app/course/lessons_page/lesson_pictures.h"

#include "app/course/state_motion.h"
#include "app/course/state_picture.h"
#include "techniques/foundation/image/webp/webp.h"

namespace shadowlab::course {

std::array<LessonFrames, 2> lessonPictures(const Lesson& lesson, const image::Font& font, const std::function<void()>& onPicture) {
    std::array<LessonFrames, 2> frames;
    for (std::size_t state = 0; state < frames.size(); ++state)
        for (const ShownState& shown : statesInMotion(lesson.states[state], lesson.motion)) {
            frames[state].push_back(image::encodeWebp(drawState(shown, {.size = kPagePictureSize}, font), image::WebpKind::photo));
            onPicture();
        }
    return frames;
}

} // namespace shadowlab::course
