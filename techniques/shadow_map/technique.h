// Shadow mapping: a picture of depths taken from the light tells whether something stands between the light and a point.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_map/exact/exact_light.h"
#include "techniques/shadow_map/irregular/alias_free_pass.h"
#include "techniques/shadow_map/maps/averaged_light.h"
#include "techniques/shadow_map/stages/stages.h"

namespace shadowlab::shadow_map {

/// The textbook map (tools_), and three ways to find the visibility of every pixel before the light is added: the mean of many maps,
/// a map that rays make certain, and the visible points tested in the light's picture without any map.
class ShadowMap final : public Technique {
public:
    params::ParamList params() override { return describe(params_); }
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override;
    Progress render(Frame& frame) override;
    [[nodiscard]] bool samplesArea(const scene::Scene& scene, int light) const override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot& snapshot, const View& view, int light) override;
    std::string remark(const scene::MeshReport& report, const scene::Mesh& mesh) const override;

private:
    void publishStages(Frame& frame, int light, const LightShadowMap& map);

    ShadowMapParams params_;
    MapTools tools_{params_};
    AveragedLight averaged_{tools_};
    ExactLight exact_{tools_};
    AliasFreePass aliasFree_;
    LessonStages lessonStages_{tools_};
    FilterStages filterStages_{tools_};
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
};

} // namespace shadowlab::shadow_map
