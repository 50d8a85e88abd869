// Stencil shadow volumes, counted with depth fail: the volume faces behind each visible point, on the way to infinity.
//
// Bilodeau and Songy 1999, Carmack 2000; Everitt and Kilgard, "Practical and Robust Stenciled Shadow Volumes", 2002. The
// line from the point away from the eye ends outside of every volume, wherever the eye is. In return each volume has to be
// closed by caps, at the caster and at its far end.
// SPDX-License-Identifier: MIT
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/shared_info.h"
#include "techniques/shadow_volume/volume_technique.h"

namespace shadowlab::shadow_volume {

namespace {

const PassInfo kZFailPasses[] = {
    kLightsOffPass,
    kClearStencilPass,
    {.id = "volumes",
     .title = "Count the volume faces behind each visible point",
     .why = "Back faces add one and front faces take one where they fail the depth test: what is left is not zero "
            "inside a volume.",
     .glState = "colour and depth writes off, depth LESS, stencil depth-fail INCR_WRAP (back) and DECR_WRAP (front), "
                "depth clamp for what reaches infinity",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {3, 5},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = n_b - n_f, of the faces behind the point",
     .anchors = "count-failing extrude"},
    {.id = "volumes-back",
     .title = "Render all volume faces that face away from the viewer",
     .why = "The stencil goes up by one for each point that fails the depth test.",
     .glState = "colour and depth writes off, cull FRONT, depth LESS, stencil depth-fail INCR_WRAP",
     .perLight = true,
     .shownBy = "stencil-back",
     .pseudocodeLines = {3, 4},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = stencil + 1 where a back face fails the depth test: n_b",
     .anchors = "count-one-side count-failing extrude",
     .values = kAfterBacks},
    {.id = "volumes-front",
     .title = "Render all volume faces that face toward the viewer",
     .why = "The stencil goes down by one for each point that fails the depth test: faces in front and behind cancel.",
     .glState = "colour and depth writes off, cull BACK, depth LESS, stencil depth-fail DECR_WRAP",
     .perLight = true,
     .shownBy = "stencil",
     .pseudocodeLines = {5, 5},
     .formula = "P' = P + d (P - P_L) / |P - P_L|, or at infinity P' = (P - P_L, 0)\n"
                "stencil = stencil - 1 where a front face fails the depth test: n_f",
     .anchors = "count-one-side count-failing extrude"},
    kRepairPass,
    {.id = "light",
     .title = "Render the scene again with the light turned on, only where the stencil is zero",
     .why = "As many faces entered as left: the point is outside every volume, so the light sees it.",
     .glState = "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true,
     .pseudocodeLines = {6, 7},
     .formula = "illuminated if stencil = 0, n_f = n_b\n"
                "L = L + visibility * color * E * (diffuse / pi + specular * (s + 8) / (8 pi) * (n.h)^s)",
     .anchors = "light-where-zero shade-light"},
};

const StageInfo kZFailStages[] = {
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
    [[nodiscard]] CountMethod countMethodOf(const scene::Scene&, const dvec3&, const CasterVolume&,
                                            int) const override {
        return CountMethod::zFail;
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

ZFail::ZFail()
    : VolumeTechnique({.passes = kZFailPasses,
                       .both = {"volumes"},
                       .first = {"volumes-back", GL_FRONT},
                       .second = {"volumes-front", GL_BACK},
                       .stageAfterFirst = "stencil-back"}) {}

params::ParamList ZFail::params() {
    params::ParamList list = sharedParams();
    list.push_back(params::boolean(
        "caps", params_.caps, "Close the volumes with top and bottom caps; false: depth fail miscounts (teaching)."));
    list.push_back(params::inGroup(
        params::kTeachingSwitches,
        params::choice({"depth-test", "Depth test of volume faces"}, params_.depthTest,
                       {{"less", "LESS"}, {"lequal", "LEQUAL"}},
                       "With LEQUAL top caps fight for depth with the surface that they lie on (teaching).")));
    list.push_back(params::inGroup(
        params::kTeachingSwitches,
        params::choice(
            {"far-plane", "Far plane"}, params_.farPlane,
            {{"infinite-and-clamp", "at infinity, depth clamp"},
             {"infinite", "at infinity"},
             {"clamp", "depth clamp"},
             {"clip", "cuts volumes open"}},
            "What keeps the far plane from cutting volumes open: a projection with the far plane at infinity, depth "
            "clamp, or both; clip: nothing, which shows with volume-end infinity (teaching).")));
    return list;
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
        .passes = {std::begin(kZFailPasses), std::end(kZFailPasses)},
        .stages = {std::begin(kZFailStages), std::end(kZFailStages)},
        .pseudocode = kStencilSteps,
        .values = {{"stencil", "stencil"}, {"n_b - n_f", "z-fail, point to infinity"}},
        .sweeps = {{.title = "Counted behind", .varies = "repair", .values = "false true"}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ZFail>(); },
    };
}

} // namespace shadowlab::shadow_volume
