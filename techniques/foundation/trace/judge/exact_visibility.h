// A small exact judge: which surface a pixel shows and whether a light sees it, in double, by trying every triangle.
//
// Slow and simple on purpose: the techniques are tested against it. Boxes around runs of triangles only save time.
// Definitions: see "visibility" in docs/conventions.md. Every triangle of a casting object blocks light from both sides;
// the triangle on which the point lies does not shadow itself. Through holes (scene/model/holes.h) rays go on.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/coincident/coincident_faces.h"

namespace shadowlab::trace {

enum class Visibility : std::uint8_t { noSurface, turnedAway, shadowed, lit };

struct EyeHit {
    std::uint32_t object = 0, triangle = 0; ///< triangle within the object's mesh
    double distance = 0;                    ///< metres along the unit ray
    dvec3 positionWorld{0.0};
    dvec3 geometricNormalWorld{0.0}; ///< unit, on the eye's side
    dvec3 barycentric{0.0};          ///< weights of the triangle's corners
};

class ExactVisibility {
public:
    /// Keeps the scene alive.
    explicit ExactVisibility(scene::Snapshot snapshot);

    /// The nearest triangle beyond the near plane on the ray through a point of the picture ((x + 0.5, y + 0.5) is the
    /// centre of pixel (x, y), rows from the top); of triangles at one distance the first wins, but where faces
    /// coincide (scene/query/coincident/coincident_faces.h).
    [[nodiscard]] std::optional<EyeHit> eyeHit(const scene::Camera& camera, dvec2 pixel, ivec2 size) const;

    /// Visibility of the light's centre at a hit. Never noSurface. `receivesShadow: false` and the gates of facing,
    /// cone and rect included.
    [[nodiscard]] Visibility visibility(const EyeHit& hit, const scene::Camera& camera, int light) const;

    /// Both at once.
    [[nodiscard]] Visibility at(const scene::Camera& camera, dvec2 pixel, ivec2 size, int light) const;

    /// Number of casting triangles strictly between a hit and the light's centre: what a stencil count should be. Holes
    /// count as surface here, as they do in a shadow volume.
    [[nodiscard]] int crossings(const EyeHit& hit, int light) const;

private:
    struct Triangle {
        dvec3 a, b, c; ///< world space
    };
    struct Run { ///< consecutive triangles of one object and the box around them
        std::uint32_t object, first, count;
        scene::Bounds bounds;
    };
    template <typename OnHit>
    void forEachHit(const dvec3& originWorld, const dvec3& directionWorld, double length, const OnHit& onHit) const;

    /// Calls onBlocker(object, triangle, weights of the corners) until it returns true.
    template <typename OnBlocker>
    void forEachBlocker(const EyeHit& hit, int light, const OnBlocker& onBlocker) const;

    /// What is seen where the nearest hit shares its place with others.
    [[nodiscard]] EyeHit seenAmong(const EyeHit& nearest, std::span<const EyeHit> coincident, const dvec3& direction) const;
    [[nodiscard]] bool passes(std::uint32_t object, std::uint32_t triangle, const dvec3& barycentric) const;

    scene::Snapshot snapshot_;
    std::vector<Triangle> triangles_;          ///< of all objects
    std::vector<std::uint32_t> firstTriangle_; ///< per object
    std::vector<bool> hasHoles_;               ///< per object
    std::vector<Run> runs_;
    std::vector<std::vector<std::int8_t>> facing_; ///< per light, all triangles
    scene::CoincidentFaces coincident_;
};

} // namespace shadowlab::trace
