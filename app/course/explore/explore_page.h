// Explorable slides in a page: their data as elements of it, and the style and script that make labs of them. It is all in the one file,
// because a page that is opened from a folder may load no other.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "app/course/explore/explored_slide.h"

namespace shadowlab::course {

/// Two elements: what the script reads, and the bytes, in base64.
std::string exploreElements(const std::string& slide, const ExploredSlide& explored);

/// What explorable slides look like, and do.
struct ExploreCode {
    std::string style, script;
};
/// From the files of assets/pages. Throws Error (badInput) where one is missing.
ExploreCode exploreCode(const std::filesystem::path& assets);

} // namespace shadowlab::course
