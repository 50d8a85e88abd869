// A scene that can be asked with rays: what is visible, and what a light sees. Built in slices, again only when the
// scene has changed; then asked by any number of threads.
//
// No epsilon anywhere: a shadow ray starts on the surface itself and leaves out the triangle it starts on, by number.
// An offset along the normal would have to grow with the distance from the origin, and push the ray through thin walls.
// What "in shadow" means is said in docs/conventions.md, and judged by exact_visibility.h, which shares no code with
// this.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/foundation/trace/bvh_build.h"
#include "techniques/foundation/trace/exact_visibility.h"
#include "techniques/foundation/trace/eye_rays.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::trace {

/// Where an eye ray ends. Small, because a picture has a million of them.
struct SurfacePoint {
    std::uint32_t primitive = kNoPrimitive; ///< none: the background
    bool eyeOnFront = false; ///< the eye sees the counter-clockwise side, as the triangle lies in the world
    double distance = 0;     ///< metres from the eye
    dvec2 weights{0.0};      ///< barycentric, of corners a and b
    explicit operator bool() const { return primitive != kNoPrimitive; }
    [[nodiscard]] dvec3 barycentric() const { return {weights, 1.0 - weights.x - weights.y}; }
};

/// How a shadow ray begins.
enum class ShadowStart {
    exact, ///< on the surface in double, its own triangle left out
    naive, ///< at the point rounded to float, nothing left out: the classical fault, for teaching
};

class SceneTracer {
public:
    /// Makes ready for a scene: does what its revisions demand. False when the time came before it was done.
    bool advance(const scene::Snapshot& snapshot, std::chrono::steady_clock::time_point deadline);
    /// Share of the building that is done, 0..1.
    [[nodiscard]] double done() const { return builder_ ? builder_->done() : 1.0; }

    // From here on: after advance() has returned true.
    [[nodiscard]] const scene::Scene& scene() const { return *snapshot_; }
    [[nodiscard]] const Bvh& bvh() const { return bvh_; }
    [[nodiscard]] const WorldTriangles& world() const { return world_; }

    [[nodiscard]] EyeRays eyeRays(const scene::Camera& camera, ivec2 size) const {
        return {camera, size, world_.originWorld};
    }
    [[nodiscard]] SurfacePoint eyePoint(const EyeRays& rays, dvec2 pixel) const;

    [[nodiscard]] dvec3 positionCentred(const SurfacePoint& point) const;
    [[nodiscard]] dvec3 positionWorld(const SurfacePoint& point) const {
        return world_.originWorld + positionCentred(point);
    }
    [[nodiscard]] const scene::Object& objectOf(const SurfacePoint& point) const {
        return snapshot_->objects[world_.objects[point.primitive]];
    }

    /// Does the side that the eye sees face the light, within its cone? Only then a shadow ray is worth sending.
    [[nodiscard]] bool facesLight(const SurfacePoint& point, int light) const;
    /// The triangle that stands between the point and the light's centre, or kNoPrimitive: the first that is found.
    [[nodiscard]] std::uint32_t blocker(const SurfacePoint& point, int light,
                                        ShadowStart start = ShadowStart::exact) const;
    /// Both, and whether the surface receives shadows at all.
    [[nodiscard]] Visibility visibility(const SurfacePoint& point, int light,
                                        ShadowStart start = ShadowStart::exact) const;

    // The same answers for neighbouring pixels at a time, which is quicker.

    /// Where the eye rays end that go through one point of each pixel of a block: `within` counts from the pixel's upper
    /// left corner, (0.5, 0.5) is its centre. `points` holds the block's rows one after the other. Any block size is
    /// right; kBlock on a side is quickest.
    void eyePoints(const EyeRays& rays, ivec2 corner, ivec2 blockSize, dvec2 within,
                   std::span<SurfacePoint> points) const;
    /// visibility() of each point, from an exact start.
    void visibilities(std::span<const SurfacePoint> points, int light, std::span<Visibility> answers) const;
    static constexpr int kBlock = 8;

private:
    void lookAtLights();

    scene::Snapshot snapshot_;
    std::uint64_t geometry_ = 0, transforms_ = 0; ///< revisions that world_ and bvh_ were made for
    WorldTriangles world_;
    std::optional<BvhBuilder> builder_; ///< while building
    Bvh bvh_;
    std::vector<bool> mirrored_;          ///< per object
    struct LightView {                    ///< per light, of each triangle
        std::vector<std::int8_t> facing;  ///< which side the light is on
        std::vector<std::uint8_t> blocks; ///< can it stand in the way?
    };
    std::vector<LightView> lights_;
};

} // namespace shadowlab::trace
