// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/described.h"

#include "techniques/shadow_map/filters/filters.h"

namespace shadowlab::shadow_map {

namespace {

/// The lines that the step `light` shows: finding the place in the map, then what the chosen filter does there.
std::string anchorsOfLight() {
    std::string anchors = "map-place map-visibility";
    for (const FilterInfo& filter : filters())
        for (const std::string_view anchor : filter.anchors)
            if (!anchor.empty()) anchors += " " + std::string(anchor) + "[filter=" + std::string(filter.name) + "]";
    return anchors;
}

} // namespace

std::span<const PassInfo> passes() {
    static const std::string lightAnchors = anchorsOfLight();
    static const PassInfo all[] = {
        {.id = "lights-off",
         .title = "Render the scene with all light sources turned off",
         .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every "
                "pixel.",
         .glState = "depth test LESS, depth write on",
         .pseudocodeLines = {4, 4},
         .formula = "L = emission + ambient * diffuse",
         .anchors = "lights-off"},
        {.id = "depth",
         .title = "Render the scene from the light and keep the depth",
         .why = "The map stores, for every direction from the light, how far the first surface is: all the light ever "
                "sees. It stays as it is until light, casters or parameters change; the eye may move.",
         .glState = "depth only, depth test LESS, depth clamp, slope-scaled polygon offset",
         .perLight = true,
         .shownBy = "light-depth",
         .pseudocodeLines = {2, 3},
         .formula = "d(u,v) = the least depth on the light's ray through the texel",
         .anchors = "draw-map draw-casters"},
        {.id = "moments",
         .title = "Turn the depths into what can be averaged, and average it",
         .why =
             "An average of depths is no depth of anything. Of their powers, or exponentials, it says how the depths "
             "around a texel are spread, and so at most which share of them is behind the point. Only with filter = "
             "vsm, esm, evsm or msm.",
         .glState = "no depth test; two passes over the map, along rows and columns; float colours",
         .perLight = true,
         .shownBy = "moments",
         .formula = "M1 = mean of d, M2 = mean of d^2 over the neighbouring texels\n"
                    "lit share <= (M2 - M1^2) / (M2 - M1^2 + (z - M1)^2)",
         .anchors = "moments-of-a-row"},
        {.id = "samples",
         .title = "Ask the light for every point that the eye sees",
         .why =
             "A map asks the light at the middles of its texels, and the eye at other places: all its faults come from "
             "that. Here the visible points themselves are put into the light's picture, and every triangle is tested "
             "against those it covers. Only with alias-free = true.",
         .glState = "none: on the processor, and the answers uploaded",
         .perLight = true,
         .shownBy = "eye-samples",
         .formula = "shadowed if a triangle covers (s, t) and is nearer to the light than r",
         .anchors = "samples-in-the-light"},
        {.id = "average",
         .title = "Draw and ask a map from each of many points of the light",
         .why =
             "A light with an area puts a point into shadow by degrees: as many as cannot be seen of its own points. "
             "Every map answers for one of them, and the mean of the answers is the visible share. Only with "
             "light-samples above 1.",
         .glState = "each map as in depth; visibility added up with blending CONSTANT_COLOR ONE",
         .perLight = true,
         .shownBy = "visibility",
         .formula = "visibility = sum over the points of the light of (answer of its map) / points",
         .anchors = "average-maps"},
        {.id = "decide",
         .title = "Decide where the map is certain, and send rays elsewhere",
         .why =
             "An edge that touches a texel makes it uncertain: a surface ends there, begins, or passes through "
             "another. "
             "All other texels know which surface is the first; the point is lit if it lies on that. Only with exact = "
             "true.",
         .glState = "depth EQUAL; triangle numbers and depths read with texelFetch; undecided pixels read back",
         .perLight = true,
         .shownBy = "traced",
         .anchors = "decide-by-map"},
        {.id = "light",
         .title = "Render the scene from the eye and compare",
         .why = "Transform each point into the light's coordinates; if the map holds something nearer, the point is in "
                "shadow.",
         .glState = "depth EQUAL, blending ONE ONE, map sampled with comparison LEQUAL",
         .perLight = true,
         .pseudocodeLines = {5, 10},
         .formula = "(s, t, r) = clip / w / 2 + 1/2\n"
                    "z(u,v) = r, shadowed if d(u,v) < z(u,v)",
         .anchors = lightAnchors},
    };
    return all;
}

} // namespace shadowlab::shadow_map
