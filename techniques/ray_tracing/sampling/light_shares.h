// How much of a light's area each pixel sees: at the pixel's centre, through a pinhole, with everything as it stands, so that it
// can be held against the exact share. Found with samples, at the places on the light that the picture's own rays go to; or in
// closed form, and with it what the pixel receives.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/picture.h"

namespace shadowlab::ray_tracing {

class LightShares {
public:
    void restart(ivec2 size, int light);
    /// Goes on until every pixel is asked (true) or the time has come (false), but always a bit.
    bool advance(const Surfaces& surfaces, const Picture& picture, const scene::Camera& camera,
                 const SamplePattern& pattern, Deadline deadline);
    /// The same in closed form.
    bool advance(const Surfaces& surfaces, const Picture& picture, const scene::Camera& camera,
                 const trace::AreaVisibility& area, Deadline deadline);
    [[nodiscard]] int light() const { return light_; }
    /// 0..1; of a pixel that was not asked yet, and of lights without an area, what the light's centre says.
    [[nodiscard]] const Grid<float>& shares() const { return shares_; }
    /// In closed form only: trace::AreaIrradiance::irradiance of each pixel.
    [[nodiscard]] const Grid<float>& irradiances() const { return irradiances_; }

private:
    int light_ = -1;
    Grid<float> shares_, irradiances_;
    std::size_t next_ = 0;
};

/// Of all places on the light that the samples chose, the share that is seen from the point, weighted by the area that each stands
/// for: exactly 0 in the umbra and exactly 1 where nothing hides the light. Up to 1 / N too large or too small in the mean.
double sampledShare(const RayWorld& world, const trace::SurfacePoint& point, const dvec3& toViewerWorld, int light,
                    const SamplePattern& pattern, ivec2 pixel);

} // namespace shadowlab::ray_tracing
