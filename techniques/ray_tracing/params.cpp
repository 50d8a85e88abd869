// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/params.h"

namespace shadowlab::ray_tracing {

namespace {

// A tree doubles with every level: at this one it has up to 2^17 rays, for one pixel.
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

} // namespace shadowlab::ray_tracing
