// SPDX-License-Identifier: MIT
#include "techniques/radiosity/equations/bounces.h"

#include "techniques/radiosity/equations/gather.h"

namespace shadowlab::radiosity {

namespace {

/// a / b for each colour, and 0 where b is 0.
dvec3 shareOf(const dvec3& a, const dvec3& b) {
    dvec3 share(0);
    for (int c = 0; c < 3; ++c)
        if (b[c] > 0) share[c] = a[c] / b[c];
    return share;
}

} // namespace

std::vector<dvec3> irradiance(const Problem& problem, const std::vector<dvec3>& radiosity) {
    return gathered(problem.exchange, problem.areas, radiosity);
}

// [anchor: one-bounce]
std::vector<dvec3> nextBounce(const Problem& problem, std::span<const dvec3> bounceBefore) {
    std::vector<dvec3> next = gathered(problem.exchange, problem.areas, bounceBefore);
    for (std::size_t i = 0; i < next.size(); ++i)
        next[i] *= problem.reflectance[i];
    return next;
}

std::vector<dvec3> bounce(const Problem& problem, std::size_t k) {
    std::vector<dvec3> light = problem.emission;
    for (std::size_t i = 0; i < k; ++i)
        light = nextBounce(problem, light);
    return light;
}

EnergyBalance energyBalance(const Problem& problem, const std::vector<dvec3>& radiosity) {
    const std::vector<dvec3> reaching = irradiance(problem, radiosity);
    const std::vector<double> deficits = closureDeficits(problem.exchange, problem.areas);
    EnergyBalance balance;
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        balance.emitted += problem.areas[i] * problem.emission[i];
        balance.absorbed += problem.areas[i] * (1.0 - problem.reflectance[i]) * reaching[i];
        balance.escaped += problem.areas[i] * deficits[i] * radiosity[i];
    }
    return balance;
}

dvec3 EnergyBalance::residual() const { return shareOf(emitted - absorbed - escaped, emitted); }

dvec3 EnergyBalance::closedResidual() const { return shareOf(emitted - absorbed, emitted); }

} // namespace shadowlab::radiosity
