// Pixels in lanes for any processor, and the choice of the best for this one.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/lanes/lane_kernel.h"

namespace shadowlab::ray_tracing {

const LaneKernels kGenericLaneKernels{"generic", turnToEye, aim, addDiffuse, halfway, encode};

const LaneKernels& bestLaneKernels() {
    static const LaneKernels& best = avx2LaneKernels() ? *avx2LaneKernels() : kGenericLaneKernels;
    return best;
}

} // namespace shadowlab::ray_tracing
