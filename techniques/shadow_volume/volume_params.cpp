// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/volume_params.h"

namespace shadowlab::shadow_volume {

params::ParamList describe(VolumeParams& params) {
    return {
        params::boolean("two-sided", params.twoSided,
                        "Count back and front faces in one pass; false: the lecture's two steps, one after the other."),
        params::boolean("cull", params.cull,
                        "Skip what is out of view, and volumes that cannot reach it or in which nothing lies; the "
                        "picture is the same."),
        params::choice(
            "construction", params.construction, {"general", "lecture"},
            "How volumes are built: for any triangles; or the lecture's way, front faces, pushed back faces and "
            "quads at the edges between them, which needs closed meshes."),
        params::choice("volume-end", params.end, {"receivers", "infinity", "distance"},
                       "Where volumes end: beyond all that can receive a shadow, at infinity, or at `extrusion`."),
        params::real("extrusion", params.extrusion, 0.001, 100000, "m",
                     "The lecture's d, with volume-end = distance: how far vertices are pushed. Too short, and shadows "
                     "end in the air."),
        params::choice("extrude-on", params.extrudeOn, {"vertex-shader", "cpu"},
                       "Who pushes the vertices away from the light: the pixels are the same."),
        params::choice("counter", params.counter, {"auto", "stencil", "float"},
                       "What counts: the stencil, up to 255 volumes around a point; floats, without end; auto: floats "
                       "where more could overlap."),
        params::boolean("wrap", params.stencil.wrap,
                        "Let the stencil wrap around; false: it sticks at its ends, and counts get lost (teaching)."),
        params::integer(
            "stencil-bits", params.stencil.bits, 1, 8, "bits",
            "Bits of the stencil that count: of n bits, 2^n volumes around a point look like none (teaching)."),
        params::boolean(
            "repair", params.repair,
            "Decide again with rays, on the processor, where the rasteriser may have miscounted: pixels that "
            "differ from a neighbour, or that a silhouette edge touches."),
    };
}

} // namespace shadowlab::shadow_volume
