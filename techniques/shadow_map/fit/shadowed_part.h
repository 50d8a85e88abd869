// The part of the picture in which a light's maps have to be asked at all: elsewhere no caster's shadow can fall.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/foundation/scene/query/view/picture_part.h"
#include "techniques/shadow_map/fit/light_maps.h"

namespace shadowlab::shadow_map {

/// A rectangle around what of the receivers' boxes lies in one of the maps, as the eye sees it; empty (lower > upper) when
/// nothing does. None where that is not known: for maps all around a light, and where eye or light is among the receivers.
std::optional<scene::PicturePart> shadowedPart(const LightMaps& maps, std::span<const scene::Bounds> receivers,
                                               const dmat4& clipFromWorld);

/// How an object is drawn with a light's maps.
struct Asking {
    bool asks = true;                        ///< the maps, for some of its pixels,
    std::optional<scene::PicturePart> where; ///< which lie here; none: anywhere
    bool rest = false;                       ///< and once more without asking, for its other pixels
};
/// What to do with the object in these bounds. To draw it twice pays only where the maps need not be asked for most of it.
Asking askingOf(const LightMaps& maps, const scene::Bounds& object, const dmat4& clipFromWorld);

} // namespace shadowlab::shadow_map
