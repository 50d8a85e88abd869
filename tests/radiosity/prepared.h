// A scene as the technique prepares it, and its solved equations.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/room_cache.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

struct Prepared {
    explicit Prepared(scene::Scene scene, int patches, radiosity::RadiosityParams::Direct direct = radiosity::RadiosityParams::Direct::pixels) : snapshot(testing::snapshot(std::move(scene))) {
        params.patches = patches;
        params.direct = direct;
        while (!cache.advance(snapshot, params, Deadline::max())) {
        }
        sources = sourcesOf(cache.room(), cache.lights(), dvec3(0));
        if (!cache.pathLight().isEmpty()) takeApart(sources, cache.room(), cache.exchange(), cache.lights(), cache.followed(), cache.pathLight().irradiance);
        balance.restart(cache.exchange(), sources, radiosity::SolverKind::conjugateGradients);
        balance.advance({1e-6, 0}, 0, Deadline::max());
    }
    scene::Snapshot snapshot;
    radiosity::RadiosityParams params;
    radiosity::RoomCache cache;
    radiosity::Sources sources;
    radiosity::LightBalance balance;
};

} // namespace shadowlab::testing
