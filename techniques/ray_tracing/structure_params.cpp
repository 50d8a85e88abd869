// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/structure_params.h"

namespace shadowlab::ray_tracing {

params::ParamList describe(StructureParams& p) {
    return {params::choice(
        "structure", p.structure,
        {"none", "object-spheres", "object-boxes", "groups", "sphere-tree", "bvh", "grid", "embree"},
        "What spares a ray most of the triangles: nothing; a sphere or a box around each object; boxes around groups "
        "of "
        "objects and around each of them; a tree of spheres; a tree of boxes; a grid of equal cells; Embree, where the "
        "program was built with it (else bvh). The picture is the same, only the time differs.")};
}

} // namespace shadowlab::ray_tracing
