// Motion blur: ray queries at one moment while the shutter is open and objects move.
//
// An object that moves on at constant velocity is met by a ray at time t exactly where the ray, moved back by t times the
// velocity, meets the object at rest. So nothing is built for a moment: there is one structure for what stands still, and one
// for each velocity, and a ray is asked of each of them. Objects keep their triangles' numbers in all of them.
// Simplified: motion is straight and does not turn (scenes say no more); lights stand still.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::trace {

class MovingScene {
public:
    /// The tracer must live as long, with the scene that it has. What moves gets structures of the kind that is given.
    MovingScene(const SceneTracer& tracer, Structure structure);
    /// Everything as it stands, at any time.
    explicit MovingScene(const SceneTracer& tracer) : tracer_(tracer) {}

    /// True if anything moves.
    [[nodiscard]] bool moves() const { return !parts_.empty(); }
    /// Goes on building until it is finished (true) or the time has come (false).
    bool advance(Engine::Deadline deadline);
    [[nodiscard]] double done() const;

    // From here on: after advance() has returned true. From any thread. Times in units of shutter time, 0: as the scene stands.

    /// What the ray meets first, as SceneTracer::met().
    [[nodiscard]] SurfacePoint met(const Ray& ray, std::uint32_t leftOut, double time) const;
    /// True if something that casts shadows blocks the ray, as SceneTracer::isBlocked().
    [[nodiscard]] bool isBlocked(const Ray& ray, std::uint32_t leftOut, double time,
                                 int light = SceneTracer::kAnyLight) const;
    /// Where a point of a surface has got to.
    [[nodiscard]] dvec3 positionCentred(const SurfacePoint& point, double time) const {
        return tracer_.positionCentred(point) + time * tracer_.objectOf(point).velocityWorld;
    }

private:
    /// All objects of one velocity.
    struct Part {
        dvec3 velocityWorld{0.0};
        std::vector<Triangle> triangles; ///< all of the scene; those of other parts have no numbers, and are never hit
        std::unique_ptr<Engine> engine;
    };
    const SceneTracer& tracer_;
    std::vector<Part> parts_; ///< none: nothing moves
};

/// The same ray, `centred` further back.
inline Ray movedBack(Ray ray, const dvec3& byCentred) {
    ray.originCentred -= byCentred;
    return ray;
}

} // namespace shadowlab::trace
