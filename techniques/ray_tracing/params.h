// The parameters of ray tracing: rays and trees, the acceleration structure, and sampling.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/model/camera.h"
#include "techniques/foundation/trace/structures/engine.h"
#include "techniques/ray_tracing/sampling/sampled_picture.h"
#include "techniques/ray_tracing/tree/ray_tree.h"

namespace shadowlab::ray_tracing {

struct RayTracedParams {
    bool excludeSource = true;
    enum class Receivers { traced, idBuffer } receivers = Receivers::traced;
    // The cut-off ends most branches sooner, so a deep tree costs little. In the picture of the built-in scene (640 x 360), 10
    // levels differ from 16 without cut-off by more than 1/255 in one pixel of ten thousand, and there by at most 9/255; 6 levels
    // in one of four hundred, visibly at the rim of the bubble.
    int depth = 10;
    // Half of the smallest step between two 8-bit greys: a smaller contribution is not visible.
    double cutoff = 0.002;
    Fresnel fresnel = Fresnel::exact;
    dvec3 attenuation{1, 0, 0};
    friend bool operator==(const RayTracedParams&, const RayTracedParams&) = default;

    [[nodiscard]] trace::ShadowStart start() const {
        return excludeSource ? trace::ShadowStart::exact : trace::ShadowStart::naive;
    }
    [[nodiscard]] TreeSettings tree() const { return {depth, cutoff, fresnel, attenuation, start()}; }
};

struct StructureParams {
    trace::Structure structure = trace::Structure::bvh;
    enum class Intersection { watertight, naive } intersection = Intersection::watertight;
    double edgeMargin = 0.0;
    friend bool operator==(const StructureParams&, const StructureParams&) = default;
};

struct SamplingParams {
    SamplePattern pattern;
    bool antialias = true;
    // What a scene asks for by its lights, materials and velocities is on by default; a scene without them pays nothing. A lens
    // is the viewer's choice.
    enum class SoftShadows { sampled, analytic, off } softShadows = SoftShadows::sampled;
    bool gloss = true, translucency = true;
    double aperture = 0, focus = 0; ///< metres; focus 0: the distance of the camera's target
    double shutter = 1;
    bool wholeLobes = true, interreflection = false, roulette = true;
    bool adaptive = false;
    double tolerance = 1;
    friend bool operator==(const SamplingParams&, const SamplingParams&) = default;

    [[nodiscard]] bool areMany() const { return pattern.count > 1; }
    /// Lights with an area in closed form, also with a single sample.
    [[nodiscard]] bool isAnalytic() const { return softShadows == SoftShadows::analytic; }
    /// `tree`: the settings that do not depend on sampling.
    [[nodiscard]] SampledSettings settings(const TreeSettings& tree, const scene::Camera& camera) const;
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(RayTracedParams& params);
params::ParamList describe(StructureParams& params);
params::ParamList describe(SamplingParams& params);

} // namespace shadowlab::ray_tracing
