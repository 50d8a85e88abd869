// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson.h"

#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

std::string Bound::text() const {
    std::string text;
    if (atLeast) text = "at least " + scene::numberText(*atLeast);
    if (atMost) text += (text.empty() ? "" : ", ") + ("at most " + scene::numberText(*atMost));
    return text;
}

LookBox inPictureOf(double aspect, LookBox box) {
    const double narrower = kLessonAspect / aspect;
    box.corner.x = 0.5 + (box.corner.x - 0.5) * narrower;
    box.size.x *= narrower;
    return box;
}

} // namespace shadowlab::course
