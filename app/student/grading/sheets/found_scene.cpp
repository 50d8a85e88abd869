// SPDX-License-Identifier: MIT
#include "app/student/grading/sheets/found_scene.h"

namespace shadowlab::student {

std::string toText(const SearchReport& report) {
    std::string text = std::to_string(report.tried) + " of " + std::to_string(report.asked) + " random scenes were tried, of seed " +
                       std::to_string(report.seed);
    if (report.unfair > 0) text += "; in " + std::to_string(report.unfair) + " of them nothing could be asked";
    text += ". ";
    if (!report.found)
        return text + (report.isOutOfTime ? "Then the time was over. All were right." : "All were right.");
    const FoundScene& found = *report.found;
    return text + "Scene " + std::to_string(found.number) + ", " + found.idea + ", was wrong, with " +
           std::to_string(found.trianglesBefore) + " triangles; " + std::to_string(found.triangles) + " of them are enough.";
}

} // namespace shadowlab::student
