// What z-pass and z-fail share: the passes around the count, the stages, and the probe of a pixel.
//
// Depth pass (zpass.cpp) counts the volume faces between the eye and the visible point, depth fail (zfail.cpp) those behind
// the point. Both count the faces of the same volumes into the stencil, and light the pixels in which the count is zero.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/frame.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/shading_passes.h"
#include "techniques/shadow_volume/count/float_count.h"
#include "techniques/shadow_volume/cull/casters.h"
#include "techniques/shadow_volume/probe/stage_pictures.h"
#include "techniques/shadow_volume/repair/repair_pass.h"
#include "techniques/shadow_volume/volume_params.h"

namespace shadowlab::shadow_volume {

/// A pass that counts volume faces, and the side that it culls; GL_NONE: it counts both sides at once.
struct CountPass {
    std::string_view id;
    GLenum culled = GL_NONE;
};

/// The passes that count: one for both sides, or the lecture's two steps.
struct Counting {
    std::span<const PassInfo> passes; ///< of the technique
    CountPass both, first, second;
    std::string_view stageAfterFirst; ///< the stage that shows the count between the two steps
};

class VolumeTechnique : public Technique {
public:
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override;
    Progress render(Frame& frame) override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot& snapshot, const View& view, int light) override;
    std::string remark(const scene::MeshReport& report, const scene::Mesh& mesh) const override;

protected:
    explicit VolumeTechnique(const Counting& counting, const VolumeParams& defaults = {})
        : counting_(counting), params_(defaults) {}

    /// How a caster's volume is counted.
    [[nodiscard]] virtual CountMethod countMethodOf(const scene::Scene& scene, const dvec3& eyeWorld,
                                                    const CasterVolume& caster, int light) const = 0;
    [[nodiscard]] CountRules rules() const { return {passRule(), failRule()}; }
    [[nodiscard]] virtual PassRule passRule() const { return {}; }
    [[nodiscard]] virtual FailRule failRule() const { return {}; }
    /// Culls volumes that reach no receiver in view, and ends the others just beyond the receivers in view. The count is
    /// then undefined in the rest of the picture; so this is not for a technique whose count starts with the number of
    /// volumes around the eye.
    [[nodiscard]] virtual bool keepsToReceiversInView() const { return false; }
    /// Draws with the near plane of the view, which cuts volumes. Otherwise the near plane is moved out to the nearest
    /// surface.
    [[nodiscard]] virtual bool usesNearPlaneOfView() const { return false; }
    /// True where the method differs between casters: only then the stage that shows it is drawn.
    [[nodiscard]] virtual bool showsCountMethods() const { return false; }
    /// True if the technique draws caps.
    [[nodiscard]] virtual bool showsCaps() const { return true; }

    params::ParamList sharedParams() { return describe(params_); }
    /// True if volumes end at a fixed distance from the caster.
    [[nodiscard]] bool endsAtDistance() const { return params_.end == VolumeParams::End::distance; }

private:
    [[nodiscard]] ShownVolume shownVolume() const;
    [[nodiscard]] std::vector<const CasterVolume*> usefulCasters(int light) const;
    void keepWhatRests(const Frame& frame);
    void findReceivers(const scene::Scene& scene, const gl::EyeMatrices& eye);
    [[nodiscard]] VolumeEnd endOf(const CasterVolume& caster, const scene::Light& light) const;
    [[nodiscard]] VolumeInView inView(const gl::EyeMatrices& eye, const CasterVolume& caster,
                                      const scene::Light& light) const;
    [[nodiscard]] bool counts(const CasterVolume& caster, CountMethod method) const;
    /// The volumes of one light that can change a pixel.
    struct ChosenVolumes {
        std::vector<CountedVolume> volumes;
        int startCount = 0; ///< the stencil starts with this: how many of the volumes counted with depth pass the eye is in
        /// Outside of it nothing is counted, or nothing that matters; none: that is not known of any place.
        std::optional<scene::PicturePart> part = std::nullopt;
    };
    [[nodiscard]] static std::optional<scene::PicturePart> countedPart(const ChosenVolumes& chosen);
    ChosenVolumes chosen(const Frame& frame, int light);
    void chooseVolumes(Frame& frame, int light);
    void clearAndCount(Frame& frame, int light);
    void clearCount(Frame& frame, int light);
    [[nodiscard]] bool countsInFloats(int light) const;
    void publishCount(Frame& frame, std::string_view stage, int light, bool bothSigns);
    void count(Frame& frame, const CountPass& pass, int light);
    void repair(Frame& frame, int light);
    void light(Frame& frame, int light) const;
    void drawLit(Frame& frame, const gl::Program& program, int light) const;
    bool publishVisibility(Frame& frame, int light);
    bool publishStencilStages(Frame& frame, int light);
    void publishOverPicture(Frame& frame, int light);

    // volume_probe.cpp
    [[nodiscard]] VolumeProbe probeVolumes(const scene::Scene& scene, const View& view, const trace::EyeHit& hit,
                                           int light);
    [[nodiscard]] std::string whyWrong(const VolumeProbe& volume, bool isLit) const;

    const Counting counting_;
    VolumeParams params_;
    Casters casters_;
    std::vector<scene::Bounds> receiversInView_; ///< around what of each may be seen
    scene::Bounds allReceiversInView_;
    ChosenVolumes chosen_; ///< of the current light
    FaceCounter counter_;
    FloatCount floats_;
    StencilledPasses passes_;
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    StagePictures pictures_;
    RepairPass repair_;
    /// All that the counts of a frame depend on: while this key is the same, they are kept.
    struct CountCacheKey {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0}, regionCorner{0}, regionSize{0};
        VolumeParams params;
        CountRules rules;
        std::uint64_t castersRevision = 0;
        int shaderReloads = 0;
        friend bool operator==(const CountCacheKey&, const CountCacheKey&) = default;
    };
    CountCacheKey countCacheKey_;       ///< the key of kept_
    std::map<int, ChosenVolumes> kept_; ///< per light
};

} // namespace shadowlab::shadow_volume
