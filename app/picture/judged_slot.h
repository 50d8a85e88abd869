// Judging a slot: its frame is drawn with its technique's visibility of one light, and that is compared with the kind of truth that
// the technique is judged by (judge::TruthOf).
// `measure`, `report`, hard cases and lessons all judge this way; the window does it on a thread without OpenGL, from the pure
// part of it (judge/slot_errors.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "app/judge/slot_errors.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"

namespace shadowlab::picture {

/// What a technique says of one light, read back from the graphics card.
struct Answers {
    VisibilityImage visibility;
    std::optional<judge::Grid<float>> texelPx; ///< pixels that a texel of its shadow map covers; none: it has no map
};
/// The request for a frame in which a technique publishes its visibility; to be rendered, and then read.
FrameRequest requestAnswers(const TechniqueInfo& info, int light);
Answers readAnswers(const TechniqueInfo& info, const RenderedFrame& rendered, int light);

/// Share of the pixels with a surface that the technique serves at all, 0..1.
double servedShare(const RenderedFrame& rendered);

/// How wrong answers are over the whole picture.
struct AnswerErrors {
    judge::SlotErrors errors;
    int core = 0; ///< wrong pixels that are no aliasing
};
/// `boundary` is that of the truth. No OpenGL.
AnswerErrors judgeAnswers(const Answers& answers, const judge::Truth& truth, const std::vector<judge::BoundaryEdge>& boundary);

struct JudgedSlot {
    RenderedFrame rendered;
    Answers answers;
    LightTruth asked;          ///< what it was judged by
    const judge::Truth& truth; ///< the session's: valid until the next request about the same light
    AnswerErrors found;
};
/// All of it, for one frame. Throws Error (badInput) for a technique that publishes no visibility.
JudgedSlot judgeSlot(Session& session, Slot& slot, const View& view, int light);

} // namespace shadowlab::picture
