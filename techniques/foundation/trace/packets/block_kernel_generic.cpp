// Blocks of rays for any processor, and the choice of the best for this one.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/packets/block_aim.h"
#include "techniques/foundation/trace/packets/block_kernel.h"

namespace shadowlab::trace {

const BlockKernels kGenericBlockKernels{"generic", aimFan,      nearestHits, land,
                                        positions, aimAtPoints, part,        blockedRays};

const BlockKernels& bestBlockKernels() {
    static const BlockKernels& best = avx2BlockKernels() ? *avx2BlockKernels() : kGenericBlockKernels;
    return best;
}

} // namespace shadowlab::trace
