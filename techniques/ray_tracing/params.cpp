// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/params.h"

namespace shadowlab::ray_tracing {

namespace {

// The rays of a tree may double with every level: at this depth there are up to 2^17, for one pixel.
constexpr int kMostDepth = 16;

} // namespace

params::ParamList describe(RayTracedParams& p) {
    const auto hasTrees = [&p] { return p.depth > 0; };
    return {
        params::boolean("exclude-source", p.excludeSource,
                        "A shadow ray leaves out the triangle it starts on; false: it starts from a point rounded "
                        "to float, and meets that triangle every now and then (teaching)."),
        params::choice("receivers", p.receivers, {"traced", "id-buffer"},
                       "How the triangle of a pixel is found: by its eye ray; or drawn by the rasteriser, and traced "
                       "only where the ray does not hit that triangle. At ties (docs/conventions.md) the two may "
                       "differ."),
        params::integer("depth", p.depth, 0, kMostDepth, "levels",
                        "Levels of reflection and refraction rays below the eye ray; a ray beyond them has the "
                        "background's intensity. 0: mirrors and glass are shown as other techniques show them."),
        params::onlyIf(
            hasTrees,
            params::real("cutoff", p.cutoff, 0, 1, "",
                         "A ray that would add no larger share to the pixel is not followed; 0: all are, down "
                         "to depth.")),
        params::onlyIf(
            hasTrees,
            params::choice("fresnel", p.fresnel, {"exact", "schlick", "constant"},
                           "How glass shares out light between its two rays: as Fresnel's formulas say for "
                           "the angle; by Schlick's polynomial; by the material's coefficients at every angle, "
                           "as in the lecture.")),
        params::real("c0", p.attenuation.x, 0.001, 1000, "",
                     "After d metres 1 / (c0 + c1 d + c2 d^2) of a ray's intensity is left; 1 with c1 = c2 = 0: all of "
                     "it."),
        params::real("c1", p.attenuation.y, 0, 1000, "1/m", "See c0."),
        params::real("c2", p.attenuation.z, 0, 1000, "1/m^2", "See c0."),
    };
}

params::ParamList describe(StructureParams& p) {
    using enum StructureParams::Intersection;
    const auto isNaive = [&p] { return p.intersection == naive; };
    return {
        params::choice("structure", p.structure,
                       {"none", "object-spheres", "object-boxes", "groups", "sphere-tree", "bvh", "grid", "embree"},
                       "What spares a ray most of the triangles: nothing; a sphere or a box around each object; boxes "
                       "around groups of objects and around each of them; a tree of spheres; a tree of boxes; a grid "
                       "of equal cells; Embree, where the program was built with it (else bvh). The picture is the "
                       "same, only the time differs."),
        params::choice("intersection", p.intersection, {"watertight", "naive"},
                       "Does a ray hit a triangle? watertight: through an edge that two triangles share no ray slips; "
                       "naive: as it is often written, in float, so that rays are missed there (teaching; asks the "
                       "tree of boxes, whatever the structure)."),
        params::onlyIf(isNaive,
                       params::real("edge-margin", p.edgeMargin, 0, 0.1, "",
                                    "intersection naive: how far inside its edges a triangle has to be hit, as a share "
                                    "of its height; 0: rounding alone decides.")),
    };
}

namespace {

// The error of evenly distributed samples falls as N^(-3/4): with so many it is a thousandth of that of one.
constexpr int kMostSamples = 16384;

} // namespace

SampledSettings SamplingParams::settings(const TreeSettings& tree, const scene::Camera& camera) const {
    SampledSettings settings;
    settings.pattern = pattern;
    settings.antialias = antialias;
    settings.aperture = aperture;
    // The distance to the camera's target, which lies on its axis.
    settings.focus = focus > 0 ? focus : glm::length(camera.targetWorld - camera.positionWorld);
    settings.shutter = shutter;
    settings.adaptive = adaptive;
    settings.tolerance = tolerance;
    settings.tree = tree;
    settings.tree.areaLights = isAnalytic()                          ? AreaLights::analytic
                               : softShadows == SoftShadows::sampled ? AreaLights::sampled
                                                                     : AreaLights::centre;
    settings.tree.gloss = gloss;
    settings.tree.translucency = translucency;
    settings.tree.wholeLobes = wholeLobes;
    settings.tree.interreflection = interreflection;
    return settings;
}

params::ParamList describe(SamplingParams& p) {
    using params::onlyIf;
    const auto areMany = [&p] { return p.areMany(); };
    params::ParamList all = {params::integer(
        "samples", p.pattern.count, 1, kMostSamples, "rays",
        "Rays through each pixel, and what they are spread over stands below; the pixel is their mean. 1: one ray "
        "through its middle, to the middle of each light, at time 0, by perfect mirrors.")};
    all.push_back(
        params::choice("soft-shadows", p.softShadows, {"sampled", "analytic", "off"},
                       "Of lights that have an area: shadow rays are spread over it, with more than one sample; or all "
                       "of it at once in "
                       "closed form, right to a millionth with any number of samples; or one ray to its middle."));
    params::ParamList spread = {
        params::choice(
            "pattern", p.pattern.spread, {"jittered", "regular", "random", "low-discrepancy"},
            "How chance is spread: one sample in each of as many equal cells; in the middle of each cell, in "
            "every pixel alike; anywhere; scrambled Sobol' points, evenly spread however many are used."),
        onlyIf([&p] { return p.pattern.spread == SamplePattern::Spread::jittered; },
               params::real("jitter", p.pattern.jitter, 0, 1, "",
                            "How far from the middle of its cell a sample may lie, as a share of what the cell "
                            "allows; 0: as regular, but in another order in each pixel.")),
        params::integer("seed", p.pattern.seed, 0, 1000000, "", "Another number, another choice by chance."),
        params::boolean("antialias", p.antialias,
                        "Rays are spread over their pixel: smooth edges; false: all go through its middle."),
        params::boolean("gloss", p.gloss,
                        "Reflection rays are spread by the material's glossDegrees; false: perfect mirrors."),
        params::boolean("translucency", p.translucency,
                        "Refraction rays are spread by the material's translucencyDegrees; false: clear glass."),
        params::real("aperture", p.aperture, 0, 10, "m",
                     "Diameter of the lens; what is out of focus is blurred. 0: a pinhole, all is sharp."),
        onlyIf([&p] { return p.aperture > 0; },
               params::real("focus", p.focus, 0, 1e6, "m",
                            "How far away the plane in focus is, along the camera's axis; 0: at the camera's target.")),
        params::real("shutter", p.shutter, 0, 1000, "units of time",
                     "How long the shutter is open: objects with a velocity are blurred along the way that they go "
                     "meanwhile. 0: they stand still."),
        params::boolean(
            "whole-lobes", p.wholeLobes,
            "A direction of gloss or translucency that lies on the wrong side of the surface is drawn again; "
            "false: its light is lost, and surfaces look too dark at grazing angles (teaching)."),
        params::boolean("interreflection", p.interreflection,
                        "Diffuse surfaces send a ray on as well, in place of ambient light: what they receive of "
                        "each other (Kajiya 1986), down to depth."),
        params::boolean(
            "adaptive", p.adaptive,
            "Pixels that are known well enough, with their neighbours, get no more rays; asked after every 16."),
        onlyIf([&p] { return p.adaptive; },
               params::real("tolerance", p.tolerance, 0.01, 64, "8-bit steps",
                            "Well enough: the standard error of the pixel's grey, as it is shown.")),
    };
    for (params::Param& param : spread)
        all.push_back(onlyIf(areMany, std::move(param)));
    return all;
}

} // namespace shadowlab::ray_tracing
