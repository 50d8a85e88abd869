// A scene that can be asked with rays: what is visible, and what a light sees. Built in slices, again only when the
// scene has changed; then asked by any number of threads. Tracers of one scene share what is built (traced_geometry.h).
//
// No epsilon anywhere: a shadow ray starts on the surface itself and leaves out the triangle it starts on, by number.
// An offset along the normal would have to grow with the distance from the origin, and push the ray through thin walls.
// What "in shadow" means is said in docs/conventions.md, and judged by exact_visibility.h, which shares no code with
// this.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <span>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/eye_rays.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/foundation/trace/structures/engine.h"
#include "techniques/foundation/trace/traced_geometry.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::trace {

/// Where an eye ray ends. Small, because a picture has a million of them.
struct SurfacePoint {
    std::uint32_t primitive = kNoPrimitive; ///< none: the background
    bool eyeOnFront = false; ///< the eye sees the counter-clockwise side, as the triangle lies in the world
    dvec2 weights{0.0};      ///< barycentric, of corners a and b
    explicit operator bool() const { return primitive != kNoPrimitive; }
    [[nodiscard]] dvec3 barycentric() const { return {weights, 1.0 - weights.x - weights.y}; }
};

/// How a shadow ray begins.
enum class ShadowStart {
    exact, ///< on the surface in double, its own triangle left out
    naive, ///< at the point rounded to float, nothing left out: the classical fault, for teaching
};

// Nearer than this share of the way to the light is contact, not a crossing: the point itself is only known to about
// 2^-50 of its coordinates, and its neighbours in the same plane would otherwise shadow it by rounding.
constexpr double kContact = 1e-10;

// Toward the sun there is no way to take a share of; the size of the coordinates stands in for it.
constexpr double kContactPerMetre = 1e-12;

class SceneTracer {
public:
    /// Makes ready for a scene: does what its revisions demand. False when the time came before it was done.
    bool advance(const scene::Snapshot& snapshot, std::chrono::steady_clock::time_point deadline);
    /// Share of the building that is done, 0..1.
    [[nodiscard]] double done() const { return builder_ ? builder_->done() : 1.0; }

    /// From the next advance() on casters are whole: shadow rays pass through no hole, eye rays still do. For techniques
    /// whose shadows know nothing of holes.
    void castWhole() { castsWhole_ = true; }

    /// From here on rays are asked of another structure over the same triangles, each alone; nullptr: of the tracer's own tree
    /// again. The answers are the same. The engine must be built, for geometry(), and outlive its use.
    void askInstead(const Engine* engine) { engine_ = engine; }

    // From here on: after advance() has returned true.
    [[nodiscard]] const scene::Scene& scene() const { return *snapshot_; }
    [[nodiscard]] const std::shared_ptr<const TracedGeometry>& geometry() const { return geometry_; }
    [[nodiscard]] const Bvh& bvh() const { return geometry_->bvh; }
    [[nodiscard]] const WorldTriangles& world() const { return geometry_->world; }
    /// No coordinate of a triangle is larger, in centred space.
    [[nodiscard]] double largestCentred() const { return static_cast<double>(bvh().largest); }

    [[nodiscard]] EyeRays eyeRays(const scene::Camera& camera, ivec2 size) const {
        return {camera, size, world().originWorld};
    }
    [[nodiscard]] SurfacePoint eyePoint(const EyeRays& rays, dvec2 pixel) const;
    /// The same where it is known which triangle the ray meets first: only that one is tried, and all where it is missed.
    [[nodiscard]] SurfacePoint eyePointOn(std::uint32_t primitive, const EyeRays& rays, dvec2 pixel) const;

    /// What a ray meets that leaves the point in that unit direction, in whatever way it got there; of equally near triangles
    /// that of the lowest number. Its own triangle is left out, and so is what touches it there: neighbours in the mesh.
    [[nodiscard]] SurfacePoint nextPoint(const SurfacePoint& from, const dvec3& directionWorld) const;
    /// The same from any place, such as the eye itself; `leftOut`: a triangle that is not met.
    [[nodiscard]] SurfacePoint nextPoint(const dvec3& fromCentred, std::uint32_t leftOut,
                                         const dvec3& directionWorld) const;

    // Any rays. `leftOut` is a triangle that is not met, kNoPrimitive: none is.

    /// What the ray meets first; seen from the side that it comes from.
    [[nodiscard]] SurfacePoint met(const Ray& ray, std::uint32_t leftOut) const;
    /// Does anything that casts shadows stand on its way?
    [[nodiscard]] bool isBlocked(const Ray& ray, std::uint32_t leftOut) const;
    /// What an engine over the same triangles is asked for, to answer these two.
    [[nodiscard]] MayHit mayMeet(std::uint32_t leftOut) const { return {.except = leftOut, .holes = &holes_}; }
    [[nodiscard]] MayHit mayStandIn(std::uint32_t leftOut) const { return {leftOut, casts_.data(), &holesForLight_}; }
    /// What a ray of that direction has hit.
    [[nodiscard]] SurfacePoint surfacePoint(const dvec3& directionWorld, const RayHit& hit) const;

    /// Is there a hole in the point's triangle? Where an eye ray ends there never is; for points found in another way.
    [[nodiscard]] bool isInHole(const SurfacePoint& point) const {
        return holes_(point.primitive, point.barycentric());
    }

    /// May a shadow ray pass through that triangle?
    [[nodiscard]] bool mayHaveHoles(std::uint32_t primitive) const { return holesForLight_.in(primitive); }

