// Culling of one volume for one view: where it ends, which of its parts may be seen, and where its shadow may fall. The
// volume's indices do not depend on it, so they stay the same while the eye moves.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/count/volume_end.h"
#include "techniques/shadow_volume/cull/casters.h"

namespace shadowlab::shadow_volume {

/// The parts of a volume that have to be drawn; leaving out the rest does not change the picture.
struct VolumeInView {
    const CasterVolume* caster = nullptr;
    VolumeEnd end;
    bool any = true, topCap = true, bottomCap = true;
    std::optional<scene::PicturePart> part = std::nullopt; ///< outside of it the count does not matter; none: the whole picture
};

/// Leaves out what certainly does not touch the part of the picture that is drawn: the caster's box, what it is extruded
/// to, or for `any` both together, lie outside one plane of the view. `part` is the rectangle around both; none where not all of
/// them lies beyond the near plane.
VolumeInView volumeInView(const CasterVolume& caster, const scene::Light& light, const VolumeEnd& end,
                          const gl::EyeMatrices& eye);

/// Leaves out more, knowing what of the receivers is in view, a box for each: `any` becomes false where the volume meets
/// none of them, `part` is where in the picture it may meet some.
void keepToReceivers(VolumeInView& volume, const scene::Light& light, std::span<const scene::Bounds> receivers,
                     const gl::EyeMatrices& eye);

} // namespace shadowlab::shadow_volume
