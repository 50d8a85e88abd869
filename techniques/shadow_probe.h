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

/// The line from the eye through the point, and beyond, through the faces of shadow volumes.
struct VolumeProbe {
    enum class Part { side, topCap, bottomCap };
    enum class Way { pass, fail };
    struct Crossing {
        std::string object; ///< the caster
        Part part = Part::side;
        /// Of a side the silhouette edge, as vertices of the mesh; of a cap the triangle, twice.
        std::array<std::uint32_t, 2> of{};
        double distance = 0;               ///< metres along the line from the eye; infinite: at infinity
        int sign = 0;                      ///< +1: it faces the viewer, the line enters; -1: it leaves
        bool beyond = false;               ///< the point, or at it
        Way way = Way::fail;               ///< in which the technique counts this caster's volume
        int counted = 0;                   ///< what the technique adds to the stencil for it: +1, -1, or 0
        std::string uncounted{};           ///< why it does not count where its way would lead one to think so
        std::vector<dvec4> cornersWorld{}; ///< of the face: homogeneous, w = 0 at infinity
    };
    /// A cap as the plane of the drawing cuts it: what the count changes by for who passes it coming from the light.
    struct CapLine {
        dvec2 from{0.0}, to{0.0};
        int sign = 1; ///< +1 top cap, -1 bottom cap
    };
    std::vector<Crossing> crossings; ///< by distance
    int frontsBefore = 0,
        backsBefore = 0; ///< n_f and n_b of z-pass, of sides and caps alike: between the eye and the point
    int frontsBeyond = 0, backsBeyond = 0; ///< n_f and n_b of z-fail
    int eyeCount = 0;                      ///< volumes that the eye is in: what the count before the point lacks
    int start = 0;                         ///< what the technique's count starts with
    int count = 0;                         ///< the technique's own: start and what is counted
    int stencil = 0;                       ///< what of it the stencil holds
    std::vector<CapLine> caps;
};

/// The way from the point to a texel of the map, and what it is compared with there.
struct MapProbe {
    /// One comparison of the filter.
    struct Tap {
        ivec2 texel{0};
        double stored = 1;   ///< 0..1; 1: nothing
        double compared = 0; ///< the receiver's depth, bias included
        double weight = 0;   ///< share of the answer
        bool isLit = true;
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
    int resolution = 0;
    ivec2 texel{0};
    dvec3 str{0.0};      ///< the point's place in the map and its depth, 0..1
    double first = 1;    ///< depth of the first surface at the texel's centre, before any offset; 1: nothing
    double stored = 1;   ///< what the map holds
    double compared = 0; ///< depth that is compared with it: of the point, less the bias
    double firstMetres = 0, storedMetres = 0, comparedMetres = 0, pointMetres = 0; ///< along the light's axis
    double texelMetres = 0;                      ///< across a texel at the point, at right angles to the light
    std::optional<dvec3> blockerWorld{};         ///< of the first surface, at the texel's centre
    std::vector<Tap> taps;                       ///< empty: of this filter there is more than one answer to tell
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
        double weight = 0;     ///< w' of the projection: 1 on the plane, 0 at the light's height, negative beyond
        bool casts = false;    ///< it is between the plane and the light
        std::string why{};     ///< it does not
        std::array<dvec3, 3> cornersWorld{};
    };
    dvec4 planeWorld{0.0};     ///< (N, D), positive on the light's side
    dvec4 lightWorld{0.0};     ///< homogeneous
    double lightHeight = 0;    ///< N.P_L + D; of a direction its cosine
    double contact = 0;        ///< metres above the plane below which things belong to it
    bool clips = true;         ///< does the technique, with its settings, leave out what does not cast?
    std::vector<Cover> covers; ///< from the plane toward the light
};

/// What was decided about the pixel, and what is true.
struct Decision {
    double visibility = 0; ///< by the technique, 0..1
    bool isTurnedAway = false;
    std::string why{}; ///< it differs from the truth, or that it does not
};

} // namespace shadowlab
