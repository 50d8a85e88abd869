// The light's cameras: which way they look, how wide and how deep. Data, and what can be asked of it; how they are fitted to
// a scene is in fit.h. Knows no graphics API.
//
// Everything is relative to the light (world axes, origin at the light, or in the middle of the scene for a directional
// one), so that nothing is lost far from the world's origin. Williams, "Casting Curved Shadows on Curved Surfaces", 1978.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::shadow_map {

/// How a point finds its map among several (shaders/shadow_map/layers/layer_*.glsl).
enum class Layout {
    one,      ///< there is only one
    cube,     ///< six around the light: the one along the largest component (+x -x +y -y +z -z)
    cascades, ///< of a directional light, by the distance from the eye
};

/// One map for each layer. None at all: the light can put nothing that is in view into shadow.
struct LightMaps {
    Layout layout = Layout::one;
    bool parallel = false;
    dvec3 originWorld{0.0};                        ///< of the light-relative space
    dvec3 towardLight{0.0};                        ///< unit, of a parallel light; else zero
    std::vector<dmat4> lightViewFromLightRelative; ///< per layer: the light's camera looks down -z
    std::vector<dmat4> lightClipFromLightView;     ///< per layer
    double nearest = 0, farthest = 1;              ///< along the camera's axis: the projection's range, before any warp
    std::vector<double> cascadeEnds;               ///< metres along the eye's axis
    std::vector<double> fadeStarts;                ///< where each cascade begins to fade into the next
    friend bool operator==(const LightMaps&, const LightMaps&) = default;

    [[nodiscard]] int layers() const { return static_cast<int>(lightClipFromLightView.size()); }
    [[nodiscard]] dmat4 lightClipFromLightRelative(int layer) const {
        return lightClipFromLightView[static_cast<std::size_t>(layer)] *
               lightViewFromLightRelative[static_cast<std::size_t>(layer)];
    }
    /// Stored depth and place in the map (both 0..1) to the light's camera: homogeneous, for distances in metres.
    [[nodiscard]] dmat4 lightViewFromLightClip(int layer) const;
};

/// World to light-relative for one object's mesh, composed in double.
dmat4 lightRelativeFromMesh(const LightMaps& maps, const scene::Object& object);

/// Which map holds a point so far from the eye, along its axis: as shaders/shadow_map/layers/layer_*.glsl choose. None without maps.
std::optional<int> layerOf(const LightMaps& maps, const dvec3& pointLightRelative, double eyeDepth);

/// Can anything in that box leave a depth in that map? What stands before the near plane can: it is clamped.
bool mayDrawInto(const LightMaps& maps, int layer, const scene::Bounds& bounds);

/// Rotation whose rows are right, up and backward for a camera that looks along `forward`; `up` need not be at right angles.
dmat4 lookAlong(const dvec3& forward, const dvec3& up);
/// The same for a camera that may be turned about its axis in any way.
dmat4 lookAlong(const dvec3& forward);

/// Part of the light's view, in its own space: what one map has to hold.
struct Box {
    dvec3 lower{1e300}, upper{-1e300};
    void include(const dvec3& point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
    [[nodiscard]] bool isEmpty() const { return !glm::all(glm::lessThanEqual(lower, upper)); }
    [[nodiscard]] dvec3 corner(int i) const {
        return {(i & 1) ? upper.x : lower.x, (i & 2) ? upper.y : lower.y, (i & 4) ? upper.z : lower.z};
    }
    friend bool operator==(const Box&, const Box&) = default;
};

/// A parallel camera that holds the box.
dmat4 parallelProjection(const Box& box);

/// A perspective camera whose picture spans those tangents (x / -z and y / -z), and that range of distances.
dmat4 perspectiveProjection(const dvec2& lowerTangent, const dvec2& upperTangent, double nearest, double farthest);

/// The least depth that a point of an object compares with these maps, so that a 0 in the map is always nearer.
///
/// What stands before a map's near plane is kept at depth 0 ("pancaked"): all that is known of it is that it is nearer. Where the light
/// grazes a receiver, its plane beside a point may seem to reach before the near plane, too, and a comparison with 0 would then say
/// lit. Where all of the object is beyond the near planes the result is above 0: the object itself has left no 0 in any texel. Else
/// there is no bound: its own surface may be what is kept at 0.
double minReferenceDepth(const LightMaps& maps, const scene::Bounds& objectWorld);

} // namespace shadowlab::shadow_map
