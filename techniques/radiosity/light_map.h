// Light maps: the light that comes straight from lights, found at many points of each patch.
//
// Shadows have edges, and patches are as large as the budget makes them; but light that came by way of other surfaces changes
// slowly. So the two are kept apart: patches know the slow part, and a lattice over every patch, its outermost points on the
// border, knows the fast one. No point is shared by two patches: none lies under a wall. On meshes that were simplified for the
// exchange of light, the vertices of the mesh as it is drawn take the lattice's place; and all that is drawn casts its shadow, not
// the simplified meshes.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/kept_room.h"
#include "techniques/radiosity/light_balance.h"

namespace shadowlab::radiosity {

class LightMap {
public:
    /// Begins what is new (another room, lights that have moved, another number of points along each side), and goes on until all
    /// is done (true) or the time has come, but always a bit.
    bool advance(const scene::Snapshot& snapshot, const KeptRoom& kept, int side, Deadline deadline);

    [[nodiscard]] int side() const { return side_; }
    /// Of each patch, the lowest place of its lattice and its size, in (u, v) of the face.
    [[nodiscard]] const std::vector<vec4>& boxes() const { return boxes_; }

    /// Something at the lattices' points, patch after patch and row after row, and at the blends of surface_cells.h.
    struct Values {
        std::vector<vec4> atPoints;
        std::vector<dvec3> atBlends;
    };
    /// `factor` times what is emitted and what of direct light is reflected.
    [[nodiscard]] Values radiance(const SurfaceCells& cells, const Sources& sources, double factor) const;
    /// The share of a light's area that is seen.
    [[nodiscard]] Values seenArea(const SurfaceCells& cells, int light) const;

private:
    struct Point {
        dvec3 positionCentred, normal;
        bool receivesShadow;
    };
    struct OfLight {
        scene::Light light;
        std::vector<vec4> arriving; ///< of each point: irradiance, and the share of the area
        std::size_t next = 0;       ///< block of points
    };
    void begin(const scene::Snapshot& snapshot, const KeptRoom& kept, int side);
    void addLattice(const Patch& patch, const FaceFrame& frame, bool receivesShadow);
    void fill(OfLight& map, const LightSource& source, std::size_t block) const;
    [[nodiscard]] dvec3 arrivingAt(std::size_t point) const;

    trace::SceneTracer tracer_;
    std::uint64_t room_ = 0;
    int side_ = 0;
    double nearest_ = 0; ///< metres: what is nearer to a point touches it
    std::vector<vec4> boxes_;
    std::vector<Point> points_; ///< those of lattices, then vertices; in the tracer's centred space
    std::size_t firstVertex_ = 0;
    std::vector<OfLight> lights_;
};

} // namespace shadowlab::radiosity
