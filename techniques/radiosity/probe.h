// What is known of the patch that a pixel shows, and of the light that it gets from another one.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/room_cache.h"
#include "techniques/technique.h"

namespace shadowlab::radiosity {

/// The patch that a pixel's centre shows; nothing where there is none. Loose patches have the numbers after the others.
std::optional<std::uint32_t> patchSeen(const RoomCache& cache, const scene::Snapshot& snapshot, const View& view,
                                       ivec2 pixel);

/// The one that gives most of the light that patch j gets from others; nothing if none gives any.
std::optional<std::uint32_t> brightestGiver(const RoomCache& cache, const LightBalance& balance, std::uint32_t j);

/// Adds what there is to say of patch j, and of its partner if it has one.
void describePatch(const RoomCache& cache, const Sources& sources, const LightBalance& balance, std::uint32_t j,
                   int light, std::optional<std::uint32_t> partner, Probe& probe);

} // namespace shadowlab::radiosity
