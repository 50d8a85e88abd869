// Which structure spares the rays their work, and which test says whether they hit a triangle.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/trace/structures/engine.h"

namespace shadowlab::ray_tracing {

struct StructureParams {
    trace::Structure structure = trace::Structure::bvh;
    enum class Intersection { watertight, naive } intersection = Intersection::watertight;
    double edgeMargin = 0.0;
    friend bool operator==(const StructureParams&, const StructureParams&) = default;
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(StructureParams& params);

} // namespace shadowlab::ray_tracing
