// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/volume_params.h"

namespace shadowlab::shadow_volume {

namespace {

constexpr std::string_view kVolumes = "Volumes";

} // namespace

params::ParamList describe(VolumeParams& params) {
    using params::inGroup, params::onlyIf;
    using End = VolumeParams::End;
    return {
        params::boolean(
            {"two-sided", "Count in one pass"}, params.twoSided,
            "Count front and back faces in one pass; false: in the lecture's two passes, one after the other."),
        inGroup(params::kExpert, params::boolean({"cull", "Cull volumes"}, params.cull,
                                                 "Leave out what is out of view, and volumes in which nothing visible "
                                                 "lies: saves time, the picture is the same.")),
        inGroup(kVolumes,
                params::choice({"construction", "Construction"}, params.construction,
                               {{"general", "any triangles"}, {"lecture", "closed meshes"}},
                               "How volumes are built: of any triangles; or as in the lecture, of front faces, pushed "
                               "back faces and quads at silhouette edges, which needs closed meshes.")),
        params::choice(
            {"volume-end", "End of volumes"}, params.end,
            {{"receivers", "beyond all receivers"}, "infinity", {"distance", "after the extrusion distance"}},
            "How far vertices are pushed away from the light: beyond all receivers, to infinity, or by the extrusion "
            "distance."),
        onlyIf([&params] { return params.end == End::distance; },
               params::real(
                   {"extrusion", "Extrusion distance d"}, params.extrusion, 0.001, 100000, "m",
                   "With volume-end distance: how far vertices are pushed. Too short, and shadows end in the air.")),
        inGroup(params::kExpert,
                params::choice({"extrude-on", "Extrusion on"}, params.extrudeOn,
                               {{"vertex-shader", "GPU, vertex shader"}, {"cpu", "CPU"}},
                               "What pushes the vertices away from the light: the pixels are the same.")),
        inGroup(kVolumes, params::choice({"counter", "Counter"}, params.counter,
                                         {{"auto", "stencil, float where needed"},
                                          {"stencil", "stencil, 8 bits"},
                                          {"float", "float buffer"}},
                                         "What counts: the stencil, up to 255 volumes around a point; a float buffer, "
                                         "any number; auto: floats only where more could overlap.")),
        inGroup(params::kTeachingSwitches,
                params::boolean(
                    {"wrap", "Wrap around"}, params.stencil.wrap,
                    "The stencil wraps around at its ends; false: it sticks there, and counts get lost (teaching).")),
        inGroup(
            params::kTeachingSwitches,
            params::integer(
                "stencil-bits", params.stencil.bits, 1, 8, "bits",
                "Bits of the stencil that count: of n bits, 2^n volumes around a point look like none (teaching).")),
        params::boolean({"repair", "Repair by rays"}, params.repair,
                        "Decide pixels again by shadow rays where the rasteriser may have miscounted: those that "
                        "differ from a neighbour, or that a silhouette edge touches."),
    };
}

} // namespace shadowlab::shadow_volume
