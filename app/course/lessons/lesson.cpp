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
    const double right = lab::shareOf(box.corner + box.size, {aspect, 1}).x;
    box.corner = lab::shareOf(box.corner, {aspect, 1});
    box.size.x = right - box.corner.x;
    return box;
}

} // namespace shadowlab::course
