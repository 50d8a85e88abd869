// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/zfail.h"

#include "techniques/shadow_volume/shared_info.h"

namespace shadowlab::shadow_volume {

namespace {

const PassInfo kPasses[] = {
    kLightsOffPass,
    {"clear-stencil", "Clear the stencil buffer", "Each light counts from zero.", "stencil write mask 0xff", true},
    {"volumes", "Count the volume faces behind each visible point",
     "Back faces add one and front faces take one where they fail the depth test: what is left is not zero inside a "
     "volume.",
     "colour and depth writes off, depth LESS, stencil depth-fail INCR_WRAP (back) and DECR_WRAP (front), depth clamp "
     "for what reaches infinity",
     true, "stencil"},
    {"volumes-back", "Render all volume faces that face away from the viewer",
     "The stencil goes up by one for each point that fails the depth test.",
     "colour and depth writes off, cull FRONT, depth LESS, stencil depth-fail INCR_WRAP", true, "stencil-back"},
    {"volumes-front", "Render all volume faces that face toward the viewer",
     "The stencil goes down by one for each point that fails the depth test: faces in front and behind cancel.",
     "colour and depth writes off, cull BACK, depth LESS, stencil depth-fail DECR_WRAP", true, "stencil"},
    kRepairPass,
    {"light", "Render the scene again with the light turned on, only where the stencil is zero",
     "As many faces entered as left: the point is outside every volume, so the light sees it.",
     "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE", true},
};

const StageInfo kStages[] = {
    kFacingStage,
    kLightsOffStage,
    kSilhouettesStage,
    kVolumeSignsStage,
    {"volume-parts", "Volume faces by part: top cap, sides, bottom cap", StageKind::radiance, true},
    {"stencil-back", "Stencil after the back faces: +1 for each behind the point", StageKind::count, true},
    kStencilStage,
    {"crossings", "Volume faces behind each point: all that were counted", StageKind::count, true},
    kRepairStage,
    kVisibilityStage,
};

} // namespace

ZFail::ZFail()
    : VolumeTechnique({.passes = kPasses,
                       .both = {"volumes"},
                       .first = {"volumes-back", GL_FRONT},
                       .second = {"volumes-front", GL_BACK},
                       .stageAfterFirst = "stencil-back"}) {}

params::ParamList ZFail::params() {
    params::ParamList list = sharedParams();
    list.push_back(
        params::boolean("caps", params_.caps, "Close the volumes with caps; false: depth fail miscounts (teaching)."));
    list.push_back(
        params::choice("depth-test", params_.depthTest, {"less", "lequal"},
                       "Depth test of the volume faces; lequal: top caps fight with their own surface (teaching)."));
    list.push_back(
        params::choice("far-plane", params_.farPlane, {"infinite-and-clamp", "infinite", "clamp", "clip"},
                       "What keeps the far plane from cutting volumes open: a projection without one, clamping of "
                       "depth, or both; clip: nothing, which shows with volume-end = infinity (teaching)."));
    return list;
}

Progress ZFail::render(Frame& frame) {
    if (failRule().farPlane) frame.useFarPlane();
    return VolumeTechnique::render(frame);
}

TechniqueInfo zfailInfo() {
    using enum scene::LightType;
    return {
        .id = "shadow-volume-zfail",
        .title = "Shadow volume (z-fail)",
        .paper = "Crow 1977, Shadow Algorithms for Computer Graphics; Everitt and Kilgard 2002, Practical and Robust "
                 "Stenciled Shadow Volumes",
        .getsWrong = "soft shadows (a light is a point); isolated pixels at cracks",
        .order = 40,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ZFail>(); },
    };
}

} // namespace shadowlab::shadow_volume
