// What a technique decided about a pixel, held against the truth.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/probe.h"

namespace shadowlab {

/// Does a visibility (0..1), cut at one half, differ from the truth? A surface that is turned away is in the dark for both.
bool isWrong(double visibility, trace::Visibility truth);

/// Adds the facts `decision` and, where it is wrong, `error`, and fills Probe::decision. `why`: how the wrong answer came about,
/// in one sentence, as far as it can be proved; not used where the answer is right.
void addDecision(Probe& probe, double visibility, trace::Visibility truth, const std::string& why);

/// Adds the fact `who decides` and a Decider (techniques/probed/seen_point.h). Without a decision beside it: the probe cannot follow
/// the technique there.
void addDecider(Probe& probe, std::string who);

} // namespace shadowlab
