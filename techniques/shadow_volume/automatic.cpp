// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/automatic.h"

#include "techniques/shadow_volume/eye_line.h"
#include "techniques/shadow_volume/shared_info.h"

namespace shadowlab::shadow_volume {

namespace {

const PassInfo kPasses[] = {
    kLightsOffPass,
    {"clear-stencil", "Clear the stencil buffer", "Each light counts from zero.", "stencil write mask 0xff", true},
    {"volumes", "Count the volume faces before each visible point, or behind it",
     "Casters off the line from the eye to the light: front faces add one and back faces take one where they pass the "
     "depth test. Casters on it, whose volumes the eye may be in: back faces add and front faces take where they fail "
     "it. What is left is the number of volumes that the point is in.",
     "colour and depth writes off, depth LESS, depth clamp; stencil depth-pass INCR_WRAP (front) and DECR_WRAP (back), "
     "then depth-fail INCR_WRAP (back) and DECR_WRAP (front)",
     true, "stencil"},
    {"volumes-back", "Render all volume faces that face away from the viewer",
     "Down by one for each that passes the depth test, of casters off the line from the eye to the light; up by one "
     "for each that fails it, of the others.",
     "colour and depth writes off, cull FRONT, depth LESS, depth clamp; stencil depth-pass DECR_WRAP, then depth-fail "
     "INCR_WRAP",
     true, "stencil-back"},
    {"volumes-front", "Render all volume faces that face toward the viewer",
     "Up by one for each that passes, down by one for each that fails: entered and left, or left and entered.",
     "colour and depth writes off, cull BACK, depth LESS, depth clamp; stencil depth-pass INCR_WRAP, then depth-fail "
     "DECR_WRAP",
     true, "stencil"},
    kRepairPass,
    {"light", "Render the scene again with the light turned on, only where the stencil is zero",
     "The point is outside every volume, so the light sees it.",
     "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE", true},
};

const StageInfo kStages[] = {
    kFacingStage,
    kLightsOffStage,
    kSilhouettesStage,
    kVolumeSignsStage,
    {"volume-parts", "Volume faces by part: top cap, sides, bottom cap", StageKind::radiance, true},
    {"stencil-back", "Stencil after the back faces", StageKind::count, true},
    kStencilStage,
    {"crossings", "Volume faces before each point, or behind it: all that were counted", StageKind::count, true},
    {"ways", "Casters by the way they are counted, for the near-clip pyramid", StageKind::radiance, true},
    kRepairStage,
    kVisibilityStage,
};

VolumeParams repaired() {
    VolumeParams params;
    params.repair = true;
    return params;
}

} // namespace

Automatic::Automatic()
    : VolumeTechnique({.passes = kPasses,
                       .both = {"volumes"},
                       .first = {"volumes-back", GL_FRONT},
                       .second = {"volumes-front", GL_BACK},
                       .stageAfterFirst = "stencil-back"},
                      repaired()) {}

Way Automatic::wayOf(const scene::Scene& scene, const dvec3& eyeWorld, const CasterVolume& caster, int light) const {
    const scene::Light& source = scene.lights[static_cast<std::size_t>(light)];
    const bool unsure = eyeLineMayTouch(caster.bounds, eyeWorld, scene::homogeneousPositionWorld(source)) ||
                        eyeMaySeeThrough(scene, caster);
    return unsure ? Way::fail : Way::pass;
}

TechniqueInfo automaticInfo() {
    using enum scene::LightType;
    return {
        .id = "shadow-volume",
        .title = "Shadow volume",
        .paper = "Crow 1977, Shadow Algorithms for Computer Graphics; Everitt and Kilgard 2002, Practical and Robust "
                 "Stenciled Shadow Volumes",
        .getsWrong = "soft shadows (a light is a point)",
        .order = 45,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Automatic>(); },
    };
}

} // namespace shadowlab::shadow_volume
