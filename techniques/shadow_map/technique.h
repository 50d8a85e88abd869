// Shadow mapping: ask a depth picture taken from the light whether something stands between the light and the point.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>

#include "techniques/frame.h"
#include "techniques/shadow_map/exact/exact_pass.h"
#include "techniques/shadow_map/filters/moment_maps.h"
#include "techniques/shadow_map/fit/fit.h"
#include "techniques/shadow_map/fit/shadowed_part.h"
#include "techniques/shadow_map/irregular/alias_free_pass.h"
#include "techniques/shadow_map/maps/kept_maps.h"
#include "techniques/shadow_map/receiver_uniforms.h"

namespace shadowlab::shadow_map {

constexpr int kDecidedUnit = kMapUnit + 5, kMomentsUnit = kMapUnit + 6;

/// A light as its map is asked: where it stands, whose shadows may matter, and how the answers become one.
struct AskedLight {
    scene::Light light;
    std::vector<std::size_t> casters; ///< objects whose shadow can fall on something
    FilterParams filter;
};

/// One light's map: its cameras, and the depths themselves.
struct DrawnMap {
    LightMaps maps;
    AskedLight asked;
    const gl::DepthTextureArray* depth = nullptr;
    const ExactMap* exact = nullptr;
    KeptMap* kept = nullptr;                        ///< where it is kept, if it is
    const gl::ColorTextureArray* moments = nullptr; ///< of the depths, where the filter asks for them
    const gl::Texture2D* decided = nullptr;         ///< visibility of every pixel, where it is known already
};

/// Modes of shaders/shadow_map/project.frag: where the points are, relative to the light; the depths they are compared with.
constexpr int kProjectedPosition = 3, kProjectedPlane = 4;

/// Which part of a map is asked for one point: a parallelogram, or the ellipse in it.
struct KernelShape {
    int layer = 0;
    dvec2 middleUv{0.0}, halfU{0.0}, halfV{0.0};
    bool isRound = false;
    vec3 plane{0.0f}; ///< depth that the point is compared with, and how it varies with u and v on the point's plane
};

/// What was in the picture that was drawn last: the cascades may depend on it.
struct SeenDepth {
    scene::Camera camera;
    ivec2 size{0};
    dvec2 range{0.0}; ///< metres along the eye's axis
};

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
    /// One choice on each axis: a file of GLSL for each, put together once.
    struct Choice {
        Layout layout;
        BiasParams::Mode bias;
        FilterParams::Kind filter;
        bool inWorld; ///< see ShadowMapParams::looksUpInWorld
        friend auto operator<=>(const Choice&, const Choice&) = default;
    };
    struct Programs {
        gl::Program shade, visibility, project, texelSize, layers, penumbra, kernel, decide;
    };
    inline static const std::vector<gl::Substitution> kDecided{{"shadow_visibility.glsl", "shadow_map/decided.glsl"}};
    static Programs makePrograms(const Choice& choice);
    /// A map beside those that are kept.
    struct OwnMap {
        gl::DepthTextureArray depth;
        GLenum format = GL_NONE;
        std::optional<gl::ColorTextureArray> moments;
    };
    const Programs& programsFor(const DrawnMap& map);

    // maps_of_frame.cpp
    void lookAt(const Frame& frame);
    [[nodiscard]] AskedLight asked(const scene::Scene& scene, int light) const;
    LightMaps fit(const scene::Scene& scene, const View& view, const AskedLight& asked,
                  std::span<const scene::Bounds> receivers, FitRequest::Cover cover) const;
    [[nodiscard]] std::vector<scene::Bounds> receiversInView(const scene::Scene& scene, const View& view) const;
    std::vector<std::size_t> castersOf(const scene::Scene& scene, const LightMaps& maps, const AskedLight& asked,
                                       int layer) const;
    DrawnMap updateMap(Frame& frame, int light);
    const gl::ColorTextureArray& updateMoments(Frame& frame, KeptMap& kept, const LightMaps& maps);
    const gl::Program& lightProgram(const DrawnMap& map, bool visibilityOnly);

    // drawn_passes.cpp
    [[nodiscard]] std::vector<Probe::DrawnPass> drawnPasses(const scene::Scene& scene, const View& view) const;

    // averaged_light.cpp
    [[nodiscard]] bool averagesOver(const scene::Light& light) const;
    DrawnMap drawAnew(const Frame& frame, const AskedLight& asked, const LightMaps& maps, OwnMap& own);
    const gl::Texture2D& averageOverLight(Frame& frame, int light);

