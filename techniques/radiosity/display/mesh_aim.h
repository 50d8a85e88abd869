// Rays to a mesh of many triangles, whichever of them they meet.
//
// What fills the spheres that cover it, as a ball or an egg does, is aimed at by directions into these: nearly all meet it. A tube, a ring or a basket leaves them
// mostly empty. There points of the triangles are chosen, and count if the ray arrives. Were all of the surface alike, half of them would lie on sides that are turned away,
// and others where nothing glows. So triangles are put into groups that lie together and face about the same way, and a group is chosen by how much it is likely to bring;
// within it, all of the surface is alike. What is aimed at by spheres is one group.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "techniques/radiosity/display/covering_spheres.h"

namespace shadowlab::radiosity {

/// Where light arrives: a place on a surface, and as much of it as is meant.
struct Receiver {
    dvec3 positionWorld{0.0}, normal{0.0}; ///< normal: unit
    double area = 0;                       ///< m^2
};

class MeshAim {
public:
    MeshAim(const scene::Scene& scene, const scene::Object& object);

    /// By directions into spheres, or else by points?
    [[nodiscard]] bool usesSpheres() const { return !spheres_.isEmpty(); }
    [[nodiscard]] std::size_t groups() const { return groups_.size(); }
    [[nodiscard]] std::uint32_t groupOf(std::uint32_t triangleInMesh) const { return groupOf_[triangleInMesh]; }
    /// In proportion to about what arrives there from the group, if nothing is between; 0 where not all of it may be found. `reflected`: luminance of what the mesh sends beside what it emits, in
    /// units of radiosity.
    [[nodiscard]] double likely(std::size_t group, const Receiver& at, double reflected) const;
    /// Luminance of all that it emits, W.
    [[nodiscard]] double emitted() const;

    struct Way {
        dvec3 direction{0.0}; ///< unit
        double distance = 0;  ///< to the chosen point, metres; 0: the mesh may be met anywhere on the way
        double density = 0;   ///< 1/sr, if this group is chosen
    };
    /// Nothing if the place lies within the chosen sphere, or in the plane of the chosen triangle. `which` and `where`: of the unit interval and the unit square, evenly distributed.
    [[nodiscard]] std::optional<Way> choose(std::size_t group, const dvec3& fromWorld, double which, const dvec2& where) const;
    /// The density with which that unit vector is chosen, such that the group is met so far away and at an angle with that cosine, 1/sr.
    [[nodiscard]] double density(std::size_t group, const dvec3& fromWorld, const dvec3& direction, double distance, double cosineThere) const;

private:
    struct Facet {
        std::array<dvec3, 3> corners; ///< world
        dvec3 across;                 ///< its area times the normal of its front
        std::uint32_t number;         ///< in the mesh
        std::uint32_t material;       ///< in the scene
        [[nodiscard]] dvec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
    };
    struct Group {
        std::size_t first, count; ///< of facets_
        dvec3 middleWorld{0.0}, across{0.0};
        double area = 0, spread = 0; ///< m^2; spread: of the square of the distance from the middle, in the mean
        double emitted = 0;          ///< luminance of its radiosity
        bool hasTwoSides = false;    ///< both shine
    };
    void part(std::size_t first, std::size_t count, std::size_t wanted, double size);
    void fill(const scene::Scene& scene, Group& group);

    CoveringSpheres spheres_;   ///< empty where points are chosen
    std::vector<Facet> facets_; ///< those of a group follow one another
    std::vector<double> upTo_;  ///< the area of each facet and of those before it in its group, m^2
    std::vector<Group> groups_;
    std::vector<std::uint32_t> groupOf_;
};

} // namespace shadowlab::radiosity
