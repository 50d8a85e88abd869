// Blocks of rays for processors with AVX2 (Intel since 2013, AMD since 2015). The build compiles this file for them; it
// includes no code shared with other files, and is called only if the processor reports AVX2.
// SPDX-License-Identifier: MIT
#if defined(__AVX2__)
#include "techniques/foundation/trace/packets/block_aim.h"
#include "techniques/foundation/trace/packets/block_kernel.h"
#else
#include "techniques/foundation/trace/packets/block_rays.h"
#endif

namespace shadowlab::trace {

const BlockKernels* avx2BlockKernels() {
#if defined(__AVX2__)
    static const BlockKernels kernels{"AVX2", aimFan, nearestHits, land, positions, aimAtPoints, part, blockedRays};
    return __builtin_cpu_supports("avx2") ? &kernels : nullptr;
#else
    return nullptr;
#endif
}

} // namespace shadowlab::trace
