// The exact judge of a scene, for probes.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "techniques/foundation/trace/judge/exact_visibility.h"

namespace shadowlab {

/// To make one takes as long as to look at every triangle, and who picks a pixel asks again with every move of the eye: so
/// that of the last scene is kept, for all techniques. From any thread.
std::shared_ptr<const trace::ExactVisibility> exactJudge(const scene::Snapshot& snapshot);

} // namespace shadowlab
