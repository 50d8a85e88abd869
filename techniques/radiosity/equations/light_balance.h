// The part of radiosity that depends on brightness: what patches emit and reflect, what arrives from lights and surroundings, and
// the solution of the equations.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "techniques/radiosity/equations/bounces.h"
#include "techniques/radiosity/exchange/prepared_exchange.h"
#include "techniques/radiosity/lights/direct_light.h"
#include "techniques/radiosity/lights/path_light.h"
#include "techniques/radiosity/room/room.h"
#include "techniques/radiosity/solvers/solvers.h"

namespace shadowlab::radiosity {

/// For every patch: first those that exchange light, then the loose ones, which see no other.
struct Sources {
    std::vector<dvec3> emission;    ///< E_i, W/m^2: what its surface emits, times Room::areaFactor()
    std::vector<dvec3> reflectance; ///< rho_i
    std::vector<dvec3> fromLights;  ///< direct irradiance by lights, W/m^2
    std::vector<dvec3> fromOutside; ///< irradiance by the surroundings, where a patch sees no surface, W/m^2
    /// Irradiance by light of emitters that is followed along paths (lights/path_light.h), W/m^2; empty: all emitters are in the equations.
    std::vector<dvec3> byPaths;
    std::vector<std::uint8_t> isFollowed;  ///< Followed::patches, and 0 for loose ones; empty as well
    std::vector<dvec3> fromFollowedLights; ///< that part of fromLights, W/m^2; empty as well
    [[nodiscard]] std::size_t size() const { return emission.size(); }
    /// Irradiance that comes from no patch, W/m^2.
    [[nodiscard]] dvec3 irradiance(std::size_t i) const { return fromLights[i] + fromOutside[i]; }
    /// Radiosity without interreflection, W/m^2: the constant term of the equations.
    [[nodiscard]] dvec3 first(std::size_t i) const {
        if (byPaths.empty()) return emission[i] + reflectance[i] * irradiance(i);
        if (isFollowed[i] != 0) return reflectance[i] * (irradiance(i) - fromFollowedLights[i]);
        return emission[i] + reflectance[i] * (irradiance(i) + byPaths[i]);
    }
    /// What a patch sends of the light that is followed, and so is not in the equations, W/m^2.
    [[nodiscard]] dvec3 apart(std::size_t i) const {
        return byPaths.empty() || isFollowed[i] == 0 ? dvec3(0) : emission[i] + reflectance[i] * (byPaths[i] + fromFollowedLights[i]);
    }
};

/// `lights`: the irradiance of every patch by each light. `surroundings`: radiance where a patch sees no surface.
Sources sourcesOf(const Room& room, std::span<const DirectLight* const> lights, const dvec3& surroundings);

/// Takes light that is followed out of the equations: it is irradiance from then on. `pathLight`: what PathLightBuilder has found.
void takeApart(Sources& sources, const Room& room, const PreparedExchange& exchange, std::span<const DirectLight* const> lights, const Followed& followed,
               std::span<const dvec3> pathLight);

/// The radiosity of every patch, solved step by step.
class LightBalance {
public:
    /// Starts from the beginning. Throws Error (badInput) where there is no solution. All arguments must outlive this object or
    /// the next restart(). `showsEstimate`: radiosity() is the solver's estimate of the solution (for shooting, with the ambient
    /// term), else the radiosity found so far.
    void restart(const PreparedExchange& exchange, const Sources& sources, SolverKind solver,
                 bool showsEstimate = true);

    struct Until {
        double tolerance = 1e-4; ///< largest error, relative to the largest radiosity
        std::size_t steps = 0;   ///< at most so many; 0: no limit
    };
    /// Steps until it is solved, or `most` times (0: no limit), or until the deadline, but at least once while there is work.
    /// True when there is nothing left to do; it stays true until restart().
    bool advance(const Until& until, std::size_t most, std::chrono::steady_clock::time_point deadline);

    /// nullptr: no patch exchanges light with another.
    [[nodiscard]] const Solver* solver() const { return solver_.get(); }
    /// Changes with every step and every restart().
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Where the power goes that patches emit and that lights and surroundings send them. Computed when it is first asked for
    /// after a step.
    [[nodiscard]] const EnergyBalance& energy() const;
    /// B_i of every patch, W/m^2, for display.
    [[nodiscard]] const std::vector<dvec3>& radiosity() const { return radiosity_; }
    /// The same without Sources::apart(): the solution of the equations.
    [[nodiscard]] std::vector<dvec3> exchanged() const;
    /// H_i of every patch, W/m^2: the irradiance by lights, surroundings, and the radiosities so far.
    [[nodiscard]] std::vector<dvec3> irradiance() const;
    /// The irradiance that radiosity() corresponds to: (B_i - E_i) / rho_i, which is H_i once the room is solved. Where rho is 0
    /// it is irradiance().
    [[nodiscard]] std::vector<dvec3> irradianceShown() const;
    /// B_k: the light that was reflected exactly k times.
    [[nodiscard]] std::vector<dvec3> bounce(std::size_t k) const;
    /// E + rho H - B, W/m^2: received and not yet sent on.
    [[nodiscard]] std::vector<dvec3> residual() const;
    /// The equations of the patches that exchange light.
    [[nodiscard]] Problem problem() const;

private:
    void show();
    void addApart(EnergyBalance& energy) const;

    const PreparedExchange* exchange_ = nullptr;
    const Sources* sources_ = nullptr;
    std::unique_ptr<Solver> solver_;
    bool showsEstimate_ = true;
    bool isOneByOne_ = false; ///< its steps are single shots, not sweeps
    std::vector<dvec3> radiosity_;
    bool isFinished_ = false;
    std::uint64_t version_ = 0;
    mutable std::optional<EnergyBalance> energy_;
};

} // namespace shadowlab::radiosity
