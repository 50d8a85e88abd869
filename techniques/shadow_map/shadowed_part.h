// The part of the picture in which a light's maps have to be asked at all: elsewhere no caster's shadow can fall.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/foundation/scene/picture_part.h"
#include "techniques/shadow_map/light_maps.h"

namespace shadowlab::shadow_map {

/// A rectangle around what of the receivers' boxes lies in one of the maps, as the eye sees it; empty (lower > upper) when
/// nothing does. None where that is not known: for maps all around a light, and where eye or light is among the receivers.
std::optional<scene::PicturePart> shadowedPart(const LightMaps& maps, std::span<const scene::Bounds> receivers,
                                               const dmat4& clipFromWorld);

/// Does all of the box certainly lie in that part of the picture?
bool isWithin(const scene::Bounds& bounds, const scene::PicturePart& part, const dmat4& clipFromWorld);

} // namespace shadowlab::shadow_map
