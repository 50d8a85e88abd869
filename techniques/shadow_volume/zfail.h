// Stencil shadow volumes, counted with depth fail: the volume faces behind each visible point, on the way to infinity.
//
// Bilodeau and Songy 1999, Carmack 2000; Everitt and Kilgard, "Practical and Robust Stenciled Shadow Volumes", 2002.
// The walk from the point away from the eye ends outside every volume, wherever the eye is; the price are the caps, which
// close each volume at the caster and at its end.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/volume_technique.h"

namespace shadowlab::shadow_volume {

struct ZFailParams {
    bool caps = true;
    enum class DepthTest { less, lequal } depthTest = DepthTest::less;
};

class ZFail final : public VolumeTechnique {
public:
    ZFail();
    params::ParamList params() override;

private:
    void setCountState() const override;
    void drawFaces(const Frame& frame, int light) const override;
    [[nodiscard]] bool hasCaps() const override { return params_.caps; }
    bool counts(const CasterVolume& caster) const override { return caster.useful; }

    ZFailParams params_;
    gl::Program cap_{"position.vert", "nothing.frag"};
};

TechniqueInfo zfailInfo();

} // namespace shadowlab::shadow_volume
