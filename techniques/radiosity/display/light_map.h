// Light maps: the direct light of the lights, at many points of each patch.
//
// Shadows have edges, and patches are as large as the budget makes them; but light that comes by way of other surfaces changes
// slowly. So the two are separated: patches hold the slow part, and a lattice of points over every patch, the outermost on its
// border, holds the fast one, equally dense everywhere. No point is shared by two patches, so none lies under a wall. On
// simplified meshes, the vertices of the original mesh take the place of the lattice; and shadows are cast by the original scene,
// not by the simplified meshes.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

class LightMap {
public:
    /// Recomputes what has changed (another room, lights that have moved, another number of points) until all is done (true) or
    /// the deadline has passed, but always does some work. Every patch has at least four points, whatever `points` is.
    bool advance(const scene::Snapshot& snapshot, const RoomCache& cache, std::size_t points, Deadline deadline);

    /// Changes whenever a light's part is recomputed.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Two entries per patch: the lower corner of its lattice and its size, in (u, v) of the face; its first point, and how many
    /// there are along u and v.
    [[nodiscard]] const std::vector<vec4>& lattices() const { return lattices_; }

    /// Values at the points of the lattices, patch by patch and row by row, and at the blends of surface_cells.h.
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
        std::uint32_t patch; ///< for points of lattices
        bool receivesShadow;
    };
    struct OfLight {
        scene::Light light;
        std::vector<vec4> arriving; ///< for each point: irradiance, and the share of the light's area that it sees
        std::size_t next = 0;       ///< the next block of points
    };
    void begin(const scene::Snapshot& snapshot, const RoomCache& cache, std::size_t points);
    void addLattice(const Patch& patch, const FaceFrame& frame, double spacing, Point point);
    /// Moves a point from a simplified mesh to the original one, if that is within `within` metres.
    void bringToSurface(Point& point, std::uint32_t object, double within) const;
    void fill(OfLight& map, int light, const LightSource& source, std::size_t block) const;
    [[nodiscard]] dvec3 arrivingAt(std::size_t point) const;

    trace::SceneTracer tracer_;
    std::uint64_t room_ = 0;
    double nearest_ = 0; ///< contact tolerance, metres
    std::uint64_t version_ = 0;
    std::size_t wanted_ = 0; ///< points
    std::vector<vec4> lattices_;
    std::vector<Point> points_; ///< those of lattices, then vertices; in the tracer's centred space
    std::size_t firstVertex_ = 0;
    std::vector<OfLight> lights_;
};

} // namespace shadowlab::radiosity
