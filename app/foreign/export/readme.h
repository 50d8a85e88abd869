// The README of an exported scene: what the files mean, how a picture is made of them, and what they do not say.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/foreign/export/format.h"

namespace shadowlab::foreign {

/// Markdown. `command`: how the folder was made. `scene`: as commands name it, with the options that go with it.
std::string readmeText(const Format& format, const PlainScene& plain, const std::string& scene, const std::string& command, ivec2 size);

} // namespace shadowlab::foreign
