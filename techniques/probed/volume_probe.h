// Which faces of shadow volumes the eye's line crosses at one pixel, and what is counted of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// How the faces of a shadow volume are counted: those before the visible point (depth pass), or those behind it (depth fail).
enum class CountMethod { zPass, zFail };

/// The line from the eye through the point, and beyond, through the faces of shadow volumes.
struct VolumeProbe {
    enum class Part { side, topCap, bottomCap };
    struct Crossing {
        std::string object; ///< the caster
        Part part = Part::side;
        /// Of a side the silhouette edge, as vertices of the mesh; of a cap the triangle, twice.
        std::array<std::uint32_t, 2> of{};
        double distance = 0;               ///< metres along the line from the eye; infinite: at infinity
        int sign = 0;                      ///< +1: it faces the viewer, the line enters; -1: it leaves
        bool beyond = false;               ///< the point, or at it
        CountMethod method = CountMethod::zFail; ///< in which the technique counts this caster's volume
        int counted = 0;                   ///< what the technique adds to the stencil for it: +1, -1, or 0
        std::string uncounted{};           ///< why it does not count where its way would lead one to think so
        std::vector<dvec4> cornersWorld{}; ///< of the face: homogeneous, w = 0 at infinity
    };
    /// A cap as the plane of the drawing cuts it: what the count changes by for who passes it coming from the light.
    struct CapLine {
        dvec2 from{0.0}, to{0.0};
        int sign = 1; ///< +1 top cap, -1 bottom cap
    };
    /// The volume of one caster, in the vertices and triangles of its mesh.
    struct Caster {
        std::size_t object = 0;          ///< index into the scene's objects
        bool isPicked = false;           ///< it is what the pixel shows
        bool holdsThePoint = false;      ///< the point is in its volume
        std::vector<std::int8_t> facing; ///< sign of N.L of each triangle: +1, -1, or 0 for edge-on
        struct SilhouetteEdge {
            std::uint32_t a = 0, b = 0;  ///< vertices
            std::uint32_t triangles = 2; ///< that meet there: 1 is a boundary
        };
        std::vector<SilhouetteEdge> outline;
        /// Three for each triangle; of n vertices number v + n is vertex v extruded.
        std::vector<std::uint32_t> topCap, sides, bottomCap;
        std::vector<dvec4> extrudedWorld; ///< P' of each vertex, homogeneous: w = 0 at infinity
        /// Where the volume ends: so many metres behind each vertex; or in a plane beyond all that receives shadows; or, with
        /// neither, at infinity.
        std::optional<double> distance;
        std::optional<dvec4> endWorld; ///< the plane dot(xyz, p) + w = 0
    };
    std::vector<Crossing> crossings; ///< by distance
    int frontsBefore = 0,
        backsBefore = 0; ///< n_f and n_b of z-pass, of sides and caps alike: between the eye and the point
    int frontsBeyond = 0, backsBeyond = 0; ///< n_f and n_b of z-fail
    int eyeCount = 0;                      ///< volumes that the eye is in: what the count before the point lacks
    int start = 0;                         ///< what the technique's count starts with
    int count = 0;                         ///< the technique's own: start and what is counted
    int stencil = 0;                       ///< what of it the stencil holds
    int stencilCleared = 0;                ///< before any face
    int stencilBetween = 0;                ///< after the faces of one side, where they are drawn side by side
    std::vector<CapLine> caps;
    std::vector<Caster> casters; ///< what the pixel shows, if it casts shadows, and those whose volumes hold the point
};

} // namespace shadowlab
