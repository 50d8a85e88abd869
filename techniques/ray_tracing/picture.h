// A picture made of rays, on the processor: what each pixel sees, which light reaches it, and what that looks like.
//
// No GL here. Every function works through the picture in tiles, on all cores; a tile's pixels depend on nothing but
// the scene, so the bytes are the same for any number of threads. Rows count from the top.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::ray_tracing {

/// One value per pixel.
template <typename Value>
using Grid = std::vector<Value>;

/// What came of asking for one light in one pixel.
struct ShadowAnswer {
    trace::Visibility visibility = trace::Visibility::noSurface;
    bool asked = false; ///< was a shadow ray sent at all?
};

class Picture {
public:
    /// One eye ray through the centre of every pixel (Appel, 1968).
    void traceEyeRays(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size);
    /// One shadow ray from every point that faces the light (Whitted, 1980).
    void traceShadowRays(const trace::SceneTracer& tracer, int light, trace::ShadowStart start);

    /// Fills the radiance with what is seen with all lights off.
    void shadeLightsOff(const trace::SceneTracer& tracer);
    /// Adds a light, by the answers of traceShadowRays for it.
    void shadeLight(const trace::SceneTracer& tracer, int light);

    [[nodiscard]] ivec2 size() const { return size_; }
    [[nodiscard]] const Grid<trace::SurfacePoint>& points() const { return points_; }
    [[nodiscard]] const Grid<ShadowAnswer>& answers() const { return answers_; }
    [[nodiscard]] const Grid<vec3>& radiance() const { return radiance_; }

private:
    ivec2 size_{0};
    dvec3 eyeWorld_{0.0};
    Grid<trace::SurfacePoint> points_;
    Grid<ShadowAnswer> answers_;
    Grid<vec3> radiance_;
    std::vector<dmat3> normalWorldFromMesh_; ///< per object
};

} // namespace shadowlab::ray_tracing
