// The parameters of the maps. They form three groups that can be combined freely: projection, bias and filter.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/scene/query/light_points.h"
#include "techniques/shadow_map/bias/biases.h"
#include "techniques/shadow_map/filters/filter_params.h"

namespace shadowlab::shadow_map {

/// What the light's cameras look at, and how the area is shared out among texels.
struct ProjectionParams {
    enum class Fit { view, scene } fit = Fit::view;
    int cascades = 1;
    double splitMix = 0.8;
    enum class DepthBounds { picture, receivers, camera } depthBounds = DepthBounds::picture;
    bool stable = true;
    double cascadeBlend = 0.1;
    enum class Warp { none, lispsm } warp = Warp::none;
    enum class DepthRange { fitted, wide } depthRange = DepthRange::fitted;
    enum class CubeSeams { guarded, bare } cubeSeams = CubeSeams::guarded;
    friend bool operator==(const ProjectionParams&, const ProjectionParams&) = default;
};

struct ShadowMapParams {
    int resolution = 2048;
    enum class DepthFormat { fixed16, fixed24, float32 } depthFormat = DepthFormat::fixed24;
    ProjectionParams projection;
    BiasParams bias;
    FilterParams filter;
    scene::LightPointParams lightPoints;
    bool depthClamp = true;
    enum class Border { lit, edge } border = Border::lit;
    enum class Coordinates { light, world } coordinates = Coordinates::light;
    bool rejectBehind = true;
    bool cull = true;
    dvec2 kernelAt{0.5};
    friend bool operator==(const ShadowMapParams&, const ShadowMapParams&) = default;

    /// Are points looked up as floats relative to the world's origin? It is a fault for teaching.
    [[nodiscard]] bool looksUpInWorld() const { return coordinates == Coordinates::world; }
    /// As OpenGL names it.
    [[nodiscard]] GLenum glDepthFormat() const;
};

/// Those of the shadow map: all of them. The descriptions refer to the fields of `params`.
params::ParamList describe(ShadowMapParams& params);

/// Those of the exact map: which map is drawn. What the comparison reads is not offered, and stays as exactMapParams() has it;
/// the faults that are there for teaching are not offered either, because rays would hide them.
params::ParamList describeExact(ShadowMapParams& params);

/// Defaults of the exact map: one texel answers, because an exact answer needs no filter.
ShadowMapParams exactMapParams();

} // namespace shadowlab::shadow_map
