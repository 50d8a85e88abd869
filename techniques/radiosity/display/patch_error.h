// What is left: by how much the picture may be wrong because patches have one value each.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

/// Keeps the errors of patches (errorsOfPatches() in room/refinement.h) while the solution stays, for where patches meet takes a while.
class PatchError {
public:
    /// As a share of the light, each patch weighted by how large it looks from the eye, whatever hides it. `ofReflectedLight`: pixels have
    /// the direct light by themselves, and only the rest is the patches'. The solution must be complete.
    double share(const RoomCache& cache, const Sources& sources, const LightBalance& balance, bool ofReflectedLight, const dvec3& eyeWorld);

private:
    struct PatchErrorCacheKey {
        std::uint64_t solution = 0;
        bool ofReflectedLight = false;
        friend bool operator==(const PatchErrorCacheKey&, const PatchErrorCacheKey&) = default;
    };
    PatchErrorCacheKey key_;
    std::vector<double> errors_; ///< of each patch, W/m^2
};

} // namespace shadowlab::radiosity
