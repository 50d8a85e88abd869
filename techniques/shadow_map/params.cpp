// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/params.h"

#include <algorithm>
#include <iterator>

#include "techniques/foundation/scene/query/light_points.h"

namespace shadowlab::shadow_map {

GLenum ShadowMapParams::glDepthFormat() const {
    return depthFormat == DepthFormat::fixed16   ? GL_DEPTH_COMPONENT16
           : depthFormat == DepthFormat::fixed24 ? GL_DEPTH_COMPONENT24
                                                 : GL_DEPTH_COMPONENT32F;
}

namespace {

// No driver has larger textures; one that has smaller ones says so when the map is made.
constexpr int kLargestMap = 32768;

params::ParamList describeMap(ShadowMapParams& p) {
    return {
        params::integer("resolution", p.resolution, 64, kLargestMap, "texels",
                        "Side of the square depth map; of each of four cascades, or of six when casters surround the "
                        "light. At most what the driver can do."),
        params::choice("depth-format", p.depthFormat, {"16", "24", "32f"},
                       "Bits of a depth in the map; 32f: as a floating-point number. The fewer, the larger the offset "
                       "against rounding has to be."),
    };
}

params::ParamList describeProjection(ProjectionParams& p) {
    using params::onlyIf;
    const auto hasCascades = [&p] { return p.cascades > 1; };
    return {
        params::choice("fit", p.fit, {"view", "scene"},
                       "view: maps hold what can shadow the receivers in view; scene: what can shadow anything, so "
                       "they stay as they are wherever the eye goes."),
        params::integer("cascades", p.cascades, 1, 4, "maps",
                        "Maps of a directional light, one behind the other along the view."),
        onlyIf(hasCascades,
               params::real(
                   "split-mix", p.splitMix, 0, 1, "",
                   "Where cascades meet: 0 uniform, 1 logarithmic in the distance from the eye, between: a mix.")),
        onlyIf(hasCascades,
               params::choice(
                   "depth-bounds", p.depthBounds, {"picture", "receivers", "camera"},
                   "Range that cascades share: of the depths in the picture; of the receivers' boxes in view; from "
                   "the camera's near plane to the scene's end.")),
        onlyIf(
            hasCascades,
            params::boolean("stable", p.stable,
                            "Cascades of constant size that move by whole texels; false: cut as close as can be, which "
                            "makes edges crawl when the eye moves (teaching).")),
        onlyIf(hasCascades,
               params::real("cascade-blend", p.cascadeBlend, 0, 0.5, "",
                            "Share of each cascade over which it fades into the next; 0 shows where they meet.")),
        params::choice("warp", p.warp, {"none", "lispsm"},
                       "Texels of a directional light: all alike; lispsm: smaller near the eye (light space "
                       "perspective)."),
    };
}

params::ParamList describeProjectionFaults(ProjectionParams& p) {
    return {
        params::choice("depth-range", p.depthRange, {"fitted", "wide"},
                       "Range of depths in the map: fitted to receivers; wide: 0.01 to 1000 m, as in a program that "
                       "never fits it (teaching)."),
        params::choice("cube-seams", p.cubeSeams, {"guarded", "bare"},
                       "The six maps around a light: each a little wider than its 90 degrees, so that a filter finds "
                       "its texels in its own map; bare: just as wide, and a filter at a seam reaches beyond the map, "
                       "where nothing is stored (teaching)."),
    };
}

params::ParamList describeCoordinates(ShadowMapParams& p) {
    return {
        params::choice("coordinates", p.coordinates, {"light", "world"},
                       "Points that are looked up count from the light; world: from the world's origin, as floats, "
                       "which a thousand kilometres away from it are centimetres apart (teaching)."),
    };
}

params::ParamList describeKernel(dvec2& at) {
    return {
        params::real("kernel-x", at.x, 0, 1, "", "Stage kernel: for which pixel, as a share of the picture's width."),
        params::real("kernel-y", at.y, 0, 1, "", "The same from the top, as a share of its height."),
    };
}

params::ParamList describeLimits(ShadowMapParams& p) {
    return {
        params::boolean("depth-clamp", p.depthClamp,
                        "Keep casters that stand nearer to the light than the map's near plane; false: they are cut "
                        "off, and with them their shadows (teaching)."),
        params::choice("border", p.border, {"lit", "edge"},
                       "What lies outside the map: lit; edge: as its outermost texels, which draws shadows out into "
                       "streaks (teaching)."),
        params::boolean(
            "reject-behind", p.rejectBehind,
            "Ask no map about what lies behind a spot; false: there the projection is mirrored (teaching)."),
    };
}

params::ParamList describeCull(ShadowMapParams& p) {
    return {
        params::boolean("cull", p.cull,
                        "Leave out casters that cannot shadow anything in a map, and what is out of view; the picture "
                        "is the same, but for a floor that would wrongly shadow itself."),
    };
}

} // namespace

params::ParamList describe(ShadowMapParams& p) {
    // How fine and how smooth; then what keeps surfaces lit, and where the light looks; what seldom changes is last.
    params::ParamList all = describeMap(p);
    const auto add = [&all](params::ParamList part) { std::ranges::move(part, std::back_inserter(all)); };
    add(describe(p.filter));
    add(scene::describe(p.lightPoints, "maps",
                        "Of a light with an area: so many maps, each from another point of it, and the mean of their "
                        "answers; 1: one from its centre."));
    add(describe(p.bias));
    add(describeProjection(p.projection));
    add(describeProjectionFaults(p.projection));
    add(describeLimits(p));
    add(describeCull(p));
    add(describeCoordinates(p));
    add(describeKernel(p.kernelAt));
    return all;
}

params::ParamList describeExact(ShadowMapParams& p) {
    params::ParamList all = describeMap(p);
    std::ranges::move(describeProjection(p.projection), std::back_inserter(all));
    std::ranges::move(describeCull(p), std::back_inserter(all));
    return all;
}

ShadowMapParams exactMapParams() {
    ShadowMapParams params;
    params.filter.kind = filterNamed("hard");
    return params;
}

} // namespace shadowlab::shadow_map
