// What the techniques of direct light know about the shadow at one pixel: which volume faces the eye's line crosses, what the
// texel of a shadow map holds, which triangles a plane's point is covered by. Data for texts and drawings alike.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// The plane through eye, light and point that the lectures draw in. Two unit axes at right angles; the point is the origin, and
/// the eye is on the left.
struct LightSection {
    dvec3 originWorld{0.0}, rightWorld{1, 0, 0}, upWorld{0, 1, 0};
    /// The three lie on one line, or so nearly that it says nothing: the plane is then any that holds the line.
    bool isChosen = false;
    [[nodiscard]] dvec2 of(const dvec3& positionWorld) const { return ofDirection(positionWorld - originWorld); }
    [[nodiscard]] dvec2 ofDirection(const dvec3& directionWorld) const {
        return {glm::dot(directionWorld, rightWorld), glm::dot(directionWorld, upWorld)};
    }
    [[nodiscard]] dvec3 world(const dvec2& place) const {
        return originWorld + place.x * rightWorld + place.y * upWorld;
    }
    [[nodiscard]] dvec3 normalWorld() const { return glm::cross(rightWorld, upWorld); }
};

/// `lightWorld` is homogeneous; `normalWorld` the surface's at the point: it chooses the plane where eye and light do not.
/// Up is up in the scene, as far as the plane allows.
LightSection lightSection(const dvec3& eyeWorld, const dvec3& pointWorld, const dvec4& lightWorld,
                          const dvec3& normalWorld);

/// Where a triangle (its corners in world space) meets the plane; none where it does not. A corner in the plane counts as above
/// it, so that what two triangles share is cut alike.
std::optional<std::array<dvec2, 2>> cutBy(const LightSection& section, const std::array<dvec3, 3>& cornersWorld);

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

/// The way from the point to a texel of the map, and what it is compared with there.
struct MapProbe {
    /// One comparison of the filter.
    struct Tap {
        ivec2 texel{0};
        double stored = 1;       ///< 0..1; 1: nothing
        double compared = 0;     ///< the receiver's depth, bias included
        double weight = 0;       ///< share of the answer
        bool isLit = true;       ///< of a search: it is no blocker
        dvec2 placeTexels{0.0};  ///< where the map is asked, column and row: (0.5, 0.5) is the centre of texel (0, 0)
        dvec3 onPlaneWorld{0.0}; ///< the place of the receiver's plane that the light sees there
    };
    /// What percentage-closer soft shadows do before they compare.
    struct BlockerSearch {
        std::vector<Tap> looks;    ///< depths that were looked at
        int found = 0;             ///< of them, nearer to the light than the point: blockers
        double receiverMetres = 0; ///< d_r: of the point, from the light, at right angles to its surface
        double blockerMetres = 0;  ///< d_b: the mean of the blockers
        double lightMetres = 0;    ///< w_L, width of the light; of a directional one at a distance of 1 m
        double penumbraMetres = 0; ///< w = w_L (d_r - d_b) / d_b, or less, where the kernel may not be as wide
        double searchTexels = 0;   ///< the farthest place that the search looks at, from the point's own
        double kernelTexels = 0;   ///< and that the filter compares at
    };
    /// What the filters read that average what depths become.
    struct Moments {
        /// Chebyshev's inequality for one of the warped depths, or Hamburger's problem.
        struct Bound {
            std::string of;      ///< "z", "exp(c z)"
            double compared = 0; ///< the point's own
            double mean = 0, variance = 0;
            double visibility = 1; ///< at most this share of the depths is at or beyond it
        };
        double depth = 0; ///< z of the point: -1 at the map's near side, 1 at its far side
        std::vector<std::pair<std::string, double>> read; ///< name and value of each number, interpolated
        std::vector<Bound> bounds;                        ///< none: a product stands for the comparison
        double unreduced = 1;                             ///< the least of the bounds, or the product
        double visibility = 1;                            ///< with the light that bleeds taken off
        bool isFinite = true;                             ///< false: the format did not hold a number
    };
    /// A texel that the plane of the drawing passes through: between two rays of the light, up to the stored depth.
    struct Cell {
        ivec2 texel{0};
        std::array<dvec2, 2> rays{};     ///< where the rays begin, in the plane: at the light, or before a parallel map
        std::array<dvec2, 2> stored{};   ///< where the stored depth cuts them
        std::array<dvec2, 2> compared{}; ///< where the compared depth does
        bool isEmpty = true;             ///< nothing is stored
    };
    int layer = 0, layers = 1;
    std::string layerName; ///< "cascade 2 of 3", "face +x"
    /// From world axes around `originWorld`, the light or the middle of the scene, into the map's clip space.
    dmat4 lightClipFromLightRelative{1.0};
    dvec3 originWorld{0.0};
    int resolution = 0;
    ivec2 texel{0};
    dvec3 str{0.0};      ///< the point's place in the map and its depth, 0..1
    double first = 1;    ///< depth of the first surface at the texel's centre, before any offset; 1: nothing
    double stored = 1;   ///< what the map holds
    double compared = 0; ///< depth that is compared with it: of the point, less the bias
    double firstMetres = 0, storedMetres = 0, comparedMetres = 0, pointMetres = 0; ///< along the light's axis
    double texelMetres = 0;                      ///< across a texel at the point, at right angles to the light
    std::optional<dvec3> blockerWorld{};         ///< of the first surface, at the texel's centre
    std::vector<Tap> taps;                       ///< comparisons of the filter; none where it averages depths
    std::optional<BlockerSearch> search{};       ///< of the filter pcss
    std::optional<Moments> moments{};            ///< of the filters vsm to msm
    std::array<dvec3, 4> texelOnReceiverWorld{}; ///< the texel projected onto the point's plane
    bool texelIsOnReceiver = false;              ///< all four corners meet it
    std::vector<Cell> near, across;              ///< of the plane: beside the point; all over the map, some of them
};

/// The point on its plane, and all that the light's line through it meets.
struct PlaneProbe {
    struct Cover {
        std::string object;
        std::uint32_t triangle = 0;
        dvec3 placeWorld{0.0}; ///< the caster's point whose projection is the pixel's
        double height = 0;     ///< N.P + D, metres above the plane
        double weight = 0;     ///< w' = (N.P_L + D) - (N.P + D): 0 at the light's height, negative beyond
        bool casts = false;    ///< it is between the plane and the light
        std::string why{};     ///< it does not
        std::array<dvec3, 3> cornersWorld{};
    };
    dvec4 planeWorld{0.0};  ///< (N, D), positive on the light's side
    dvec4 lightWorld{0.0};  ///< homogeneous
    double lightHeight = 0; ///< N.P_L + D; of a direction its cosine
    double contact = 0;     ///< metres above the plane below which things belong to it
    /// The point lies on no plane that receives: planeWorld is zero, and what receives is listed instead.
    bool receives = true;
    struct Other {
        std::string object;
        dvec4 planeWorld{0.0}; ///< (N, D)
    };
    std::vector<Other> others;
    bool clips = true;         ///< does the technique, with its settings, leave out what does not cast?
    std::vector<Cover> covers; ///< from the plane toward the light
};

/// What was decided about the pixel, and what is true.
struct Decision {
    double visibility = 0; ///< by the technique, 0..1
    bool isTurnedAway = false;
    std::string why{}; ///< it differs from the truth, or that it does not
    /// The face that it was found to be blocked by, of a technique that looks for one.
    struct Face {
        std::string object;
        std::uint32_t triangle = 0;
        std::array<dvec3, 3> cornersWorld{};
    };
    std::optional<Face> blocker{};
};

} // namespace shadowlab
