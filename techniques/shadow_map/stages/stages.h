// The stages of shadow mapping: pictures of what the passes made and read. None of them changes the picture itself.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_map/map_tools.h"
#include "techniques/shadow_map/stages/shown_maps.h"

namespace shadowlab::shadow_map {

/// The lecture's row of pictures, in its order.
class LessonStages {
public:
    explicit LessonStages(MapTools& tools) : tools_(tools) {}
    void publishWithoutShadows(Frame& frame) const;
    void publish(Frame& frame, int light, const LightShadowMap& map);
    /// Where the probe's point is in the pictures taken from the light.
    void addPlaces(Probe& probe, int light, const View& view) const;

private:
    LightShadowMap lessonMap(const Frame& frame, int light, const LightShadowMap& map, gl::DepthTextureArray& depth);
    void publishLightView(Frame& frame, int light, const LightShadowMap& map) const;
    void publishLightDepth(Frame& frame, int light, const LightShadowMap& map, const Display& range) const;
    void publishProjected(Frame& frame, int light, const LightShadowMap& map, const Display& range);
    Display distanceRange(const Frame& frame, int light, const LightShadowMap& map);

    MapTools& tools_;
    ShownMaps shown_;
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program showDepth_{"fullscreen.vert", "shadow_map/show_depth.frag"};
};

/// What filters do: the moments, the search for blockers, the width of the penumbra, the kernel of one pixel.
class FilterStages {
public:
    explicit FilterStages(MapTools& tools) : tools_(tools) {}
    void publish(Frame& frame, int light, const LightShadowMap& map);
    /// Drawn over the finished picture, so it comes after the light's pass.
    void publishKernel(Frame& frame, int light, const LightShadowMap& map);
    /// Where the probe's point is in the picture of the moments.
    void addPlaces(Probe& probe, int light, const View& view) const { shown_.addPlace(probe, "moments", light, view); }

private:
    /// The part of a map that is read for one point: a parallelogram, or the ellipse in it.
    struct KernelShape {
        int layer = 0;
        dvec2 middleUv{0.0}, halfU{0.0}, halfV{0.0};
        bool isRound = false;
        vec3 plane{0.0f}; ///< see Projected::plane
    };
    std::optional<KernelShape> kernelShape(const Frame& frame, int light, const LightShadowMap& map, ivec2 pixel);
    void publishMoments(Frame& frame, int light, const LightShadowMap& map);
    void publishPenumbra(Frame& frame, int light, const LightShadowMap& map, std::string_view stage, int mode);
    gl::Texture2D drawPenumbra(const Frame& frame, int light, const LightShadowMap& map, int mode);

    MapTools& tools_;
    ShownMaps shown_;
    gl::Program showMoments_{"fullscreen.vert", "shadow_map/moments/show_moments.frag"};
};

/// How the texels of the maps lie on what the eye sees: how large they are, and which map they belong to.
void publishTexelStages(MapTools& tools, Frame& frame, int light, const LightShadowMap& map);

} // namespace shadowlab::shadow_map
