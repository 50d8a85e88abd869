// A picture traced on the processor: what each pixel sees, which lights reach it, and the shading of it.
//
// No GL here. Every function works through the picture in blocks, on all cores; the pixels of a block depend on nothing but the
// scene, so the bytes are the same for any number of threads. Rows count from the top, except those of the radiance.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/ray_tracing/tree/ray_tree.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// One value per pixel.
template <typename Value>
using Grid = std::vector<Value>;

/// Which rays to send, and how.
struct TraceSettings {
    trace::ShadowStart start = trace::ShadowStart::exact;
    /// For each pixel the triangle that it is expected to show (gl::IdBuffer); empty: unknown.
    std::span<const std::uint32_t> receivers;
};

class Picture {
public:
    /// Clears everything: for another scene, camera or size.
    void restart(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size);
    /// Clears what depends on lights, and keeps where eye rays have ended: for a scene of which only the lights are others.
    void restartLights(const trace::SceneTracer& tracer);

    /// One eye ray through the centre of every pixel (Appel, 1968) and, from every point that faces a light, one shadow ray to it
    /// (Whitted, 1980), block by block while the points are in the cache. Eye rays whose ends are known are not traced again. Continues where it was interrupted until all is traced
    /// (true) or the deadline has passed (false), but always does some work; what is not traced yet is empty.
    bool trace(const trace::SceneTracer& tracer, const TraceSettings& settings, Deadline deadline);
    [[nodiscard]] bool isTraced() const { return tracedBlocks_ == blocks(); }

    /// Sets the radiance to that with all lights off.
    void shadeLightsOff(const Surfaces& surfaces);
    /// Adds a light where its shadow rays arrive.
    void shadeLight(const Surfaces& surfaces, int light);
    /// Adds a light with an area, by its irradiance at each pixel (trace::AreaIrradiance::irradiance); empty: not known yet.
    void shadeAreaLight(const Surfaces& surfaces, int light, const Grid<float>& irradiances);

    /// Traces the trees of all pixels whose eye ray splits, or is attenuated, and replaces their radiance by the result. All
    /// other pixels are unchanged. Continues like trace(), and starts when that is finished.
    bool traceTrees(const RayWorld& world, const TreeSettings& settings, Deadline deadline);
    /// The share of both steps that is done, 0..1.
    [[nodiscard]] double done(bool withTrees) const;

    [[nodiscard]] ivec2 size() const { return size_; }
    [[nodiscard]] const scene::Camera& camera() const { return camera_; }
    [[nodiscard]] const Grid<trace::SurfacePoint>& points() const { return points_; }
    [[nodiscard]] const Grid<trace::Visibility>& visibility(int light) const {
        return visibility_[static_cast<std::size_t>(light)];
    }
    /// Row 0 is at the bottom, as GL wants it.
    [[nodiscard]] const Grid<vec3>& radianceFromBelow() const { return radiance_; }
    /// The light that came by the root's reflection ray, and by its refraction ray; row 0 is at the bottom. Empty: no trees.
    [[nodiscard]] const Grid<vec3>& reflectedFromBelow() const { return reflected_; }
    [[nodiscard]] const Grid<vec3>& transmittedFromBelow() const { return transmitted_; }
    /// The levels of each pixel's tree: 1 for a ray that does not split, 0 for one that hits nothing.
    [[nodiscard]] int levels(std::size_t pixel) const {
        return levels_.empty() ? (points_[pixel] ? 1 : 0) : levels_[pixel];
    }
    /// How many rays were traced below the eye rays.
    [[nodiscard]] std::size_t secondaryRays() const { return secondaryRays_; }
    [[nodiscard]] std::size_t trees() const { return trees_; }

private:
    [[nodiscard]] std::size_t blocks() const;
    void clearFrom(std::size_t firstBlock);
    void traceEyeRays(const trace::SceneTracer& tracer, const trace::EyeRays& rays, const TraceSettings& settings, ivec2 corner,
                      ivec2 blockSize, std::span<trace::SurfacePoint> points) const;

    ivec2 size_{0};
    scene::Camera camera_;
    Grid<trace::SurfacePoint> points_; ///< in double, for shadow rays start from them
    std::vector<Grid<trace::Visibility>> visibility_; ///< per light
    Grid<vec3> radiance_;
    Grid<vec3> intensities_; ///< of trees; row 0 is at the bottom
    Grid<vec3> reflected_, transmitted_;
    Grid<std::uint8_t> levels_;
    std::size_t seenBlocks_ = 0;                    ///< blocks whose eye rays are traced
    std::size_t tracedBlocks_ = 0, treeBlocks_ = 0; ///< how many blocks are done, shadow rays and all
    std::size_t trees_ = 0, secondaryRays_ = 0;
};

} // namespace shadowlab::ray_tracing
