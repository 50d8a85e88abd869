// SPDX-License-Identifier: MIT
#include "techniques/radiosity/equations/light_balance.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/radiosity/equations/gather.h"

namespace shadowlab::radiosity {

Sources sourcesOf(const Room& room, std::span<const DirectLight* const> lights, const dvec3& surroundings) {
    Sources sources;
    for (const Patch& patch : room.allPatches()) {
        const std::size_t i = sources.emission.size();
        const double seenOutside = i < room.patches().size() ? room.surroundings()[i] : 1; // loose ones see no surface at all
        sources.emission.push_back(room.areaFactor(patch) * room.emissionOf(patch));
        sources.reflectance.emplace_back(glm::clamp(room.reflectances()[i], 0.0, 1.0));
        sources.fromOutside.push_back(glm::pi<double>() * seenOutside * surroundings);
    }
    sources.fromLights.assign(sources.size(), dvec3(0));
    for (const DirectLight* light : lights)
        for (std::size_t i = 0; i < sources.size(); ++i)
            sources.fromLights[i] += light->irradiance[i];
    return sources;
}

void takeApart(Sources& sources, const Room& room, const PreparedExchange& exchange, std::span<const DirectLight* const> lights, const Followed& followed,
               std::span<const dvec3> pathLight) {
    const std::size_t count = room.patches().size();
    sources.isFollowed = followed.patches;
    sources.isFollowed.resize(sources.size(), 0);
    sources.fromFollowedLights.assign(sources.size(), dvec3(0));
    for (std::size_t l = 0; l < lights.size(); ++l) {
        if (followed.lights[l] == 0) continue;
        for (std::size_t i = 0; i < sources.size(); ++i)
            sources.fromFollowedLights[i] += lights[l]->irradiance[i];
    }
    std::vector<dvec3> sent(count); // straight to others, without noise
    for (std::size_t i = 0; i < count; ++i)
        if (followed.hasPatch(i) && !room.isSimplified(room.faceOf(room.patches()[i]).object)) sent[i] = sources.emission[i];
    sources.byPaths = gathered(exchange.matrix, exchange.areas, sent);
    for (std::size_t i = 0; i < count; ++i)
        sources.byPaths[i] += pathLight[i];
    sources.byPaths.resize(sources.size(), dvec3(0)); // loose patches see no emitter
}

Problem LightBalance::problem() const {
    const std::size_t count = exchange_->areas.size();
    Problem problem{exchange_->matrix, exchange_->areas, {}, {}};
    for (std::size_t i = 0; i < count; ++i) {
        problem.emission.push_back(sources_->first(i));
        problem.reflectance.push_back(sources_->reflectance[i]);
    }
    return problem;
}

void LightBalance::restart(const PreparedExchange& exchange, const Sources& sources, SolverKind solver,
                           bool showsEstimate) {
    exchange_ = &exchange;
    sources_ = &sources;
    showsEstimate_ = showsEstimate;
    solver_.reset();
    if (!exchange.areas.empty()) solver_ = makeSolver(solver, problem());
    isFinished_ = false;
    isOneByOne_ = solver == SolverKind::southwell || solver == SolverKind::shooting;
    show();
}

bool LightBalance::advance(const Until& until, std::size_t most, std::chrono::steady_clock::time_point deadline) {
    // The error bound of single shots is evaluated only now and then: it costs as much as a shot, and for shooting as much as a
    // sweep.
    constexpr std::size_t kShotsBetween = 64;
    const auto isDone = [&] {
        return (until.steps > 0 && solver_->steps() >= until.steps) || isSolved(*solver_, until.tolerance);
    };
    if (!solver_ || isFinished_) return true; // nothing exchanges light, or the solver has finished
    bool done = isDone();
    for (std::size_t step = 0; !done && (most == 0 || step < most); ++step) {
        solver_->step();
        const bool looks = !isOneByOne_ || solver_->steps() % kShotsBetween == 0;
        done = looks ? isDone() : until.steps > 0 && solver_->steps() >= until.steps;
        if (std::chrono::steady_clock::now() >= deadline) break;
    }
    show();
    isFinished_ = done;
    return done;
}

const EnergyBalance& LightBalance::energy() const {
    if (energy_) return *energy_;
    energy_ = energyBalance(problem(), solver_->radiosity());
    // In the equations the "emission" of a patch includes its reflection of light from lights and surroundings. The rest of that
    // light is absorbed.
    for (std::size_t i = 0; i < exchange_->areas.size(); ++i) {
        const dvec3 lost = exchange_->areas[i] * (1.0 - sources_->reflectance[i]) * sources_->irradiance(i);
        energy_->emitted += lost;
        energy_->absorbed += lost;
    }
    if (!sources_->byPaths.empty()) addApart(*energy_);
    return *energy_;
}

/// Of light that is followed, the equations have as "emission" what other patches reflect. They absorb the rest of what reaches them, as do those that are followed;
/// what is left escapes.
void LightBalance::addApart(EnergyBalance& energy) const {
    dvec3 sent(0), reflected(0), absorbed(0);
    for (std::size_t i = 0; i < exchange_->areas.size(); ++i) {
        const dvec3 arriving = exchange_->areas[i] * sources_->byPaths[i];
        absorbed += (1.0 - sources_->reflectance[i]) * arriving;
        if (sources_->isFollowed[i] != 0)
            sent += exchange_->areas[i] * (sources_->emission[i] + sources_->reflectance[i] * sources_->fromFollowedLights[i]);
        else
            reflected += sources_->reflectance[i] * arriving;
    }
    energy.emitted += sent - reflected;
    energy.absorbed += absorbed;
    energy.escaped += sent - reflected - absorbed;
}

void LightBalance::show() {
    version_ = scene::newRevision();
    energy_.reset();
    radiosity_.clear();
    if (solver_) radiosity_ = showsEstimate_ ? solver_->shown() : solver_->radiosity();
    for (std::size_t i = radiosity_.size(); i < sources_->size(); ++i)
        radiosity_.push_back(sources_->first(i));
    for (std::size_t i = 0; i < radiosity_.size(); ++i)
        radiosity_[i] += sources_->apart(i);
}

std::vector<dvec3> LightBalance::exchanged() const {
    std::vector<dvec3> exchanged = radiosity_;
    for (std::size_t i = 0; i < exchanged.size(); ++i)
        exchanged[i] -= sources_->apart(i);
    return exchanged;
}

std::vector<dvec3> LightBalance::irradiance() const {
    const std::vector<dvec3> sent = exchanged();
    std::vector<dvec3> arriving = gathered(exchange_->matrix, exchange_->areas, std::span(sent).first(exchange_->areas.size()));
    arriving.resize(sources_->size(), dvec3(0)); // loose patches receive nothing from other patches
    for (std::size_t i = 0; i < arriving.size(); ++i)
        arriving[i] += sources_->irradiance(i) + (sources_->byPaths.empty() ? dvec3(0) : sources_->byPaths[i]);
    return arriving;
}

std::vector<dvec3> LightBalance::irradianceShown() const {
    std::vector<dvec3> shown(radiosity_.size()), gathered; // irradiance(), computed only if it is needed
    for (std::size_t i = 0; i < shown.size(); ++i)
        for (int color = 0; color < 3; ++color) {
            const double reflectance = sources_->reflectance[i][color];
            if (reflectance > 0) {
                shown[i][color] = std::max(0.0, radiosity_[i][color] - sources_->emission[i][color]) / reflectance;
            } else {
                if (gathered.empty()) gathered = irradiance();
                shown[i][color] = gathered[i][color];
            }
        }
    return shown;
}

std::vector<dvec3> LightBalance::bounce(std::size_t k) const {
    std::vector<dvec3> now = sources_->emission;
    Problem own = problem();
    for (std::size_t done = 0; done < k; ++done) {
        std::vector<dvec3> next = nextBounce(own, std::span(now).first(exchange_->areas.size()));
        next.resize(sources_->size(), dvec3(0));
        if (done == 0)
            for (std::size_t i = 0; i < next.size(); ++i)
                next[i] += sources_->reflectance[i] * sources_->irradiance(i);
        now = std::move(next);
    }
    return now;
}

std::vector<dvec3> LightBalance::residual() const {
    std::vector<dvec3> residual = solver_ ? solver_->residual() : std::vector<dvec3>{};
    residual.resize(sources_->size(), dvec3(0));
    return residual;
}

} // namespace shadowlab::radiosity
