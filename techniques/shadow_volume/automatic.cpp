// Stencil shadow volumes: for each caster the cheaper of z-pass and z-fail that is certain to be right.
//
// Depth pass needs no caps, but it is right only for volumes that the eye is outside of. The eye is certainly outside of a
// volume whose caster lies off the line from the eye to the light. Those volumes are counted with depth pass, the others
// with depth fail, into one stencil. In the literature the test is that the caster does not reach into the near-clip
// pyramid, from the near rectangle to the light (Everitt and Kilgard 2002; Hornus, Hoberock, Lefebvre and Hart, "ZP+",
// 2005). Here depth is clamped, so the near plane cuts nothing off, and the pyramid shrinks to the line from the eye to the
// light. A side that the eye sees edge-on needs no test of its own: its caster lies on the line.
// SPDX-License-Identifier: MIT
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/cull/eye_line.h"
#include "techniques/shadow_volume/shared_info.h"
#include "techniques/shadow_volume/volume_technique.h"

namespace shadowlab::shadow_volume {

namespace {

const PassInfo kAutomaticPasses[] = {
    kLightsOffPass,
    kClearStencilPass,
    {.id = "volumes",
     .title = "Count the volume faces before each visible point, or behind it",
     .why = "Casters off the line from the eye to the light: front faces add one and back faces take one where they "
            "pass the depth test. Casters on it, whose volumes the eye may be in: back faces add and front faces take "
            "where they fail it. What is left is the number of volumes that the point is in.",
     .glState = "colour and depth writes off, depth LESS, depth clamp; stencil depth-pass INCR_WRAP (front) and "
                "DECR_WRAP (back), then depth-fail INCR_WRAP (back) and DECR_WRAP (front)",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {3, 5},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = n_f - n_b of the faces before the point, or n_b - n_f of those behind it",
     .anchors = "way-of-a-caster count-passing count-failing extrude"},
    {.id = "volumes-back",
     .title = "Render all volume faces that face away from the viewer",
     .why = "Down by one for each that passes the depth test, of casters off the line from the eye to the light; up by "
            "one for each that fails it, of the others.",
     .glState = "colour and depth writes off, cull FRONT, depth LESS, depth clamp; stencil depth-pass DECR_WRAP, then "
                "depth-fail INCR_WRAP",
     .perLight = true,
     .shownBy = "stencil-back",
     .pseudocodeLines = {3, 4},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = stencil - 1 before the point, + 1 behind it",
     .anchors = "count-one-side way-of-a-caster count-passing count-failing extrude",
     .values = kAfterBacks},
    {.id = "volumes-front",
     .title = "Render all volume faces that face toward the viewer",
     .why = "Up by one for each that passes, down by one for each that fails: entered and left, or left and entered.",
     .glState = "colour and depth writes off, cull BACK, depth LESS, depth clamp; stencil depth-pass INCR_WRAP, then "
                "depth-fail DECR_WRAP",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {5, 5},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = stencil + 1 before the point, - 1 behind it",
     .anchors = "count-one-side way-of-a-caster count-passing count-failing extrude"},
    kRepairPass,
    {.id = "light",
     .title = "Render the scene again with the light turned on, only where the stencil is zero",
     .why = "The point is outside every volume, so the light sees it.",
     .glState = "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true,
     .pseudocodeLines = {6, 7},
     .formula = "illuminated if stencil = 0\n"
                "L = L + visibility * color * E * (diffuse / pi + specular * (s + 8) / (8 pi) * (n.h)^s)",
     .anchors = "light-where-zero shade-light"},
};

const StageInfo kAutomaticStages[] = {
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

class Automatic final : public VolumeTechnique {
public:
    Automatic();
    params::ParamList params() override { return sharedParams(); }

private:
    [[nodiscard]] CountMethod countMethodOf(const scene::Scene& scene, const dvec3& eyeWorld,
                                            const CasterVolume& caster, int light) const override;
    [[nodiscard]] bool showsCountMethods() const override { return true; }
    [[nodiscard]] bool keepsToReceiversInView() const override { return true; }
    [[nodiscard]] PassRule passRule() const override { return {.corrected = true}; }
};

Automatic::Automatic()
    : VolumeTechnique({.passes = kAutomaticPasses,
                       .both = {"volumes"},
                       .first = {"volumes-back", GL_FRONT},
                       .second = {"volumes-front", GL_BACK},
                       .stageAfterFirst = "stencil-back"},
                      repaired()) {}

// [anchor: way-of-a-caster]
CountMethod Automatic::countMethodOf(const scene::Scene& scene, const dvec3& eyeWorld, const CasterVolume& caster,
                                     int light) const {
    const scene::Light& source = scene.light(light);
    const bool unsure = eyeLineMayTouch(caster.bounds, eyeWorld, scene::homogeneousPositionWorld(source)) ||
                        eyeMaySeeThrough(scene, caster);
    return unsure ? CountMethod::zFail : CountMethod::zPass;
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
        .passes = {std::begin(kAutomaticPasses), std::end(kAutomaticPasses)},
        .stages = {std::begin(kAutomaticStages), std::end(kAutomaticStages)},
        .pseudocode = kStencilSteps,
        .values = {{"stencil", "stencil"},
                   {"n_f - n_b", "z-pass, eye to point"},
                   {"n_b - n_f", "z-fail, point to infinity"}},
        .sweeps = {{.title = "Each caster its way", .varies = "repair", .values = "false true"}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Automatic>(); },
    };
}

} // namespace shadowlab::shadow_volume
