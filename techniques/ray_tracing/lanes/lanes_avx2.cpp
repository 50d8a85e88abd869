// Pixels in lanes for processors with AVX2 (Intel since 2013, AMD since 2015). The build compiles this file for them; it is called
// only if the processor reports AVX2.
// SPDX-License-Identifier: MIT
#if defined(__AVX2__)
#include "techniques/ray_tracing/lanes/lane_kernel.h"
#else
#include "techniques/ray_tracing/lanes/pixel_lanes.h"
#endif

namespace shadowlab::ray_tracing {

const LaneKernels* avx2LaneKernels() {
#if defined(__AVX2__)
    static const LaneKernels kernels{"AVX2", turnToEye, aim, addDiffuse, halfway, encode};
    return __builtin_cpu_supports("avx2") ? &kernels : nullptr;
#else
    return nullptr;
#endif
}

} // namespace shadowlab::ray_tracing
