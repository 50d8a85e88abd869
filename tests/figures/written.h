// What is written in a drawing, and where.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
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
/// With the signs of markup as they are read.
inline std::string unescaped(std::string text) {
    for (const auto& [escaped, sign] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
        for (std::size_t at = text.find(escaped); at != std::string::npos; at = text.find(escaped))
            text.replace(at, std::string(escaped).size(), sign);
    return text;
}
inline std::vector<Written> written(const std::string& drawing) {
    static const std::regex kText(
        R"re(<text x="([-0-9.]+)" y="([-0-9.]+)" font-size="([0-9.]+)" text-anchor="(\w+)"([^>]*) fill=[^>]*>([^<]*)</text>)re");
    std::vector<Written> all;
    for (auto it = std::sregex_iterator(drawing.begin(), drawing.end(), kText); it != std::sregex_iterator(); ++it) {
        const double em = std::stod((*it)[3]);
        const std::string text = unescaped((*it)[6].str());
        const dvec2 size = drawing::textSize(testFont(), text, em);
        dvec2 corner(std::stod((*it)[1]), std::stod((*it)[2]) - 0.8 * em);
        if ((*it)[4] == "middle") corner.x -= size.x / 2;
        if ((*it)[4] == "end") corner.x -= size.x;
        all.push_back({text, {corner, {size.x, 0.75 * em}}, em, (*it)[5].str().find("bold") != std::string::npos}); // the letters, without the air around them
    }
    return all;
}

/// Words and formulas that stand in one line, in the order of drawing, as one text: "N · L = 1.378 m > 0". Its em is that of its largest
/// letters. Gaps of up to a space around a sign are blanks; a little less than that is between letters.
inline std::vector<Written> linesOf(const std::vector<Written>& pieces) {
    constexpr double kBlank = 0.2, kWidestGap = 0.65, kRaised = 0.5; // em; a bold letter is up to 0.14 wider than measured
    std::vector<Written> lines;
    double foot = 0; // of the first letters of the line
    for (const Written& piece : pieces) {
        const double ends = piece.box.corner.y + 0.8 * piece.em;
        if (!lines.empty()) {
            Written& line = lines.back();
            const double gap = piece.box.corner.x - line.box.corner.x - line.box.size.x;
            const bool goesOn = gap > -kBlank * line.em && gap < kWidestGap * line.em && std::abs(ends - foot) < kRaised * line.em;
            if (goesOn) {
                line.text += (gap > kBlank * line.em ? " " : "") + piece.text;
                line.box.size.x = piece.box.corner.x + piece.box.size.x - line.box.corner.x;
                line.em = std::max(line.em, piece.em);
                continue;
            }
        }
        lines.push_back(piece);
        foot = ends;
    }
    return lines;
}

} // namespace shadowlab::figures
