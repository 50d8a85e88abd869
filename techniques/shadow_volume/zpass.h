// Stencil shadow volumes, counted with depth pass: the volume faces between the eye and each visible point.
//
// Heidmann, "Real Shadows, Real Time", 1991: the textbook algorithm, faults included. The walk starts at the eye, and the
// stencil at zero: that is right only where the eye is in no volume. What lies before the near plane is not drawn, so it
// is as wrong where the near plane cuts a volume. Depth fail (zfail.h) asks nothing of the eye. The top cap is not
// needed: the walk ends at the visible point, and no surface that casts lies before it; nor is the bottom cap, as long as the
// eye is not beyond it.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/volume_technique.h"

namespace shadowlab::shadow_volume {

struct ZPassParams {
    bool eyeCorrection = false;
};

class ZPass final : public VolumeTechnique {
public:
    ZPass();
    params::ParamList params() override;
    std::string remark(const scene::MeshReport& report, const scene::Mesh& mesh) const override;

private:
    [[nodiscard]] Way wayOf(const scene::Scene& scene, const dvec3& eyeWorld, const CasterVolume& caster,
                            int light) const override;
    [[nodiscard]] PassRule passRule() const override { return {.corrected = params_.eyeCorrection}; }
    [[nodiscard]] bool showsCaps() const override { return false; }
    /// Moved out to the nearest surface the near plane would cut far more volumes.
    [[nodiscard]] bool usesNearPlaneOfView() const override { return !params_.eyeCorrection; }

    ZPassParams params_;
};

TechniqueInfo zpassInfo();

} // namespace shadowlab::shadow_volume
