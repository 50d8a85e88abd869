// Ray queries on a scene: what is visible, and what a light sees. The structure is built in slices, and again only if the
// scene has changed; then any number of threads may ask queries. Tracers of one scene share the structure
// (traced_geometry.h).
//
// There is no epsilon: a shadow ray starts on the surface itself and ignores the triangle it starts on, by number. An
// offset along the normal would have to grow with the distance from the origin, and push the ray through thin walls. What
// "in shadow" means is said in docs/conventions.md, and judged by exact_visibility.h, which shares no code with this.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <span>

#include "techniques/foundation/scene/query/coincident/coincident_faces.h"
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

// A hit nearer than this share of the distance to the light is contact, not a crossing: the point itself is only known to
// about 2^-50 of its coordinates, so neighbours in the same plane would otherwise shadow it by rounding.
constexpr double kContact = 1e-10;

// A directional light has no distance; the size of the coordinates is used instead.
constexpr double kContactPerMetre = 1e-12;

class SceneTracer {
public:
    /// Prepares for a scene: rebuilds what has new revisions. False if the deadline came before the end.
    bool advance(const scene::Snapshot& snapshot, std::chrono::steady_clock::time_point deadline);
    /// Share of the building that is done, 0..1.
    [[nodiscard]] double done() const { return builder_ ? builder_->done() : 1.0; }

    /// From the next advance() on, shadow rays ignore holes (casters are solid), while eye rays still pass through them.
    /// For techniques whose shadows do not support holes.
    void castWhole() { castsWhole_ = true; }

    /// From now on rays are traced one by one through another structure over the same triangles; nullptr: through the
    /// tracer's own tree again. The answers are the same. The engine must be built, for geometry(), and outlive its use.
    void askInstead(const Engine* engine) { engine_ = engine; }

    // From here on: after advance() has returned true.
    [[nodiscard]] const scene::Scene& scene() const { return *snapshot_; }
    [[nodiscard]] const std::shared_ptr<const TracedGeometry>& geometry() const { return geometry_; }
    [[nodiscard]] const Bvh& bvh() const { return geometry_->bvh; }
    [[nodiscard]] const WorldTriangles& world() const { return geometry_->world; }
    /// No coordinate of a triangle is larger, in centred space.
    [[nodiscard]] double largestCentred() const { return static_cast<double>(bvh().largest); }

    [[nodiscard]] EyeRays eyeRays(const scene::Camera& camera, ivec2 size) const {
        return {camera, size, world().originWorld, coincident_->isWithinBody(camera.positionWorld)};
    }
    [[nodiscard]] SurfacePoint eyePoint(const EyeRays& rays, dvec2 pixel) const;

    /// The first surface on the ray from the point in that unit direction; of equally near triangles the lowest number.
    /// Ignores the point's own triangle, and its neighbours where they touch the point.
    [[nodiscard]] SurfacePoint nextPoint(const SurfacePoint& from, const dvec3& directionWorld) const;
    /// The same from any place, such as the eye itself; `leftOut`: a triangle that is not met.
    [[nodiscard]] SurfacePoint nextPoint(const dvec3& fromCentred, std::uint32_t leftOut,
                                         const dvec3& directionWorld) const;

    // Any rays. `leftOut` is a triangle that is not met, kNoPrimitive: none is.

    /// What the ray meets first; seen from the side that it comes from.
    [[nodiscard]] SurfacePoint met(const Ray& ray, std::uint32_t leftOut) const;
    /// True if something that casts shadows blocks the ray. `light`: the ray goes to a place on that light, so what lies in the
    /// plane of a rect does not block it (lamp_plane.h); kAnyLight: it goes anywhere.
    [[nodiscard]] bool isBlocked(const Ray& ray, std::uint32_t leftOut, int light = kAnyLight) const;
    static constexpr int kAnyLight = -1;
    /// Is that the triangle on which a ray begins, or one that lies in its plane but for rounding? A ray does not meet those.
    [[nodiscard]] bool isLeft(std::uint32_t from, std::uint32_t primitive) const {
        return from == primitive || (coincidentWith(from) && coincident_->areTogether(from, primitive));
    }
    /// What an engine over the same triangles is asked for, to answer these two.
    [[nodiscard]] MayHit mayMeet(std::uint32_t leftOut) const {
        return {.except = leftOut, .coincident = coincidentWith(leftOut), .holes = &holes_};
    }
    [[nodiscard]] MayHit mayStandIn(std::uint32_t leftOut, int light = kAnyLight) const {
        return {.except = leftOut,
                .coincident = coincidentWith(leftOut),
                .flags = castersFor(light).data(),
                .holes = &holesForLight_};
    }
    /// For each triangle 1 if it can hide a part of the light, else 0.
    [[nodiscard]] std::span<const std::uint8_t> castersFor(int light) const {
        if (light == kAnyLight || lights_[static_cast<std::size_t>(light)].hidesPart.empty()) return casts_;
        return lights_[static_cast<std::size_t>(light)].hidesPart;
    }
    /// The hit, or that on another triangle at the same place that is seen instead (scene/query/coincident/coincident_faces.h). `time`:
    /// of what moves (moving_scene.h).
    [[nodiscard]] RayHit seenInstead(const Ray& ray, const RayHit& hit, const MayHit& mayHit, double time = 0) const;
    /// What a ray of that direction has hit.
    [[nodiscard]] SurfacePoint surfacePoint(const dvec3& directionWorld, const RayHit& hit) const;

