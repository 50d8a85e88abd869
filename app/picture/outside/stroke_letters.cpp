// SPDX-License-Identifier: MIT
#include "app/picture/outside/stroke_letters.h"

namespace shadowlab::picture {

namespace {

constexpr int kColumns = 4, kRows = 6; ///< of the grid that the strokes' corners lie on
constexpr double kAdvance = 1.5;       ///< widths from letter to letter

/// Corners as column and row from the lower left, of one stroke after the other.
std::string_view strokesOf(char letter) {
    switch (letter) {
    case 'H': return "00 06/40 46/03 43";
    case 'L': return "06 00 40";
    case 'N': return "00 06 40 46";
    case 'R': return "00 06 36 45 44 33 03/23 40";
    case 'S': return "45 36 16 05 04 13 33 42 41 30 10 01";
    case 'T': return "06 46/26 20";
    case 'V': return "06 20 46";
    case 'u': return "04 01 10 30 41/44 40";
    case '0': return "10 01 05 16 36 45 41 30 10";
    case '1': return "04 26 20";
    case '2': return "05 16 36 45 44 00 40";
    case '3': return "06 46 23 33 42 41 30 10 01";
    case '4': return "30 36 02 42";
    case '5': return "46 06 03 33 42 41 30 00";
    case '6': return "36 16 05 01 10 30 41 42 33 03";
    case '7': return "06 46 10";
    case '8': return "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33";
    case '9': return "10 30 41 45 36 16 05 04 13 43";
    default: return "";
    }
}

} // namespace

void addWord(std::vector<dvec3>& pointsWorld, std::string_view word, const dvec3& centreWorld, const dvec3& rightWorld,
             const dvec3& upWorld) {
    const double width = kAdvance * static_cast<double>(word.size() - 1) + 1;
    dvec3 lowerLeft = centreWorld - 0.5 * width * rightWorld - 0.5 * upWorld;
    for (const char letter : word) {
        const std::string_view strokes = strokesOf(letter);
        const auto corner = [&](std::size_t i) {
            return lowerLeft + (strokes[i] - '0') / static_cast<double>(kColumns) * rightWorld +
                   (strokes[i + 1] - '0') / static_cast<double>(kRows) * upWorld;
        };
        for (std::size_t i = 0; i + 4 < strokes.size(); i += 3)
            if (strokes[i + 2] == ' ') pointsWorld.insert(pointsWorld.end(), {corner(i), corner(i + 3)});
        lowerLeft += kAdvance * rightWorld;
    }
}

} // namespace shadowlab::picture
