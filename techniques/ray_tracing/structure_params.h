// Which structure spares the rays their work.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/trace/engine.h"

namespace shadowlab::ray_tracing {

struct StructureParams {
    trace::Structure structure = trace::Structure::bvh;
    friend bool operator==(const StructureParams&, const StructureParams&) = default;
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(StructureParams& params);

} // namespace shadowlab::ray_tracing