    [[nodiscard]] dvec3 positionCentred(const SurfacePoint& point) const;
    [[nodiscard]] dvec3 positionWorld(const SurfacePoint& point) const {
        return world().originWorld + positionCentred(point);
    }
    [[nodiscard]] double distance(const EyeRays& rays, const SurfacePoint& point) const {
        return glm::length(positionCentred(point) - rays.eyeCentred());
    }
    [[nodiscard]] const scene::Object& objectOf(const SurfacePoint& point) const {
        return snapshot_->objects[world().objects[point.primitive]];
    }

    /// Does the side that the eye sees face the light, within its cone? Only then a shadow ray is worth sending.
    [[nodiscard]] bool facesLight(const SurfacePoint& point, int light) const;
    /// The triangle that stands between the point and the light's centre, or kNoPrimitive: the first that is found.
    [[nodiscard]] std::uint32_t blocker(const SurfacePoint& point, int light,
                                        ShadowStart start = ShadowStart::exact) const;
    /// Does this one triangle stand there? For who finds out in another way than by a tree which triangles may.
    [[nodiscard]] bool isBlockedBy(std::uint32_t primitive, const SurfacePoint& point, int light) const;
    /// Of each triangle, 1 or 0: can it stand in the light's way at all?
    [[nodiscard]] std::span<const std::uint8_t> blockers(int light) const {
        return lights_[static_cast<std::size_t>(light)].blocks;
    }
    /// Where, on the way from the point to the light's centre, the first thing stands; nothing where the way is free.
    [[nodiscard]] std::optional<dvec3> blockedAtWorld(const SurfacePoint& point, int light) const;
    /// Does it face the light, is it blocked, and does the surface receives shadows at all.
    [[nodiscard]] Visibility visibility(const SurfacePoint& point, int light,
                                        ShadowStart start = ShadowStart::exact) const;

    /// What a structure tries for the eye ray through that point of the picture, and for all shadow rays from where it ends.
    [[nodiscard]] RayTests testsOf(const Engine& engine, const EyeRays& rays, dvec2 pixel) const;

    // The same answers for neighbouring pixels at a time, which is quicker.

    /// Where the eye rays end that go through one point of each pixel of a block: `within` counts from the pixel's upper
    /// left corner, (0.5, 0.5) is its centre. `points` holds the block's rows one after the other. Any block size is
    /// right; kBlock on a side is quickest.
    void eyePoints(const EyeRays& rays, ivec2 corner, ivec2 blockSize, dvec2 within,
                   std::span<SurfacePoint> points) const;
    /// The same where somebody else has said which triangle each ray meets first (kNoPrimitive: none, or not known). A ray
    /// that does hit it ends there, without a look at what may be nearer; all others are traced.
    void eyePointsOn(std::span<const std::uint32_t> primitives, const EyeRays& rays, ivec2 corner, ivec2 blockSize,
                     dvec2 within, std::span<SurfacePoint> points) const;
    /// visibility() of each point, from an exact start.
    void visibilities(std::span<const SurfacePoint> points, int light, std::span<Visibility> answers) const;
    static constexpr int kBlock = kBlockSide;
    /// Which of the functions for blocks to use, where not the quickest: the answers are the same.
    void useBlockKernels(const BlockKernels& kernels) { kernels_ = &kernels; }

private:
    /// What a light can do to a triangle: shine on the side that an eye sees, on its front (as the triangle lies in the
    /// world) or behind it; and put it in shadow.
    enum Gate : std::uint8_t { facesFront = 1, facesBack = 2, receives = 4 };

    void lookAtLights();
    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit) const;
    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit) const;
    /// Without that triangle, what may stand in the light's way.
    [[nodiscard]] MayHit mayBlock(int light, std::uint32_t except) const {
        return {except, blockers(light).data(), &holesForLight_};
    }
    [[nodiscard]] SurfacePoint surfacePoint(const EyeRays& rays, const RayHit& hit) const;
    [[nodiscard]] Ray shadowRay(const SurfacePoint& point, int light, ShadowStart start) const;
    void eyeBlock(const EyeRays& rays, ivec2 corner, ivec2 blockSize, dvec2 within, const std::uint32_t* expected,
                  SurfacePoint* points, int stride) const;
    void aimTowardLight(const scene::Light& source, const dvec3& firstCentred, BlockRays& block) const;
    void traceShadowRays(std::span<const SurfacePoint> points, std::uint64_t wanted, int light,
                         std::span<Visibility> answers) const;
    void shadowBlock(std::span<const SurfacePoint> points, int light, std::span<Visibility> answers) const;

    scene::Snapshot snapshot_;
    bool castsWhole_ = false;
    Holes holes_, holesForLight_;                    ///< that eye rays, and shadow rays, pass through
    std::shared_ptr<const TracedGeometry> geometry_; ///< none: not begun, or being built
    std::shared_ptr<TracedGeometry> unfinished_;     ///< while building
    std::optional<BvhBuilder> builder_;
    const BlockKernels* kernels_ = &bestBlockKernels();
    const Engine* engine_ = nullptr;      ///< none: the tree of geometry_
    struct LightView {                    ///< per light, of each triangle
        std::vector<std::uint8_t> gates;  ///< see Gate
        std::vector<std::uint8_t> blocks; ///< can it stand in the way?
    };
    std::vector<LightView> lights_;
    std::vector<std::uint8_t> casts_; ///< of each triangle: does its object cast shadows?
};

} // namespace shadowlab::trace
