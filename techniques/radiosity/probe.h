// What `probe` reports of the patch that a pixel shows, and of its exchange of light with another one.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/room_cache.h"
#include "techniques/technique.h"

namespace shadowlab::radiosity {

/// The patch at a pixel's centre; nothing where there is none. Loose patches are numbered after the others.
std::optional<std::uint32_t> patchSeen(const RoomCache& cache, const scene::Snapshot& snapshot, const View& view,
                                       ivec2 pixel);

/// The patch that sends patch j most of the light that it receives from patches; nothing if none sends any.
std::optional<std::uint32_t> brightestGiver(const RoomCache& cache, const LightBalance& balance, std::uint32_t j);

/// Adds the facts of patch j, and of its exchange with its partner if there is one.
void describePatch(const RoomCache& cache, const Sources& sources, const LightBalance& balance, std::uint32_t j,
                   int light, std::optional<std::uint32_t> partner, Probe& probe);

} // namespace shadowlab::radiosity
