// Shadow mapping: ask a depth picture taken from the light whether something stands between the light and the point.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/shadow_map/light_maps.h"

namespace shadowlab::shadow_map {

struct ShadowMapParams {
    int resolution = 2048;
    enum class DepthFormat { fixed16, fixed24, float32 } depthFormat = DepthFormat::fixed24;
    enum class Filter { hard, pcf } filter = Filter::pcf;
    int pcfRadius = 1;
    double slopeBias = 1.0;
    double constantBias = 1.0;
    bool cull = true;
    friend bool operator==(const ShadowMapParams&, const ShadowMapParams&) = default;
    /// As OpenGL names it.
    [[nodiscard]] GLenum glDepthFormat() const {
        return depthFormat == DepthFormat::fixed16   ? GL_DEPTH_COMPONENT16
               : depthFormat == DepthFormat::fixed24 ? GL_DEPTH_COMPONENT24
                                                     : GL_DEPTH_COMPONENT32F;
    }
    [[nodiscard]] int kernelRadius() const { return filter == Filter::pcf ? pcfRadius : 0; }
};

/// One light's map: its cameras, what is drawn into it, and the depths themselves.
struct DrawnMap {
    LightMaps maps;
    std::vector<std::size_t> casters;
    const gl::DepthTextureArray* depth = nullptr;
};

/// All that a drawn map depends on. The camera is not part of it: maps are fitted to the scene.
struct MapOrigin {
    scene::Revisions revisions;
    int light = kNoLight;
    ShadowMapParams params;
    int shaderReloads = 0;
    friend bool operator==(const MapOrigin&, const MapOrigin&) = default;
};

/// A map, and what it was drawn from: as long as that stays, so does the map, wherever the eye goes.
struct KeptMap {
    gl::DepthTextureArray depth;
    GLenum format = GL_NONE; ///< of the depths
    std::optional<MapOrigin> drawnFrom;
};

/// What one light needs, as long as neither the scene nor the map's size changes.
struct PreparedLight {
    LightMaps maps;
    std::vector<std::size_t> usefulCasters; ///< those whose shadow can fall on something
};

class ShadowMap final : public Technique {
public:
    params::ParamList params() override;
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override;
    Progress render(Frame& frame) override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot& snapshot, const View& view, int light) override;
    std::string remark(const scene::MeshReport& report) const override;

private:
    void choosePrograms();
    DrawnMap chooseMap(Frame& frame, int light);
    KeptMap& keptMap(int light);
    void redrawUnlessKept(Frame& frame, int light, const DrawnMap& map);
    void drawDepth(const Frame& frame, const DrawnMap& map) const;
    void drawReceivers(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map) const;

    void publishTexelSize(Frame& frame, int light, const DrawnMap& map) const; // texel_size.cpp

    // stages.cpp
    void publishStages(Frame& frame, int light, const DrawnMap& map);
    void publishWithoutShadows(Frame& frame) const;
    DrawnMap lessonMap(const Frame& frame, int light, const DrawnMap& map, gl::DepthTextureArray& depth) const;
    void publishLightView(Frame& frame, int light, const DrawnMap& map) const;
    void publishLightDepth(Frame& frame, int light, const DrawnMap& map, const Display& range) const;
    void publishProjected(Frame& frame, int light, const DrawnMap& map, const Display& range) const;
    void drawProjected(const Frame& frame, int light, const DrawnMap& map, int mode) const;
    std::vector<vec4> projectedTexels(const Frame& frame, int light, const DrawnMap& map, int mode) const;
    Display distanceRange(const Frame& frame, int light, const DrawnMap& map) const;

    ShadowMapParams params_;
    scene::Snapshot preparedFor_;
    std::pair<int, int> preparedSize_; ///< resolution and kernel radius
    std::vector<PreparedLight> prepared_;
    Display shownDistance_;                               ///< scale of the current light's depth pictures
    std::optional<ShadowMapParams::Filter> chosenFilter_; ///< that shade_ and visibility_ were made for
    std::vector<KeptMap> maps_;
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program unshadowed_{"surface.vert", "shade_light.frag"};
    gl::Program depth_{"position.vert", "nothing.frag"};
    gl::Program project_{"surface.vert", "shadow_map/project.frag"};
    gl::Program texelSize_{"surface.vert", "shadow_map/texel_size.frag"};
    gl::Program showDepth_{"fullscreen.vert", "shadow_map/show_depth.frag"};
    gl::Program shade_, visibility_; ///< with the chosen filter
};

} // namespace shadowlab::shadow_map