    /// Is there a hole in the point's triangle? Where an eye ray ends there never is; for points found in another way.
    [[nodiscard]] bool isInHole(const SurfacePoint& point) const {
        return holes_(point.primitive, point.barycentric());
    }

    /// True if the triangle may have holes for shadow rays.
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

    /// True if the side that the eye sees faces the light and lies in its cone. Otherwise no shadow ray is needed.
    [[nodiscard]] bool facesLight(const SurfacePoint& point, int light) const;
    /// The same for a light with an area, of which a part may be above the surface where the centre is not. False surely means that none is.
    [[nodiscard]] bool mayFacePartOfLight(const SurfacePoint& point, int light) const;
    /// The triangle that stands between the point and the light's centre, or kNoPrimitive: the first that is found.
    [[nodiscard]] std::uint32_t blocker(const SurfacePoint& point, int light,
                                        ShadowStart start = ShadowStart::exact) const;
    /// True if this triangle blocks the way to the light. For callers that find candidates without a tree.
    [[nodiscard]] bool isBlockedBy(std::uint32_t primitive, const SurfacePoint& point, int light) const;
    /// For each triangle 1 if it can block the light at all, else 0.
    [[nodiscard]] std::span<const std::uint8_t> blockers(int light) const {
        return lights_[static_cast<std::size_t>(light)].blocks;
    }
    /// Where, on the way from the point to the light's centre, the first thing stands; nothing where the way is free.
    [[nodiscard]] std::optional<dvec3> blockedAtWorld(const SurfacePoint& point, int light) const;
    /// The visibility of the light: combines facing, blockers, and whether the surface receives shadows at all.
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
    /// The same with a given guess of the first triangle on each ray (kNoPrimitive: none, or not known). A ray that does
    /// hit it ends there, without a look at what may be nearer; all others are traced.
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
    enum Gate : std::uint8_t { facesFront = 1, facesBack = 2, receives = 4, inLampPlane = 8 };

    void lookAtLights();
    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit) const;
    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit) const;
    /// Without that triangle, what may stand in the light's way.
    [[nodiscard]] MayHit mayBlock(int light, std::uint32_t except) const {
        return {.except = except,
                .coincident = coincidentWith(except),
                .flags = blockers(light).data(),
                .holes = &holesForLight_};
    }
    /// Where a ray begins on a triangle that lies in one plane with others, but for rounding, it may not meet those.
    [[nodiscard]] const scene::CoincidentFaces* coincidentWith(std::uint32_t primitive) const {
        return primitive != kNoPrimitive && coincident_->anyUneven() && coincident_->isUneven(primitive) ? coincident_.get() : nullptr;
    }
    [[nodiscard]] scene::SideRank rankOf(std::uint32_t primitive, const dvec3& directionWorld) const;
    [[nodiscard]] bool mayShowAnother(const SurfacePoint& point, bool eyeIsWithin) const {
        return coincident_->mayShowAnother(point.primitive, point.eyeOnFront, eyeIsWithin);
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
        std::vector<std::uint8_t> blocks; ///< 1 if it can block the light
        /// 1 if it can hide a part of a light with an area; empty: as in casts_.
        std::vector<std::uint8_t> hidesPart;
    };
    std::vector<LightView> lights_;
    std::shared_ptr<const scene::CoincidentFaces> coincident_ = std::make_shared<scene::CoincidentFaces>();
    std::vector<std::uint8_t> casts_; ///< per triangle: 1 if its object casts shadows
};

} // namespace shadowlab::trace
