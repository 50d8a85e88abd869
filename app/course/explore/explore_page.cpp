// SPDX-License-Identifier: MIT
#include "app/course/explore/explore_page.h"

#include <array>

#include "app/course/page_code.h"
#include "app/drawing/markup.h"

namespace shadowlab::course {

namespace {

constexpr std::array kLabStyles{"explore.css"};
// In the order in which the page reads them.
constexpr std::array kLabScripts{"explore_parts.js",   "explore_pack.js",  "explore_stage.js", "explore_lamp.js", "explore_choices.js",
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
    return {pageCode(assets, kLabStyles), pageCode(assets, kLabScripts)};
}

} // namespace shadowlab::course
