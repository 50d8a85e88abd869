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

// Names of the groups; the filters and the biases have theirs.
constexpr std::string_view kFit = "Fit", kCube = "Cube";

params::ParamList describeMap(ShadowMapParams& p) {
    using params::inGroup;
    return {
        params::integer({"resolution", "Map resolution"}, p.resolution, 64, kLargestMap, "texels",
                        "Side of the square depth map; of each of up to four cascades, or of the six maps around a "
                        "light. At most what the graphics driver can hold."),
        inGroup(params::kExpert,
                params::choice(
                    "depth-format", p.depthFormat, {{"16", "16 bits"}, {"24", "24 bits"}, {"32f", "32-bit float"}},
                    "Bits of a depth in the map: the fewer, the larger the bias against rounding has to be.")),
    };
}

params::ParamList describeProjection(ProjectionParams& p) {
    using params::onlyIf;
    const auto hasCascades = [&p] { return p.cascades > 1; };
    return params::inGroup(
        kFit,
        {
            params::choice({"fit", "Fit of the map"}, p.fit,
                           {{"view", "what is in view"}, {"scene", "the whole scene"}},
                           "What the map covers: all that can shadow the receivers in view; or the whole scene, so "
                           "that it stays the same wherever the eye goes."),
            params::integer(
                "cascades", p.cascades, 1, 4, "maps",
                "Maps of a directional light, one behind the other along the view: the near ones have smaller texels."),
            onlyIf(hasCascades,
                   params::real(
                       {"split-mix", "Split scheme"}, p.splitMix, 0, 1, "",
                       "Where cascades meet: 0 uniform in the distance from the eye, 1 logarithmic, between: a mix.")),
            onlyIf(hasCascades,
                   params::choice({"depth-bounds", "Depth range of cascades"}, p.depthBounds,
                                  {{"picture", "depths in the picture"},
                                   {"receivers", "boxes of the receivers"},
                                   {"camera", "camera to end of scene"}},
                                  "Range of distances that the cascades share: from the depths in the picture; from "
                                  "the boxes of the receivers in view; from the near plane to the scene's end.")),
            onlyIf(hasCascades,
                   params::boolean({"stable", "Stable cascades"}, p.stable,
                                   "Cascades keep their size and move by whole texels; false: they are cut as close as "
                                   "can be, and shadow edges crawl when the eye moves (teaching).")),
            onlyIf(hasCascades,
                   params::real({"cascade-blend", "Cascade blending"}, p.cascadeBlend, 0, 0.5, "",
                                "Share of each cascade over which it fades into the next; 0 shows where they meet.")),
            params::choice({"warp", "Perspective warp"}, p.warp, {"none", {"lispsm", "light space perspective"}},
                           "Map of a directional light: texels of one size; or smaller texels near the eye (light "
                           "space perspective shadow map)."),
        });
}

params::ParamList describeProjectionFaults(ProjectionParams& p) {
    using params::inGroup;
    return {
        inGroup(params::kTeachingSwitches,
                params::choice({"depth-range", "Depth range of the map"}, p.depthRange,
                               {{"fitted", "fitted to receivers"}, {"wide", "0.01 to 1000 m"}},
                               "Depths that the map's bits are shared among: fitted to the receivers; or 0.01 to 1000 "
                               "m, as in a program that never fits them (teaching).")),
        inGroup(kCube,
                params::choice(
                    {"cube-seams", "Seams of the cube map"}, p.cubeSeams,
                    {{"guarded", "maps overlap"}, {"bare", "90 degrees each"}},
                    "The six maps around a light: a little wider than 90 degrees, so that a filter finds its texels in "
                    "one map; or just 90, where a filter at a seam reads outside of the map (teaching).")),
    };
}

params::ParamList describeCoordinates(ShadowMapParams& p) {
    return {
        params::inGroup(params::kTeachingSwitches,
                        params::choice({"coordinates", "Lookup coordinates"}, p.coordinates,
                                       {{"light", "relative to the light"}, {"world", "world space"}},
                                       "Points are looked up relative to the light; or in world space as floats, which "
                                       "are centimetres apart a thousand kilometres from the origin (teaching)."))};
}

params::ParamList describeKernel(dvec2& at) {
    return params::inGroup(
        params::kExpert,
        {
            params::real({"kernel-x", "Kernel shown at x"}, at.x, 0, 1, "",
                         "Stage kernel: the pixel whose filter kernel is drawn, as a share of the picture's width from "
                         "the left."),
            params::real({"kernel-y", "Kernel shown at y"}, at.y, 0, 1, "",
                         "Stage kernel: the same pixel, as a share of the picture's height from the top."),
        });
}

params::ParamList describeLimits(ShadowMapParams& p) {
    return params::inGroup(
        params::kTeachingSwitches,
        {
            params::boolean("depth-clamp", p.depthClamp,
                            "Keep casters that are nearer to the light than the map's near plane; false: they are "
                            "clipped, and their shadows with them (teaching)."),
            params::choice({"border", "Outside the map"}, p.border, {"lit", {"edge", "outermost texel"}},
                           "Visibility of points outside of the map: lit; or that of the outermost texel, which draws "
                           "shadows out into streaks (teaching)."),
            params::boolean({"reject-behind", "Reject points behind a spot"}, p.rejectBehind,
                            "Look up no point behind a spot; false: the projection is mirrored there, and so are "
                            "shadows (teaching)."),
        });
}

params::ParamList describeCull(ShadowMapParams& p) {
    return {params::inGroup(
        params::kExpert,
        params::boolean({"cull", "Cull casters"}, p.cull,
                        "Leave out casters that cannot shadow anything in a map, and what is out of view: saves time. "
                        "The picture is the same, but for a floor that would wrongly shadow itself."))};
}

} // namespace

params::ParamList describe(ShadowMapParams& p) {
    // How fine and how smooth; then what keeps surfaces lit, and where the light looks; what seldom changes is last.
    params::ParamList all = describeMap(p);
    const auto add = [&all](params::ParamList part) { std::ranges::move(part, std::back_inserter(all)); };
    add(describe(p.filter));
    add(scene::describe(p.lightPoints, "maps",
                        "Maps of a light with an area, each from another point of it; the visibility is the mean of "
                        "their answers. 1: one map from its centre."));
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
