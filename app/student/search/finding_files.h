// What a search has found, as files: the scene, a lesson, the lecture's figure of a wrong pixel, and a picture of plug-in and truth.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "app/student/search/finding_text.h"

namespace shadowlab::student {

/// Names of files, and their bytes. STEM.json and its meshes; STEM-lesson.json and STEM.svg where there is a picture to speak of and a
/// figure that can be drawn; STEM.png. To be called right after search().
std::map<std::string, std::string> filesOf(const Finding& finding, SceneTrials& trials, const Candidate& candidate,
                                           const std::string& stem);

} // namespace shadowlab::student
