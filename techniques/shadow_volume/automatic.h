// Stencil shadow volumes, each counted in the cheaper way that is certainly right.
//
// Depth pass needs no caps but has to know which volumes the eye is in. Most it is certainly not in: their casters lie off
// the line from the eye to the light. Those are counted with depth pass, the others with depth fail, into one stencil.
// The literature asks the near-clip pyramid, from the near rectangle to the light, to be free of the caster (Everitt and
// Kilgard 2002; Hornus, Hoberock, Lefebvre and Hart, "ZP+", 2005). Here depth is clamped, the near plane cuts nothing
// off, and the pyramid shrinks to that line. A side that the eye sees edge-on needs no second look: it belongs to a caster
// on the line.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/volume_technique.h"

namespace shadowlab::shadow_volume {

class Automatic final : public VolumeTechnique {
public:
    Automatic();
    params::ParamList params() override { return sharedParams(); }

private:
    [[nodiscard]] Way wayOf(const scene::Scene& scene, const dvec3& eyeWorld, const CasterVolume& caster,
                            int light) const override;
    [[nodiscard]] bool showsWays() const override { return true; }
    [[nodiscard]] bool keepsToReceiversInView() const override { return true; }
    [[nodiscard]] PassRule passRule() const override { return {.corrected = true}; }
};

TechniqueInfo automaticInfo();

} // namespace shadowlab::shadow_volume
