// The share of an area light that a point sees, and its irradiance, computed without sampling.
//
// What the point sees of the light changes only along *contours*: edges of casters at which the number of triangles that
// cover the light changes. That is decided per edge as for a silhouette: each triangle has a side on which the point is,
// and an edge counts where its triangles' turns, each with the sign of that side, do not add up to nothing. So the light is
// cut along the contours alone (uniform_pieces.h), and one ray for each piece tells whether it is seen. An edge between two
// triangles beside each other never matters, however fine the mesh. Where a triangle goes into a sphere, what it hides ends in a circle (sphere_cuts.h).
//
// The share is right up to the rounding of double, but for those circles, which are made of chords. Triangles with holes in them:
// pieces that such a triangle covers are asked with rays, in proportion about 1024 for the whole light, so a share is then
// wrong by at most about 1/64 (one standard deviation of as many independent rays, which these, spread evenly, stay below).
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/trace/area/shaft.h"
#include "techniques/foundation/trace/area/sphere_cuts.h"
#include "techniques/foundation/trace/area/surface_edges.h"
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::trace {

/// Irradiance is divided by pi times the light's radiance: 1 under a light that fills all of the hemisphere.
struct AreaIrradiance {
    double visible = 0;    ///< 0..1 of the light's area, the same as AreaShare::visible
    double irradiance = 0; ///< of what is seen of the light, at a surface with the normal that was given
    /// Of all of the light in front of the surface, without shadows. What lies behind the surface, by that normal or by the
    /// triangle's own, counts for neither.
    double unshadowed = 0;
};

/// What a point sees of the light.
struct AreaShare {
    double visible = 0; ///< 0..1 of its area, as it is seen
    /// By how much that may change while the point moves on its triangle, by as much as was said. At least twice what it is to
    /// first order.
    double change = 0;
};

class AreaVisibility {
public:
    /// The tracer must live as long, with the scene that it has. The light must have an area.
    AreaVisibility(const SceneTracer& tracer, int light);

    /// The gates (facing, cone) are those of the light's centre: if they are closed, or there is no surface, nothing is
    /// seen. The part of the light below the plane of the point's triangle is not seen. A surface that receives no shadows
    /// sees all of the light.
    [[nodiscard]] double share(const SurfacePoint& point) const;

    /// The same for many points, which is quicker where they are neighbours. `moves`: of each point, in metres; empty: none.
    void shares(std::span<const SurfacePoint> points, std::span<const double> moves,
                std::span<AreaShare> answers) const;

    /// What they get of the light. Here the facing gate is that of each part of the light: a surface that turns away from it darkens
    /// little by little, as the light sets. `visible` alone keeps the centre's gates. `normalsWorld`: one unit vector per point, on the side that the light is to
    /// be counted on: the shading normal. A point within a sphere gets nothing of it.
    void irradiances(std::span<const SurfacePoint> points, std::span<const dvec3> normalsWorld,
                     std::span<AreaIrradiance> answers) const;

private:
    struct Bounds;
    class Obstacles;
    class Asker;
    struct Group;
    void askAll(Group& group) const;
    void ask(Group& group, std::span<std::uint32_t> members, const Bounds& bounds, const Obstacles& obstacles,
             Asker& asker) const;
    void askTogether(Group& group, std::span<const std::uint32_t> members, const Obstacles& obstacles,
                     Asker& asker) const;
    [[nodiscard]] AreaIrradiance askIrradiance(const SurfacePoint& point, const dvec3& normalWorld, Asker& asker) const;
    [[nodiscard]] Bounds boundsOf(const Group& group, std::span<const std::uint32_t> members) const;
    /// Within this distance from a point, things may move by more than the margin around the light in which contours are counted
    /// while the point moves. `farthest`: metres to the farthest place of the light.
    [[nodiscard]] double nearness(double move, double farthest) const;

    const SceneTracer& tracer_;
    const scene::Light& light_;
    int number_;
    dvec3 centreCentred_;
    CentredBox box_;                  ///< of the light
    std::vector<std::uint8_t> casts_; ///< of each triangle: SceneTracer::castersFor()
    SurfaceEdges edges_;
    SphereCuts cuts_; ///< of all triangles that cast, if the light is a sphere

    /// That margin, in shares of the light's size beyond its border.
    static constexpr double kMargin = 0.25;
    /// The disc of a sphere is at least this share as wide as the sphere, from all points farther away than 1.4 radii.
    static constexpr double kLeastDisc = 0.7;
};

} // namespace shadowlab::trace
