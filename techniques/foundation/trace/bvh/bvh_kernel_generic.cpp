// The way through the tree for any processor, and the choice of the best for this one.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/bvh/bvh_kernel.h"

namespace shadowlab::trace {

const BvhKernels kGenericBvhKernels{"generic", touchedBoxes, nextCandidates<true>, nextCandidates<false>};

const BvhKernels& bestBvhKernels() {
    static const BvhKernels& best = avx2BvhKernels() ? *avx2BvhKernels() : kGenericBvhKernels;
    return best;
}

} // namespace shadowlab::trace
