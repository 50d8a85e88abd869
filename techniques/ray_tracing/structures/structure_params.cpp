// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/structures/structure_params.h"

namespace shadowlab::ray_tracing {

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

} // namespace shadowlab::ray_tracing
