// SPDX-License-Identifier: MIT
#include "techniques/radiosity/solution.h"

#include "techniques/radiosity/lights/lamp_cover.h"

namespace shadowlab::radiosity {

namespace {

// Of the work of hemicubes that is done, so much is shown as done: the solution follows.
constexpr double kShareOfHemicubes = 0.9;

} // namespace

dvec3 radianceOutside(const scene::Scene& scene, const RadiosityParams& params) {
    using enum RadiosityParams::Surroundings;
    return dvec3(params.surroundings == background ? scene.background
                 : params.surroundings == ambient  ? scene.ambient
                                                   : vec3(0.0f));
}

bool Solution::advanceRoom(const scene::Snapshot& snapshot, const RadiosityParams& params, Deadline deadline, const std::optional<Eye>& eye) {
    const bool isDone = cache_.advance(snapshot, params, deadline, eye);
    if (!isDone) done_ = cache_.done();
    return isDone;
}

bool Solution::advanceDrawnFormFactors(const RadiosityParams& params, Deadline deadline) {
    if (cache_.hasFormFactors()) return true;
    const HemicubeCacheKey key{cache_.version(), params.hemicubeSide};
    if (!hemicubes_ || hemicubesKey_ != key) hemicubes_ = std::make_unique<HemicubeExchange>(cache_.room().patches(), params.hemicubeSide);
    hemicubesKey_ = key;
    if (!hemicubes_->advance(deadline)) {
        done_ = kShareOfHemicubes * hemicubes_->done();
        return false;
    }
    cache_.setDrawnFormFactors(hemicubes_->take(), params.hemicubeSide);
    hemicubes_.reset();
    return true;
}

void Solution::restartIfChanged(const scene::Snapshot& snapshot, const RadiosityParams& params) {
    const SolutionCacheKey key{cache_.version(),   snapshot->revisions, params.solver,
                               params.tolerance,   params.steps,        params.stepsPerPicture,
                               params.ambientTerm, !cache_.pathLight().isEmpty(), params.surroundings};
    if (key == solutionKey_) return;
    if (key.room != solutionKey_.room) openings_ = Openings(cache_.room());
    solutionKey_ = key;
    sources_ = sourcesOf(cache_.room(), cache_.lights(), radianceOutside(*snapshot, params));
    for (std::size_t i = 0; i < sources_.size(); ++i)
        sources_.reflectance[i] *= 1 - coveredByLamps(cache_.room().allPatches()[i], snapshot->lights, cache_.room().world().originWorld);
    if (key.hasPathLight) takeApart(sources_, cache_.room(), cache_.exchange(), cache_.lights(), cache_.followed(), cache_.pathLight().irradiance);
    balance_.restart(cache_.exchange(), sources_, params.solver, params.ambientTerm);
}

bool Solution::advanceSolver(const RadiosityParams& params, std::size_t most, Deadline deadline) {
    return balance_.advance({params.tolerance, static_cast<std::size_t>(params.steps)}, most, deadline);
}

} // namespace shadowlab::radiosity
