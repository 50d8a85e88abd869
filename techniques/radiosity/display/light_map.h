// Light maps: the light that comes straight from lights, found at many points of each patch.
//
// Shadows have edges, and patches are as large as the budget makes them; but light that came by way of other surfaces changes
// slowly. So the two are cache apart: patches know the slow part, and a lattice over every patch, its outermost points on the
// border, knows the fast one, as dense everywhere as a number of points allows. No point is shared by two patches: none lies under a wall. On meshes that were simplified for the
// exchange of light, the vertices of the mesh as it is drawn take the lattice's place; and all that is drawn casts its shadow, not
// the simplified meshes.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

class LightMap {
public:
    /// Begins what is new (another room, lights that have moved, another number of points), and goes on until all is done (true)
    /// or the time has come, but always a bit. Every patch has four points, however few there are to be.
    bool advance(const scene::Snapshot& snapshot, const RoomCache& cache, std::size_t points, Deadline deadline);

    /// Another number whenever a light's part of it is new.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Two of each patch: the lowest place of its lattice and its size, in (u, v) of the face; its first point, and how many there
    /// are along u and v.
    [[nodiscard]] const std::vector<vec4>& lattices() const { return lattices_; }

    /// Something at the lattices' points, patch after patch and row after row, and at the blends of surface_cells.h.
    struct Values {
        std::vector<vec4> atPoints;
        std::vector<dvec3> atBlends;
    };
    /// The irradiance by all lights, W/m^2.
    [[nodiscard]] Values irradiance(const SurfaceCells& cells) const;
    /// The share of a light's area that is seen.
    [[nodiscard]] Values seenArea(const SurfaceCells& cells, int light) const;

private:
    struct Point {
        dvec3 positionCentred, normal;
        std::uint32_t patch; ///< of lattices
        bool receivesShadow;
    };
    struct OfLight {
        scene::Light light;
        std::vector<vec4> arriving; ///< of each point: irradiance, and the share of the area
        std::size_t next = 0;       ///< block of points
    };
    void begin(const scene::Snapshot& snapshot, const RoomCache& cache, std::size_t points);
    void addLattice(const Patch& patch, const FaceFrame& frame, double spacing, Point point);
    /// From a simplified mesh to the drawn one, if it is that near.
    void bringToSurface(Point& point, std::uint32_t object, double within) const;
    void fill(OfLight& map, const LightSource& source, std::size_t block) const;
    [[nodiscard]] dvec3 arrivingAt(std::size_t point) const;

    trace::SceneTracer tracer_;
    std::uint64_t room_ = 0;
    double nearest_ = 0; ///< metres: what is nearer to a point touches it
    std::uint64_t version_ = 0;
    std::size_t wanted_ = 0; ///< points
    std::vector<vec4> lattices_;
    std::vector<Point> points_; ///< those of lattices, then vertices; in the tracer's centred space
    std::size_t firstVertex_ = 0;
    std::vector<OfLight> lights_;
};

} // namespace shadowlab::radiosity
