// The part of the picture in which a light's maps have to be looked up: elsewhere no caster's shadow can fall.
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

/// How an object is drawn with a light's maps: looked up where a shadow can fall, and plainly lit elsewhere.
struct ReceiverLookup {
    bool looksUp = true;                     ///< it is drawn with the maps looked up
    std::optional<scene::PicturePart> where; ///< in this part of the picture; none: everywhere
    bool rest = false;                       ///< it is drawn once more, without any lookup, for its other pixels
};
/// For the object in these bounds. Drawing it twice pays only where most of it needs no lookup.
ReceiverLookup receiverLookup(const LightMaps& maps, const scene::Bounds& object, const dmat4& clipFromWorld);

} // namespace shadowlab::shadow_map
