// The way through the tree for processors with AVX2 (see block_kernel_avx2.cpp).
// SPDX-License-Identifier: MIT
#if defined(__AVX2__)
#include "techniques/foundation/trace/bvh/bvh_kernel.h"
#else
#include "techniques/foundation/trace/bvh/bvh_walk.h"
#endif

namespace shadowlab::trace {

const BvhKernels* avx2BvhKernels() {
#if defined(__AVX2__)
    static const BvhKernels kernels{"AVX2", touchedBoxes, nextCandidates<true>, nextCandidates<false>};
    return __builtin_cpu_supports("avx2") ? &kernels : nullptr;
#else
    return nullptr;
#endif
}

} // namespace shadowlab::trace
