// What is written in a drawing, and where.
// SPDX-License-Identifier: MIT
#pragma once
#include <regex>
#include <string>
#include <vector>

#include "app/context/assets.h"
#include "app/drawing/labels.h"

namespace shadowlab::figures {

inline const image::Font& testFont() {
    static const image::Font font(context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    return font;
}

inline const image::Font& testBoldFont() {
    static const image::Font font(context::assetsRoot() / "fonts" / "DejaVuSans-Bold.ttf");
    return font;
}

/// All that is written, without the rims.
struct Written {
    std::string text;
    drawing::Box box;
    double em = 0;
    bool isBold = false; ///< its box is that of upright letters all the same
};
inline std::vector<Written> written(const std::string& drawing) {
    static const std::regex kText(
        R"re(<text x="([-0-9.]+)" y="([-0-9.]+)" font-size="([0-9.]+)" text-anchor="(\w+)"([^>]*) fill=[^>]*>([^<]*)</text>)re");
    std::vector<Written> all;
    for (auto it = std::sregex_iterator(drawing.begin(), drawing.end(), kText); it != std::sregex_iterator(); ++it) {
        const double em = std::stod((*it)[3]);
        const dvec2 size = drawing::textSize(testFont(), (*it)[6].str(), em);
        dvec2 corner(std::stod((*it)[1]), std::stod((*it)[2]) - 0.8 * em);
        if ((*it)[4] == "middle") corner.x -= size.x / 2;
        if ((*it)[4] == "end") corner.x -= size.x;
        all.push_back({(*it)[6], {corner, {size.x, 0.75 * em}}, em, (*it)[5].str().find("bold") != std::string::npos}); // the letters, without the air around them
    }
    return all;
}

} // namespace shadowlab::figures
