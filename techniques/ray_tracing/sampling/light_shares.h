// The share of a light's area that each pixel sees: at the pixel's centre, through a pinhole, with nothing moving, so that it can
// be compared with the exact share. Estimated with the same points on the light that the picture's shadow rays use; or in closed
// form, which also gives the irradiance.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/picture.h"

namespace shadowlab::ray_tracing {

class LightShares {
public:
    void restart(ivec2 size, int light);
    /// Continues until every pixel is done (true) or the deadline has passed (false), but always does some work.
    bool advance(const Surfaces& surfaces, const Picture& picture, const scene::Camera& camera,
                 const SamplePattern& pattern, Deadline deadline);
    /// The same in closed form.
    bool advance(const Surfaces& surfaces, const Picture& picture, const scene::Camera& camera,
                 const trace::AreaVisibility& area, Deadline deadline);
    [[nodiscard]] int light() const { return light_; }
    /// Of all pixels; before, some shares are those of the light's centre, or none at all.
    [[nodiscard]] bool isComplete() const { return isComplete_; }
    /// 0..1; for pixels that are not done yet, and lights without an area, the visibility of the light's centre.
    [[nodiscard]] const Grid<float>& shares() const { return shares_; }
    /// Only in closed form: trace::AreaIrradiance::irradiance of each pixel.
    [[nodiscard]] const Grid<float>& irradiances() const { return irradiances_; }

private:
    int light_ = -1;
    Grid<float> shares_, irradiances_;
    std::size_t next_ = 0;
    bool isComplete_ = false;
};

/// The share of the sampled points on the light that are visible, weighted by the area that each stands for: exactly 0 in the
/// umbra, and exactly 1 where nothing hides the light. Its bias is at most 1 / N.
double sampledShare(const RayWorld& world, const trace::SurfacePoint& point, const dvec3& toViewerWorld, int light,
                    const SamplePattern& pattern, ivec2 pixel);

} // namespace shadowlab::ray_tracing
