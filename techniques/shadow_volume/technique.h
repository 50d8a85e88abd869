// Stencil shadow volumes, counted with depth fail: the volume faces behind each visible point, on the way to infinity.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/shadow_volume/casters.h"
#include "techniques/shadow_volume/stage_pictures.h"

namespace shadowlab::shadow_volume {

struct ZFailParams {
    bool twoSided = true;
    bool cull = true;
    bool wrap = true;
    bool caps = true;
    enum class DepthTest { less, lequal } depthTest = DepthTest::less;
};

class ZFail final : public Technique {
public:
    params::ParamList params() override;
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override;
    Progress render(Frame& frame) override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::string remark(const scene::MeshReport& report) const override;

private:
    void countVolumes(Frame& frame, int light);
    void drawVolumes(const Frame& frame, int light) const;
    void drawLit(Frame& frame, const gl::Program& program, int light) const;
    void publishVisibility(Frame& frame, int light);
    void publishStencilStages(Frame& frame, int light);

    ZFailParams params_;
    Casters casters_;
    std::vector<const CasterVolume*> drawn_; ///< volumes of the current light that can change a pixel
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program shade_{"surface.vert", "shade_light.frag"};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    gl::Program cap_{"position.vert", "nothing.frag"};
    gl::Program extrude_{"shadow_volume/extrude.vert", "nothing.frag"};
    StagePictures pictures_;
};

} // namespace shadowlab::shadow_volume
