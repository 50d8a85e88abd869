// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/probe/filter_facts.h"

#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/probed/map_probe.h"

namespace shadowlab::shadow_map {

namespace {

using Tap = MapProbe::Tap;

constexpr std::size_t kListedTaps = 32; ///< as lines of text; as JSON there are all

std::size_t litCount(const std::vector<Tap>& taps) {
    return static_cast<std::size_t>(std::ranges::count(taps, true, &Tap::isLit));
}

void tellSearch(Probe& probe, const MapProbe::BlockerSearch& search) {
    const auto add = [&](const char* label, double metres) { probe.facts.push_back(probeFact(label, metres, "m")); };
    probe.facts.push_back({"blocker search",
                           std::to_string(search.found) + " of " + std::to_string(search.looks.size()) +
                               " depths are nearer to the light than the point, up to " +
                               probeText(search.searchTexels) + " texels away" +
                               (search.found == 0 ? ": no blocker, so lit" : ""),
                           ""});
    add("d_r: distance of the point from the light", search.receiverMetres);
    if (search.found == 0) return;
    add("d_b: mean distance of the blockers", search.blockerMetres);
    add("w_L: width of the light", search.lightMetres);
    add("w = w_L (d_r - d_b) / d_b: width of the penumbra", search.penumbraMetres);
    probe.facts.push_back(probeFact("radius of the filter", search.kernelTexels, "texels"));
}

void tellMoments(Probe& probe, const MapProbe::Moments& moments) {
    const auto add = [&](std::string label, double value) {
        probe.facts.push_back(probeFact(std::move(label), value));
    };
    if (moments.read.empty()) {
        probe.facts.push_back({"moments", "none: the point is outside of the map, so lit", ""});
        return;
    }
    add("z: depth of the point, from -1 to 1", moments.depth);
    for (const auto& [name, value] : moments.read)
        add(name, value);
    for (const MapProbe::Moments::Bound& bound : moments.bounds) {
        add("point's own " + bound.of, bound.compared);
        add("mean of " + bound.of, bound.mean);
        add("variance of " + bound.of, bound.variance);
        add("lit share by " + bound.of + ", at most", bound.visibility);
    }
    if (moments.bounds.empty()) add("mean of exp(c d) / exp(c z), at most 1", moments.unreduced);
    if (!moments.bounds.empty() && moments.visibility != moments.unreduced)
        add("the same less the light that bleeds", moments.visibility);
}

std::string tapText(const Tap& tap) {
    return "texel " + std::to_string(tap.texel.x) + ", " + std::to_string(tap.texel.y) + " at " +
           probeText(tap.placeTexels.x) + ", " + probeText(tap.placeTexels.y) +
           ": d = " + (tap.stored >= 1 ? "1 (nothing)" : probeText(tap.stored)) + (tap.isLit ? " >= " : " < ") +
           probeText(tap.compared) + " = z";
}

void tellSome(Probe& probe, const char* name, const std::vector<Tap>& taps, const char* lit, const char* dark) {
    for (std::size_t i = 0; i < std::min(taps.size(), kListedTaps); ++i)
        probe.facts.push_back(
            {name + (" " + std::to_string(i + 1)), tapText(taps[i]) + (taps[i].isLit ? lit : dark), ""});
    if (taps.size() > kListedTaps)
        probe.facts.push_back({std::string("more of the kind ") + name, std::to_string(taps.size() - kListedTaps), ""});
}

void addCross(std::vector<dvec3>& points, const dvec3& at, double half) {
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 along(0.0);
        along[axis] = half;
        points.insert(points.end(), {at - along, at + along});
    }
}

} // namespace

void tellFilter(Probe& probe, const FilterAnswer& answer) {
    if (answer.search) tellSearch(probe, *answer.search);
    if (answer.moments) tellMoments(probe, *answer.moments);
    if (answer.taps.size() > 1)
        probe.facts.push_back({"filter",
                               std::to_string(litCount(answer.taps)) + " of " + std::to_string(answer.taps.size()) +
                                   " comparisons say lit; with their weights " + probeText(answer.visibility),
                               ""});
}

void tellTaps(Probe& probe, const FilterAnswer& answer) {
    if (answer.search) tellSome(probe, "look", answer.search->looks, "", ": a blocker");
    if (answer.taps.size() > 1) tellSome(probe, "comparison", answer.taps, ": lit", ": in shadow");
}

std::vector<SceneShape> tapShapes(const FilterAnswer& answer, double texelMetres) {
    // A third of a texel to each side: crosses of neighbouring texels stay apart.
    const double half = texelMetres / 3;
    SceneShape lit{"comparisons: lit", look::kEqualDepth, SceneShape::Kind::lines, {}};
    SceneShape dark{"comparisons: in shadow", look::kOccluded, SceneShape::Kind::lines, {}};
    if (answer.taps.size() < 2) return {};
    for (const Tap& tap : answer.taps)
        addCross((tap.isLit ? lit : dark).pointsWorld, tap.onPlaneWorld, half);
    return {std::move(lit), std::move(dark)};
}

} // namespace shadowlab::shadow_map
