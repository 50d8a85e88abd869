// Stencil shadow volumes, counted with depth pass: the volume faces between the eye and each visible point.
//
// Heidmann, "Real Shadows, Real Time", 1991: the textbook algorithm, with its faults. The count begins at the eye with a
// stencil of zero, which is right only if the eye is in no volume. Faces before the near plane are not drawn, so the count
// is also wrong where the near plane cuts a volume. Depth fail (zfail.cpp) has neither fault. No top cap is needed, because
// it lies on the caster's surface and no surface lies before the visible point. No bottom cap is needed either, as long as
// the eye is not beyond it.
// SPDX-License-Identifier: MIT
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/cull/eye_line.h"
#include "techniques/shadow_volume/shared_info.h"
#include "techniques/shadow_volume/volume_technique.h"

namespace shadowlab::shadow_volume {

namespace {

const PassInfo kZPassPasses[] = {
    kLightsOffPass,
    {.id = "clear-stencil",
     .title = "Clear the stencil buffer",
     .why = "Each light counts from zero: taken for granted is that the eye is in no volume.",
     .glState = "stencil write mask 0xff",
     .perLight = true,
     .formula = "stencil = 0, or with eye-correction the volumes that the eye is in",
     .anchors = "clear-count",
     .values = kCleared},
    {.id = "volumes",
     .title = "Count the volume faces between the eye and each visible point",
     .why = "Front faces add one and back faces take one where they pass the depth test: n_f - n_b is not zero inside "
            "a volume. Wrong where the eye is in a volume, or the near plane cuts one: the face that was entered is "
            "never met.",
     .glState = "colour and depth writes off, depth LESS, stencil depth-pass INCR_WRAP (front) and DECR_WRAP (back)",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {2, 2},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = n_f - n_b, of the faces before the point",
     .anchors = "count-passing extrude way-by-z-pass[eye-correction=true]"},
    {.id = "volumes-front",
     .title = "Render all volume faces that face toward the viewer",
     .why = "n_f: the stencil goes up by one for each that passes the depth test, where a volume is entered.",
     .glState = "colour and depth writes off, cull BACK, depth LESS, stencil depth-pass INCR_WRAP",
     .perLight = true,
     .shownBy = "stencil-front",
     .pseudocodeLines = {2, 2},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = stencil + 1 where a front face passes the depth test: n_f",
     .anchors = "count-one-side count-passing extrude",
     .values = kAfterFronts},
    {.id = "volumes-back",
     .title = "Render all volume faces that face away from the viewer",
     .why = "n_b: the stencil goes down by one for each that passes the depth test, where a volume is left.",
     .glState = "colour and depth writes off, cull FRONT, depth LESS, stencil depth-pass DECR_WRAP",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {2, 2},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = stencil - 1 where a back face passes the depth test: n_b",
     .anchors = "count-one-side count-passing extrude"},
    kRepairPass,
    {.id = "light",
     .title = "Render the scene again with the light turned on, only where the stencil is zero",
     .why = "n_f = n_b: the line from the eye to the point left every volume that it entered, so the point is "
            "illuminated.",
     .glState = "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true,
     .pseudocodeLines = {3, 3},
     .formula = "illuminated if stencil = 0, n_f = n_b\n"
                "L = L + visibility * color * E * (diffuse / pi + specular * (s + 8) / (8 pi) * (n.h)^s)",
     .anchors = "light-where-zero shade-light"},
};

const StageInfo kZPassStages[] = {
    kFacingStage,
    kLightsOffStage,
    kSilhouettesStage,
    kVolumeSignsStage,
    {"volume-parts", "Volume faces by part: of these, only the sides are counted", StageKind::radiance, true},
    {"stencil-front", "Stencil after the front faces: +1 for each before the point", StageKind::count, true},
    kStencilStage,
    {"crossings", "Volume faces before each point: all that were counted", StageKind::count, true},
    kRepairStage,
    kVisibilityStage,
};

} // namespace

struct ZPassParams {
    bool eyeCorrection = false;
};

class ZPass final : public VolumeTechnique {
public:
    ZPass();
    params::ParamList params() override;
    std::string remark(const scene::MeshReport& report, const scene::Mesh& mesh) const override;

private:
    [[nodiscard]] CountMethod countMethodOf(const scene::Scene& scene, const dvec3& eyeWorld,
                                            const CasterVolume& caster, int light) const override;
    [[nodiscard]] PassRule passRule() const override { return {.corrected = params_.eyeCorrection}; }
    [[nodiscard]] bool showsCaps() const override { return false; }
    /// A near plane moved out to the nearest surface would cut far more volumes.
    [[nodiscard]] bool usesNearPlaneOfView() const override { return !params_.eyeCorrection; }

    ZPassParams params_;
};

ZPass::ZPass()
    : VolumeTechnique({.passes = kZPassPasses,
                       .both = {"volumes"},
                       .first = {"volumes-front", GL_BACK},
                       .second = {"volumes-back", GL_FRONT},
                       .stageAfterFirst = "stencil-front"}) {}

params::ParamList ZPass::params() {
    params::ParamList list = sharedParams();
    list.push_back(params::boolean(
        {"eye-correction", "Correct for the eye"}, params_.eyeCorrection,
        "Start with the number of volumes that the eye is in, count what the near plane cuts off, and use depth fail "
        "for volumes that the eye sees edge-on; false: the textbook, wrong for an eye in shadow."));
    return list;
}

// [anchor: way-by-z-pass]
CountMethod ZPass::countMethodOf(const scene::Scene& scene, const dvec3& eyeWorld, const CasterVolume& caster,
                                 int light) const {
    const scene::Light& source = scene.light(light);
    // The number of volumes around the eye (eyeCount) is known only for volumes that end at a plane or at infinity.
    const bool unsure =
        params_.eyeCorrection &&
        (eyeMaySeeThrough(scene, caster) ||
         (endsAtDistance() ? eyeLineMayTouch(caster.bounds, eyeWorld, scene::homogeneousPositionWorld(source))
                           : eyeLineGrazes(scene, caster, source, eyeWorld)));
    return unsure ? CountMethod::zFail : CountMethod::zPass;
}

std::string ZPass::remark(const scene::MeshReport& report, const scene::Mesh& mesh) const {
    return VolumeTechnique::remark(report, mesh) +
           "; wrong from an eye in its shadow, or so near that the near plane cuts it" +
           (report.hasHoles ? ", and for what is seen through a hole" : "");
}

TechniqueInfo zpassInfo() {
    using enum scene::LightType;
    return {
        .id = "shadow-volume-zpass",
        .title = "Shadow volume (z-pass)",
        .paper = "Crow 1977, Shadow Algorithms for Computer Graphics; Heidmann 1991, Real Shadows, Real Time",
        .getsWrong = "any pixel, when the eye is in shadow or the near plane cuts a volume (the textbook algorithm); "
                     "soft shadows (a light is a point)",
        .order = 35,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kZPassPasses), std::end(kZPassPasses)},
        .stages = {std::begin(kZPassStages), std::end(kZPassStages)},
        .pseudocode = kZPassSteps,
        .values = {{"stencil", "stencil"}, {"n_f - n_b", "z-pass, eye to point"}},
        .sweeps = {{.title = "Textbook"},
                   {.title = "Corrected for the eye",
                    .settings = "eye-correction=true",
                    .varies = "repair",
                    .values = "false true"}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ZPass>(); },
    };
}

} // namespace shadowlab::shadow_volume
