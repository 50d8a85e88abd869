// From a scene to solved equations, a slice of time after the other: patches and their form factors, what is put into the equations, and
// their solution. While what a part depends on is equal, it is kept.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "techniques/radiosity/display/openings.h"
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/exchange/hemicube_exchange.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

/// Where a patch sees no surface, W/(m^2 sr).
dvec3 radianceOutside(const scene::Scene& scene, const RadiosityParams& params);

class Solution {
public:
    // To be called in this order. Each goes on until it is done (true) or the deadline has passed.

    /// Patches, and their form factors unless they are to be drawn. `eye`: for which patches are cut where they are cut anew; nothing: for none.
    bool advanceRoom(const scene::Snapshot& snapshot, const RadiosityParams& params, Deadline deadline, const std::optional<Eye>& eye = {});
    /// Would they be cut alike for this eye? After advanceRoom() has returned true.
    [[nodiscard]] bool isCutFor(const std::optional<Eye>& eye) { return cache_.isCutFor(eye); }
    /// Form factors by hemicubes. Needs the graphics card.
    bool advanceDrawnFormFactors(const RadiosityParams& params, Deadline deadline);
    /// Puts sources into the equations, if they are others than before.
    void restartIfChanged(const scene::Snapshot& snapshot, const RadiosityParams& params);
    /// True when the equations are solved, or parameter `steps` is reached. At most `most` steps (0: any number).
    bool advanceSolver(const RadiosityParams& params, std::size_t most, Deadline deadline);

    /// 0..1 of what the last of the first two that returned false has to do.
    [[nodiscard]] double done() const { return done_; }

    [[nodiscard]] const RoomCache& cache() const { return cache_; }
    /// The reflectance of a patch is that of what lamps do not cover.
    [[nodiscard]] const Sources& sources() const { return sources_; }
    [[nodiscard]] const Openings& openings() const { return openings_; }
    [[nodiscard]] const LightBalance& balance() const { return balance_; }

private:
    struct SolutionCacheKey {
        std::uint64_t room = 0;
        scene::Revisions revisions{0, 0, 0, 0};
        SolverKind solver = SolverKind::direct;
        double tolerance = 0;
        int steps = 0, stepsPerPicture = 0;
        bool ambientTerm = true, hasPathLight = false;
        RadiosityParams::Surroundings surroundings{};
        friend bool operator==(const SolutionCacheKey&, const SolutionCacheKey&) = default;
    };
    struct HemicubeCacheKey {
        std::uint64_t room = 0;
        int side = 0;
        friend bool operator==(const HemicubeCacheKey&, const HemicubeCacheKey&) = default;
    };
    RoomCache cache_;
    std::unique_ptr<HemicubeExchange> hemicubes_; ///< while form factors are being drawn
    HemicubeCacheKey hemicubesKey_;
    SolutionCacheKey solutionKey_;
    Sources sources_;
    Openings openings_; ///< of the room that `solutionKey_` names
    LightBalance balance_;
    double done_ = 0;
};

} // namespace shadowlab::radiosity
