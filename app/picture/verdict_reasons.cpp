// SPDX-License-Identifier: MIT
#include "app/picture/verdict_reasons.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "techniques/probed/map_probe.h"
#include "techniques/probed/plane_probe.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::picture {

namespace {

/// Two numbers with as few decimals as show that they differ, but at least so many: two are enough for metres, and of depths
/// between 0 and 1 the fourth is a millimetre or so.
std::array<std::string, 2> apart(double a, double b, int decimals) {
    constexpr int kMostDecimals = 9;
    while (decimals < kMostDecimals && a != b && fixed(a, decimals) == fixed(b, decimals))
        ++decimals;
    return {fixed(a, decimals), fixed(b, decimals)};
}

/// The faces that the technique counts, of one of the two ways to count.
struct Counted {
    int entered = 0, left = 0;

    Counted(const VolumeProbe& volume, CountMethod method) {
        for (const VolumeProbe::Crossing& crossing : volume.crossings) {
            if (crossing.method != method || crossing.counted == 0) continue;
            ++(crossing.sign > 0 ? entered : left);
        }
    }
    [[nodiscard]] bool any() const { return entered + left > 0; }
};

std::string difference(const char* what, int more, int less) {
    return std::string(what) + " = " + std::to_string(more) + " - " + std::to_string(less) + " = " +
           std::to_string(more - less);
}

std::string nearer(const MapProbe& map) {
    const bool isLess = map.stored < map.compared;
    const bool agrees = isLess == (map.storedMetres < map.comparedMetres) && std::isfinite(map.storedMetres) &&
                        std::isfinite(map.comparedMetres);
    const auto [d, z] = agrees ? apart(map.storedMetres, map.comparedMetres, 2) : apart(map.stored, map.compared, 4);
    const std::string unit = agrees ? " m" : "";
    return "d " + d + unit + (isLess ? " < " : " >= ") + "z - bias " + z + unit;
}

/// Null where none casts.
const PlaneProbe::Cover* firstCasting(const PlaneProbe& plane) {
    const auto found = std::ranges::find_if(plane.covers, &PlaneProbe::Cover::casts);
    return found == plane.covers.end() ? nullptr : &*found;
}

} // namespace

std::string fixed(double number, int decimals) {
    std::array<char, 400> text{}; // a double has at most 309 digits before its point
    // With a point in any language of the system. 0.0 makes -0 a plain zero.
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number + 0.0, std::chars_format::fixed, decimals).ptr;
    return {text.data(), end};
}

std::string percentOf(double share) {
    if (share > 0 && share < 0.01) return "less than 1 %";
    if (share < 1 && share > 0.99) return "more than 99 %";
    return fixed(100 * share, 0) + " %";
}

std::string volumeReason(const VolumeProbe& volume) {
    const Counted pass(volume, CountMethod::zPass), fail(volume, CountMethod::zFail);
    const bool fails =
        std::ranges::any_of(volume.crossings, [](const auto& c) { return c.method == CountMethod::zFail; });
    std::string text;
    if (volume.start != 0) text += "starts at " + std::to_string(volume.start) + ", ";
    if (pass.any() || volume.start != 0 || !fails)
        text += "entered " + std::to_string(pass.entered) + ", left " + std::to_string(pass.left);
    if (fail.any() || text.empty())
        text += (text.empty() ? "" : "; ") + std::string("beyond the point left ") + std::to_string(fail.left) +
                ", entered " + std::to_string(fail.entered);
    return text;
}

void addVolumeSums(const VolumeProbe& volume, bool isTurnedAway, std::vector<std::string>& sums) {
    sums.push_back("z-pass, eye to point: " + difference("n_f - n_b", volume.frontsBefore, volume.backsBefore) +
                   (volume.eyeCount ? "; the eye is in " + std::to_string(volume.eyeCount) +
                                          (volume.eyeCount == 1 ? " volume" : " volumes") + ", so " +
                                          std::to_string(volume.frontsBefore - volume.backsBefore + volume.eyeCount)
                                    : ""));
    sums.push_back("z-fail, point to infinity: " + difference("n_b - n_f", volume.backsBeyond, volume.frontsBeyond));
    const char* const follows = isTurnedAway           ? ""
                                : volume.stencil == 0 ? ": zero, so the light is added"
                                                      : ": not zero, so the light is left out";
    sums.push_back("stencil = " + std::to_string(volume.stencil) + follows);
}

