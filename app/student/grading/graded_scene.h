// The scenes that a plug-in is tried in: those of the cases, and those of a search.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::student {

/// As every command loads it. Throws Error (badInput, overLimit).
scene::Snapshot loadGradedScene(const std::filesystem::path& file);

} // namespace shadowlab::student
