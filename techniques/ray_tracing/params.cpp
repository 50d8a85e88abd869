// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/params.h"

namespace shadowlab::ray_tracing {

namespace {

// The rays of a tree may double with every level: at this depth there are up to 2^17, for one pixel.
constexpr int kMostDepth = 16;

// Names of the groups.
constexpr std::string_view kRayTree = "Ray tree", kAttenuation = "Attenuation with distance",
                           kDistributed = "Distributed rays";

} // namespace

params::ParamList describe(RayTracedParams& p) {
    using params::inGroup, params::onlyIf;
    const auto hasTrees = [&p] { return p.depth > 0; };
    return {
        inGroup(params::kTeachingSwitches,
                params::boolean({"exclude-source", "Leave out the ray's own triangle"}, p.excludeSource,
                                "A shadow ray ignores the triangle that it starts on; false: it starts at a point "
                                "rounded to float, and hits that triangle now and then (teaching).")),
        inGroup(params::kExpert,
                params::choice(
                    {"receivers", "Visible triangle from"}, p.receivers,
                    {{"traced", "eye rays"}, {"id-buffer", "the rasteriser"}},
                    "How the triangle of a pixel is found: by its eye ray; or drawn by the rasteriser, and traced only "
                    "where the ray does not hit it. At ties (docs/conventions.md) the two may differ.")),
        params::integer({"depth", "Maximum depth of the ray tree"}, p.depth, 0, kMostDepth, "levels",
                        "Levels of reflection and refraction rays below the eye ray; a ray beyond them has the "
                        "background's intensity. 0: mirrors and glass are shown as other techniques show them."),
        onlyIf(hasTrees, inGroup(kRayTree, params::real({"cutoff", "Smallest contribution"}, p.cutoff, 0, 1, "",
                                                        "A ray that would add a smaller share to the pixel is not "
                                                        "followed; 0: all are, down to the maximum depth."))),
        onlyIf(hasTrees,
               inGroup(kRayTree, params::choice({"fresnel", "Fresnel term"}, p.fresnel,
                                                {{"exact", "Fresnel's formulas"},
                                                 {"schlick", "Schlick's approximation"},
                                                 {"constant", "constant k_r and k_t"}},
                                                "How glass shares out light between reflection and refraction ray: by "
                                                "the angle, or with constant coefficients as in the lecture."))),
        inGroup(kAttenuation, params::real({"c0", "c0, constant term"}, p.attenuation.x, 0.001, 1000, "",
                                           "After d metres the share 1 / (c0 + c1 d + c2 d^2) of a ray's intensity is "
                                           "left; with c0 = 1 and c1 = c2 = 0 all of it.")),
        inGroup(kAttenuation,
                params::real({"c1", "c1, linear term"}, p.attenuation.y, 0, 1000, "1/m",
                             "c1 in 1 / (c0 + c1 d + c2 d^2), the share of a ray's intensity left after d metres.")),
        inGroup(kAttenuation,
                params::real({"c2", "c2, quadratic term"}, p.attenuation.z, 0, 1000, "1/m^2",
                             "c2 in 1 / (c0 + c1 d + c2 d^2), the share of a ray's intensity left after d metres.")),
    };
}

params::ParamList describe(StructureParams& p) {
    using params::inGroup;
    using enum StructureParams::Intersection;
    const auto isNaive = [&p] { return p.intersection == naive; };
    return {
        params::choice({"structure", "Acceleration structure"}, p.structure,
                       {{"none", "all triangles tested"},
                        {"object-spheres", "sphere around each object"},
                        {"object-boxes", "box around each object"},
                        {"groups", "boxes around groups"},
                        {"sphere-tree", "tree of spheres"},
                        {"bvh", "tree of boxes (BVH)"},
                        {"grid", "uniform grid"},
                        {"embree", "Embree"}},
                       "What spares a ray the test with most triangles. The picture is the same, only the time "
                       "differs. Embree: where the program was built with it, else the tree of boxes."),
        inGroup(params::kTeachingSwitches,
                params::choice({"intersection", "Intersection test"}, p.intersection,
                               {"watertight", {"naive", "naive, in float"}},
                               "Watertight: no ray slips through the edge between two triangles; naive: as it is often "
                               "written, so that rays are missed there (teaching; always with the tree of boxes).")),
        params::onlyIf(isNaive, inGroup(params::kTeachingSwitches,
                                        params::real({"edge-margin", "Edge margin"}, p.edgeMargin, 0, 0.1, "",
                                                     "Intersection naive: how far inside its edges a triangle has to "
                                                     "be hit, as a share of its height; 0: rounding alone decides."))),
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
    settings.tree.roulette = roulette;
    return settings;
}

params::ParamList describe(SamplingParams& p) {
    using params::inGroup, params::onlyIf;
    const auto areMany = [&p] { return p.areMany(); };
    params::ParamList all = {
        params::integer({"samples", "Samples per pixel"}, p.pattern.count, 1, kMostSamples, "rays",
                        "Rays through each pixel, of which it is the mean; they are spread over pixel, lights, lens, "
                        "lobes and time. 1: one ray through the pixel's centre, to the centre of each light."),
        params::choice(
            "soft-shadows", p.softShadows,
            {{"sampled", "shadow rays to the area"}, {"analytic", "closed form"}, {"off", "light's centre only"}},
            "Shadow of a light with an area: shadow rays are spread over it, with more than one sample; or all of it "
            "at once in closed form, right to a millionth; or one ray to its centre."),
    };
    params::ParamList spread = {
        inGroup(kDistributed,
                params::choice({"pattern", "Sample pattern"}, p.pattern.spread,
                               {"jittered", "regular", "random", {"low-discrepancy", "low discrepancy (Sobol)"}},
                               "Jittered: one sample at random in each of as many equal cells; regular: in the middle "
                               "of each cell; random: anywhere; low discrepancy: scrambled Sobol' points.")),
        onlyIf([&p] { return p.pattern.spread == SamplePattern::Spread::jittered; },
               inGroup(kDistributed,
                       params::real("jitter", p.pattern.jitter, 0, 1, "",
                                    "How far from the middle of its cell a sample may lie, as a share of what the cell "
                                    "allows; 0: as regular, but in another order in each pixel."))),
        inGroup(kDistributed, params::integer({"seed", "Random seed"}, p.pattern.seed, 0, 1000000, "",
                                              "Start of the random numbers: another seed, other noise.")),
        inGroup(kDistributed,
                params::boolean({"antialias", "Antialiasing"}, p.antialias,
                                "Spread rays over their pixel: smooth edges; false: all go through its centre.")),
        inGroup(kDistributed,
                params::boolean({"gloss", "Glossy reflection"}, p.gloss,
                                "Spread reflection rays by the material's glossDegrees; false: perfect mirrors.")),
        inGroup(kDistributed,
                params::boolean({"translucency", "Translucent refraction"}, p.translucency,
                                "Spread refraction rays by the material's translucencyDegrees; false: clear glass.")),
        params::real({"aperture", "Aperture of the lens"}, p.aperture, 0, 10, "m",
                     "Diameter of the lens: what is out of focus is blurred. 0: a pinhole, all is sharp."),
        onlyIf([&p] { return p.aperture > 0; },
               inGroup(kDistributed,
                       params::real(
                           {"focus", "Focus distance"}, p.focus, 0, 1e6, "m",
                           "Distance of the plane in focus along the camera's axis; 0: that of the camera's target."))),
        inGroup(kDistributed, params::real({"shutter", "Shutter time"}, p.shutter, 0, 1000, "units of time",
                                           "How long the shutter is open: objects with a velocity are blurred along "
                                           "their way. 0: they stand still.")),
        inGroup(params::kTeachingSwitches,
                params::boolean(
                    {"whole-lobes", "Redraw lost directions"}, p.wholeLobes,
                    "Draw a direction of gloss or translucency again if it lies on the wrong side of the surface; "
                    "false: its light is lost, and surfaces look too dark at grazing angles (teaching).")),
        inGroup(kRayTree, params::boolean({"interreflection", "Diffuse interreflection"}, p.interreflection,
                                          "Diffuse surfaces send on a ray as well, in place of ambient light: path "
                                          "tracing (Kajiya 1986).")),
        onlyIf([&p] { return p.interreflection; },
               inGroup(params::kTeachingSwitches,
                       params::boolean({"roulette", "Russian roulette"}, p.roulette,
                                       "Path tracing: chance ends a path, and what goes on counts for as much more, so "
                                       "that no light is lost on average (Arvo and Kirk 1990); false: it ends at the "
                                       "maximum depth, and what would follow is lost (teaching)."))),
        inGroup(kDistributed, params::boolean({"adaptive", "Adaptive sampling"}, p.adaptive,
                                              "Pixels whose error is within the tolerance, with their neighbours, get "
                                              "no more rays; tested after every 16.")),
        onlyIf([&p] { return p.adaptive; },
               inGroup(kDistributed,
                       params::real("tolerance", p.tolerance, 0.01, 64, "8-bit steps",
                                    "Adaptive sampling: largest standard error of the pixel's grey, as it is shown."))),
    };
    for (params::Param& param : spread)
        all.push_back(onlyIf(areMany, std::move(param)));
    return all;
}

} // namespace shadowlab::ray_tracing
