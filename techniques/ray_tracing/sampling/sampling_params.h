// The knobs of distributed ray tracing: how many rays a pixel gets, and what they are spread over.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/model/camera.h"
#include "techniques/ray_tracing/sampling/sampled_picture.h"

namespace shadowlab::ray_tracing {

struct SamplingParams {
    SamplePattern pattern;
    bool antialias = true;
    // Of what spreads, all that a scene asks for by its lights, its materials and its velocities is on: a scene without them pays
    // nothing. A lens is the viewer's choice.
    enum class SoftShadows { sampled, analytic, off } softShadows = SoftShadows::sampled;
    bool gloss = true, translucency = true;
    double aperture = 0, focus = 0; ///< metres; focus 0: where the camera's target is
    double shutter = 1;
    bool wholeLobes = true, interreflection = false;
    bool adaptive = false;
    double tolerance = 1;
    friend bool operator==(const SamplingParams&, const SamplingParams&) = default;

    [[nodiscard]] bool areMany() const { return pattern.count > 1; }
    /// With one sample, too.
    [[nodiscard]] bool isAnalytic() const { return softShadows == SoftShadows::analytic; }
    /// `tree`: what does not depend on chance.
    [[nodiscard]] SampledSettings settings(const TreeSettings& tree, const scene::Camera& camera) const;
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(SamplingParams& params);

} // namespace shadowlab::ray_tracing
