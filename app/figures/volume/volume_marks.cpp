// SPDX-License-Identifier: MIT
#include "app/figures/volume/volume_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/base/look.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

/// Counts 0, 1, 2, 3, and 4 and more: lightness alone, so that no eye for colour is needed.
std::string countFill(int count) {
    static constexpr std::array kFills{"#ffffff", "#e6e6e6", "#cccccc", "#b0b0b0", "#969696"};
    return kFills[static_cast<std::size_t>(std::min(std::abs(count), 4))];
}

std::string signColor(int sign) { return drawing::colorText(sign > 0 ? look::diverging()[7] : look::diverging()[1]); }

std::string signedText(int number) {
    return (number > 0 ? "+" : number < 0 ? "\u2212" : "") + std::to_string(std::abs(number));
}

void drawCountedAreas(drawing::Drawing& drawing, const SectionSheet& sheet, const VolumeProbe& volume) {
    drawing.beginClip(sheet.area().corner, sheet.area().size);
    for (const CountedArea& area : countedAreas(volume.caps, sheet.light(), sheet.metres())) {
        std::vector<dvec2> corners;
        for (const dvec2& corner : area.corners)
            corners.push_back(sheet(corner));
        const dvec2 low = glm::min(glm::min(corners[0], corners[1]), glm::min(corners[2], corners[3]));
        const dvec2 high = glm::max(glm::max(corners[0], corners[1]), glm::max(corners[2], corners[3]));
        if (!sheet.area().overlaps({low, high - low})) continue;
        // A rim of its own colour closes the seam to the next one.
        drawing.path(corners, true, countFill(area.count), {countFill(area.count), 1, false});
    }
    drawing.endClip();
}

dvec2 placeOf(const SectionSheet& sheet, const VolumeProbe::Crossing& crossing) {
    return sheet.eye() - crossing.distance * glm::normalize(sheet.eye());
}

dvec2 lineStart(const SectionSheet& sheet) {
    return sheet.shows(sheet.eye()) ? sheet(sheet.eye()) : sheet.border(dvec2(0.0), sheet.eye());
}

dvec2 lineEnd(const SectionSheet& sheet) { return sheet.border(dvec2(0.0), -sheet.eye()); }

} // namespace shadowlab::figures
