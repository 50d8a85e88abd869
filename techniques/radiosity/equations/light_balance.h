// What the patches emit and reflect, what arrives from outside of the equations, and the equations' solution: everything about
// a room that depends on how bright things are.
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
#include "techniques/radiosity/room/room.h"
#include "techniques/radiosity/solvers/solvers.h"

namespace shadowlab::radiosity {

/// Of every patch: those that exchange light, and the loose ones after them.
struct Sources {
    std::vector<dvec3> emission;    ///< E_i of the patch itself, W/m^2
    std::vector<dvec3> reflectance; ///< rho_i
    std::vector<dvec3> fromLights;  ///< irradiance that comes straight from lights, W/m^2
    std::vector<dvec3> fromOutside; ///< irradiance from where there is no surface, W/m^2
    [[nodiscard]] std::size_t size() const { return emission.size(); }
    /// Irradiance that comes from no patch.
    [[nodiscard]] dvec3 irradiance(std::size_t i) const { return fromLights[i] + fromOutside[i]; }
    /// What leaves a patch before any light came by way of another one.
    [[nodiscard]] dvec3 first(std::size_t i) const { return emission[i] + reflectance[i] * irradiance(i); }
};

/// `lights`: what each light brings to every patch. `surroundings`: radiance that comes from where there is no surface.
Sources sourcesOf(const Room& room, std::span<const DirectLight* const> lights, const dvec3& surroundings);

/// The radiosity of every patch, found step by step.
class LightBalance {
public:
    /// Begins anew. Error (badInput) where there is no solution. Everything must live as long. `showsEstimate`: radiosity() is the
    /// solver's guess of what it will be (while shooting with the ambient term), else what has been found so far.
    void restart(const PreparedExchange& exchange, const Sources& sources, SolverKind solver,
                 bool showsEstimate = true);

    struct Until {
        double tolerance = 1e-4; ///< of the largest radiosity
        std::size_t steps = 0;   ///< no more than that; 0: any number
    };
    /// Steps until it is solved, `most` times (0: any number), or until the time has come, but at least once if there is anything
    /// to do. True when there is nothing more to do; from then on it stays so until it begins anew.
    bool advance(const Until& until, std::size_t most, std::chrono::steady_clock::time_point deadline);

    /// nullptr: no patch exchanges light with another.
    [[nodiscard]] const Solver* solver() const { return solver_.get(); }
    /// Another number whenever a step was made, or all has begun anew.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Where the power goes that the patches emit and that lights and surroundings send them. Found when first asked for after a
    /// step.
    [[nodiscard]] const EnergyBalance& energy() const;
    /// B_i of every patch, W/m^2, to be shown.
    [[nodiscard]] const std::vector<dvec3>& radiosity() const { return radiosity_; }
    /// H_i of every patch, what arrives from lights, from outside and from the radiosities so far, W/m^2.
    [[nodiscard]] std::vector<dvec3> irradiance() const;
    /// What would have to arrive for radiosity() to leave: (B_i - E_i) / rho_i, in a solved room H_i. Where nothing is reflected that
    /// does not say, and it is irradiance().
    [[nodiscard]] std::vector<dvec3> irradianceShown() const;
    /// B_k: what was reflected exactly k times.
    [[nodiscard]] std::vector<dvec3> bounce(std::size_t k) const;
    /// What was received and not yet sent on, W/m^2: E + rho H - B.
    [[nodiscard]] std::vector<dvec3> residual() const;
    /// The equations of the patches that exchange light.
    [[nodiscard]] Problem problem() const;

private:
    void show();

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
