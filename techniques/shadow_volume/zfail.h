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
    enum class FarPlane { infiniteAndClamp, infinite, clamp, clip } farPlane = FarPlane::infiniteAndClamp;
};

class ZFail final : public VolumeTechnique {
public:
    ZFail();
    params::ParamList params() override;

private:
    [[nodiscard]] Way wayOf(const scene::Scene&, const dvec3&, const CasterVolume&, int) const override {
        return Way::fail;
    }
    [[nodiscard]] FailRule failRule() const override {
        using enum ZFailParams::FarPlane;
        return {.caps = params_.caps,
                .clamp = params_.farPlane == infiniteAndClamp || params_.farPlane == clamp,
                .lessOrEqual = params_.depthTest == ZFailParams::DepthTest::lequal,
                .farPlane = params_.farPlane == clamp || params_.farPlane == clip};
    }

    ZFailParams params_;
};

TechniqueInfo zfailInfo();

} // namespace shadowlab::shadow_volume
