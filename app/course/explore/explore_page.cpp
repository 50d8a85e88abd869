// SPDX-License-Identifier: MIT
#include "app/course/explore/explore_page.h"

#include <array>

#include "app/drawing/markup.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::course {

namespace {

constexpr std::uint64_t kLargestCode = 1 << 20; ///< bytes of a file; ours have some ten thousand
// In the order in which the page reads them.
constexpr std::array kScripts{"explore_parts.js",   "explore_pack.js",  "explore_stage.js", "explore_lamp.js", "explore_choices.js",
                              "explore_numbers.js", "explore_steps.js", "explore_ask.js",   "explore.js"};

/// In an element of a page: no "</" in a text ends it.
std::string withoutEndTags(std::string json) {
    for (std::size_t at = json.find("</"); at != std::string::npos; at = json.find("</", at + 2))
        json.replace(at, 2, "<\\/");
    return json;
}

} // namespace

std::string exploreElements(const std::string& slide, const ExploredSlide& explored) {
    return "<script type=\"application/json\" id=\"explore-" + slide + "\">" + withoutEndTags(explored.json) +
           "</script>\n<script type=\"text/plain\" id=\"pack-" + slide + "\">" + drawing::base64(explored.bytes) + "</script>\n";
}

ExploreCode exploreCode(const std::filesystem::path& assets) {
    const std::filesystem::path pages = assets / "pages";
    ExploreCode code{scene::readFile(pages / "explore.css", kLargestCode), ""};
    for (const char* script : kScripts)
        code.script += scene::readFile(pages / script, kLargestCode);
    return code;
}

} // namespace shadowlab::course