std::string mapReason(const MapProbe& map, double visibility) {
    if (map.moments) {
        const std::string share = percentOf(glm::clamp(map.moments->unreduced, 0.0, 1.0));
        return "at most " + share + " of the depths around are as far as the point or farther";
    }
    if (map.search && map.search->found == 0) return "the search finds no blocker";
    const auto lit = static_cast<std::size_t>(std::ranges::count_if(map.taps, &MapProbe::Tap::isLit));
    const bool agrees = visibility == (map.stored < map.compared ? 0.0 : 1.0);
    if (!map.taps.empty() && !agrees)
        return std::to_string(lit) + " of " + std::to_string(map.taps.size()) + " comparisons say lit";
    if (!agrees) return percentOf(visibility) + " of the light arrives";
    const bool isOutside = glm::any(glm::lessThan(map.texel, ivec2(0))) ||
                           glm::any(glm::greaterThanEqual(map.texel, ivec2(map.resolution)));
    if (isOutside && visibility == 1) return "the point is outside the map";
    if (map.stored >= 1 && map.stored >= map.compared) return "nothing is stored in the texel (d = 1)";
    return nearer(map);
}

void addMapSums(const MapProbe& map, std::vector<std::string>& sums) {
    const bool isEmpty = map.stored >= 1;
    const auto [d, z] = apart(map.stored, map.compared, 4);
    // The comparison alone: what follows of it is in the sentence, for a surface that is turned away nothing.
    sums.push_back("texel (" + std::to_string(map.texel.x) + ", " + std::to_string(map.texel.y) + "): d " +
                   (isEmpty ? "1 (nothing stored)" : d) + (map.stored < map.compared ? " < " : " >= ") + "z - bias " + z);
    if (!isEmpty)
        sums.push_back("in metres: d " + fixed(map.storedMetres, 3) + ", z " + fixed(map.pointMetres, 3) + ", bias " +
                       fixed(map.pointMetres - map.comparedMetres, 4));
    if (map.moments)
        sums.push_back("bound " + percentOf(glm::clamp(map.moments->unreduced, 0.0, 1.0)) +
                       "; with the light that bleeds taken off " +
                       percentOf(glm::clamp(map.moments->visibility, 0.0, 1.0)));
    if (map.taps.size() > 1) {
        double visibility = 0;
        for (const MapProbe::Tap& tap : map.taps)
            visibility += tap.isLit ? tap.weight : 0;
        sums.push_back(std::to_string(std::ranges::count_if(map.taps, &MapProbe::Tap::isLit)) + " of " +
                       std::to_string(map.taps.size()) + " comparisons find nothing nearer; with their weights " +
                       percentOf(glm::clamp(visibility, 0.0, 1.0)));
    }
}

std::string planeReason(const PlaneProbe& plane, bool isLit) {
    if (!plane.receives) return "no plane receives shadows here";
    const PlaneProbe::Cover* const cover = firstCasting(plane);
    if (isLit)
        return plane.covers.empty() ? "nothing is on the line to the light"
                                    : "nothing on the line to the light is between the plane and it";
    if (!cover) return "an image that does not belong here is drawn, for nothing is clipped";
    return cover->object + " is between, " + fixed(cover->height, 2) + " m above the plane";
}

void addPlaneSums(const PlaneProbe& plane, std::vector<std::string>& sums) {
    if (!plane.receives || plane.covers.empty()) return;
    const PlaneProbe::Cover* const casting = firstCasting(plane);
    const PlaneProbe::Cover& cover = casting ? *casting : plane.covers.front();
    const bool isPoint = plane.lightWorld.w != 0;
    sums.push_back(cover.object + ": N.P + D = " + fixed(cover.height, 3) + " m, w' = " + fixed(cover.weight, 3) +
                   (cover.casts ? ": both positive, so it casts onto the plane" : ": " + cover.why));
    sums.push_back("light: N.P_L + D = " + fixed(plane.lightHeight, 3) + (isPoint ? " m" : ", the cosine"));
}

} // namespace shadowlab::picture