    // exact_light.cpp
    const gl::Texture2D& decide(Frame& frame, int light, const DrawnMap& map);
    void publishTraced(Frame& frame, int light, const DrawnMap& map);
    void drawExact(const Frame& frame, int light, const LightMaps& maps, int layer,
                   std::span<const std::size_t> casters, const gl::DepthTextureArray& depth, const ExactMap& exact);
    [[nodiscard]] std::vector<std::size_t> drawnCasters(const scene::Scene& scene, int light) const;
    void setExactUniforms(const gl::Program& program, int light, const DrawnMap& map) const;
    void setObjectUniforms(const Frame& frame, const gl::Program& program, int light, std::size_t index) const;

    [[nodiscard]] std::vector<Asking> askings(const Frame& frame, const LightMaps& maps) const;
    /// Draws the receivers: with `asking` where a shadow may fall, with `plain` elsewhere.
    void drawAsked(const Frame& frame, const gl::Program& asking, const gl::Program& plain, int light,
                   const DrawnMap& map);
    /// `setUniforms`: those of the program that are not the same for all.
    void drawReceivers(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map,
                       const std::function<void()>& setUniforms = {});
    void useForReceivers(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map) const;
    bool setReceiver(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map,
                     std::size_t object) const;

    // stages.cpp
    void publishStages(Frame& frame, int light, const DrawnMap& map);
    void publishWithoutShadows(Frame& frame) const;
    DrawnMap lessonMap(const Frame& frame, int light, const DrawnMap& map, gl::DepthTextureArray& depth);
    void publishLightView(Frame& frame, int light, const DrawnMap& map) const;
    void publishLightDepth(Frame& frame, int light, const DrawnMap& map, const Display& range) const;
    void publishProjected(Frame& frame, int light, const DrawnMap& map, const Display& range);
    void drawProjected(const Frame& frame, int light, const DrawnMap& map, int mode);
    std::vector<vec4> projectedTexels(const Frame& frame, int light, const DrawnMap& map, int mode);
    Display distanceRange(const Frame& frame, int light, const DrawnMap& map);

    // filter_stages.cpp
    void publishFilterStages(Frame& frame, int light, const DrawnMap& map);
    void publishMoments(Frame& frame, int light, const DrawnMap& map);
    gl::Texture2D drawPenumbra(const Frame& frame, int light, const DrawnMap& map, int mode);
    void publishPenumbra(Frame& frame, int light, const DrawnMap& map, std::string_view stage, int mode);
    void publishKernel(Frame& frame, int light, const DrawnMap& map);
    std::optional<KernelShape> kernelShape(const Frame& frame, int light, const DrawnMap& map, ivec2 pixel);

    // texel_size.cpp
    void publishTexelStages(Frame& frame, int light, const DrawnMap& map);
    gl::Texture2D drawTexelSizes(const Frame& frame, int light, const DrawnMap& map);
    void publishLayers(Frame& frame, int light, const DrawnMap& map, std::string_view stage, int squareTexels);

    ShadowMapParams params_;
    scene::Snapshot preparedFor_;
    std::vector<scene::Bounds> bounds_;                   ///< of all objects
    std::vector<std::vector<std::size_t>> usefulCasters_; ///< per light: those whose shadow can fall on something
    std::optional<SeenDepth> seen_;
    /// All that the fit of a frame's maps depends on.
    struct FittedFor {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0};
        ShadowMapParams params;
        std::optional<dvec2> visibleDepth;
        std::vector<bool> mayLight; ///< by light
        friend bool operator==(const FittedFor&, const FittedFor&) = default;
    };
    std::vector<LightMaps> fitted_; ///< per light, for the frame that is drawn
    FittedFor fittedFor_;
    std::map<int, std::vector<Asking>> askings_; ///< per light: how objects ask the fitted maps, once they have
    KeptMaps kept_;
    DepthPass depthPass_;
    MomentMaker momentMaker_;
    ExactPass exact_;
    AliasFreePass aliasFree_;
    gl::Texture2D averaged_; ///< visibility of one light, while it is drawn
    std::map<Choice, Programs> programs_;
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program unshadowed_{"surface.vert", "shade_light.frag"};
    gl::Program unshadowedVisibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    gl::Program decidedShade_{"surface.vert", "shade_light.frag", {}, kDecided};
    gl::Program decidedVisibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}, kDecided};
    gl::Program showMoments_{"fullscreen.vert", "shadow_map/show_moments.frag"};
    gl::Program showDepth_{"fullscreen.vert", "shadow_map/show_depth.frag"};
};

} // namespace shadowlab::shadow_map
