// `shadowlab SCENE` is short for `shadowlab demo SCENE`.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/cli/command.h"

namespace shadowlab::cli {

/// The demo of a scene, with all other options at their defaults; an empty name stands for the default scene.
Work demoOf(const std::string& scene);

} // namespace shadowlab::cli
