// The binary tree of one pixel ray, as in the lecture: where the ray hits a surface it splits into a reflection ray and a
// refraction ray, and these split again.
//
// T. Whitted, "An Improved Illumination Model for Shaded Display", Communications of the ACM 1980. The tree is built from the
// root down, level by level, and then evaluated from the leaves up. A ray that hits nothing, or is not followed, has the
// background's intensity; one that ends on a light source has that light's. A surface adds to its own light the weighted
// intensities of its two rays. Every ray is attenuated by the distance it travels. Nodes are stored in the order in which they
// are made, parents before children: going down is a loop, and coming up the same loop backward.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/trace/moving_scene.h"
#include "techniques/ray_tracing/sampling/analytic_lights.h"
#include "techniques/ray_tracing/sampling/sample_numbers.h"
#include "techniques/ray_tracing/tree/fresnel.h"
#include "techniques/ray_tracing/tree/surfaces.h"

namespace shadowlab::ray_tracing {

/// How a light with an area is treated.
enum class AreaLights {
    centre,  ///< as its centre point: hard shadows
    sampled, ///< by a random point on it: all samples of a pixel together estimate how much of it is hidden
    analytic ///< all of it, in closed form; only while nothing moves, else sampled
};

struct TreeSettings {
    int depth = 0;     ///< levels of rays below the eye ray; 0: nothing splits
    double cutoff = 0; ///< a ray whose contribution to the pixel is smaller is not followed
    Fresnel fresnel = Fresnel::exact;
    dvec3 attenuation{1, 0, 0}; ///< c0, c1, c2: after d metres 1 / (c0 + c1 d + c2 d^2) is left
    trace::ShadowStart start = trace::ShadowStart::exact;

    // Random sampling; needs RayWorld::numbers.
    AreaLights areaLights = AreaLights::centre;
    bool gloss = false, translucency = false; ///< rays are spread over the lobes of the materials
    bool wholeLobes = true;       ///< directions below the surface are drawn again; false: their light is lost
    bool interreflection = false; ///< diffuse surfaces send a ray, too
    /// With interreflection: chance ends a path, in place of `depth` and `cutoff`, and on average no light is lost (russianRoulette()).
    bool roulette = false;

    /// No shadow ray where the light could not visibly change the pixel. For pictures; a probe lists all rays.
    bool skipsFaint = false;

    [[nodiscard]] bool attenuates() const { return attenuation != dvec3(1, 0, 0); }
    /// The share of a ray's intensity that is left after that distance in metres.
    [[nodiscard]] double attenuationAt(double distance) const {
        return 1.0 / (attenuation.x + distance * (attenuation.y + distance * attenuation.z));
    }
};

/// The scene and the time that a tree is traced in.
struct RayWorld {
    const Surfaces& surfaces;
    const trace::MovingScene& scene;
    double time = 0;                          ///< in units of shutter time
    const SampleNumbers* numbers = nullptr;   ///< nullptr: nothing is random
    const AnalyticLights* analytic = nullptr; ///< for AreaLights::analytic
};

/// Why a branch ends, if it does.
enum class RayEnd : std::uint8_t {
    splits,         ///< it does not end
    nothingHit,     ///< background
    lightSource,    ///< hit a light source that does not reflect
    opaque,         ///< hit a surface that neither reflects nor transmits
    depth,          ///< the maximum depth is reached
    cutoff,         ///< its contribution would be too small
    chance,         ///< Russian roulette has ended it
    noTransmission, ///< total internal reflection: there is no such ray
};

enum class Branch : std::uint8_t { eye, reflection, refraction, diffuse };

/// A light at a node.
struct LightAtNode {
    trace::Visibility visibility = trace::Visibility::noSurface;
    dvec3 towardWorld{0.0};  ///< L: to its centre, or to the sampled point on it
    dvec3 halfwayWorld{0.0}; ///< H, between L and V
    dvec3 intensity{0.0};    ///< its contribution toward the viewer; zero unless lit
    dvec3 toPlace{0.0};      ///< from the surface to the sampled point, metres; zero: none was sampled
    double areaWeight = 1;   ///< LightSample::areaWeight, for the visible share of the area
};

/// A ray, and the surface that it hits.
struct TreeNode {
    int parent = -1, level = 0;
    std::uint64_t path = 1; ///< number of this node among those of all possible trees: the branches on the way to it
    double survival = 1;    ///< probability with which it is followed; its intensity counts for as much more
    Branch branch = Branch::eye;
    RayEnd end = RayEnd::opaque;
    dvec3 fromCentred{0.0};
    dvec3 u{0.0};               ///< direction of the ray; V is -u
    double contribution = 1;    ///< the share of the pixel's intensity that it carries at its origin
    DielectricStack media;      ///< that the ray is in
    trace::SurfacePoint point;  ///< none: it hits nothing, or was not followed
    dvec3 positionCentred{0.0}; ///< position at that time
    double distance = 0;        ///< metres
    double attenuation = 1;     ///< the share that is left after this distance
    dvec3 normalWorld{0.0};     ///< N, on the viewer's side
    dvec3 reflectedWorld{0.0};  ///< R; zero: there is none
    dvec3 refractedWorld{0.0};  ///< T; zero: there is none
    double iorHere = 1, iorBeyond = 1;
    Weights weights;
    dvec3 diffuseWeight{0.0};                           ///< diffuse reflectance, if a diffuse ray was sent
    int reflection = -1, refraction = -1, diffuse = -1; ///< children
    std::size_t firstLight = 0;                         ///< in lightsOf()
    dvec3 local{0.0};                                   ///< emission, ambient light, and reflected light of the lights
    dvec3 reflectedIntensity{0.0};                      ///< I_R
    dvec3 refractedIntensity{0.0};                      ///< I_T
    dvec3 diffuseIntensity{0.0};                        ///< of the diffuse ray
    dvec3 intensity{0.0};                               ///< I, as it arrives at the ray's origin

    /// The place (SampleNumbers::pair) of a light at this node, among so many lights.
    [[nodiscard]] std::uint64_t placeOf(int light, std::size_t lights) const {
        return path * lights + static_cast<std::size_t>(light);
    }
    [[nodiscard]] bool isFollowed() const { return point || end == RayEnd::nothingHit; }
};

class RayTree {
public:
    /// Builds and evaluates the tree of an eye ray in that unit direction, which hits `first`.
    void trace(const RayWorld& world, const TreeSettings& settings, const dvec3& eyeCentred, const dvec3& u,
               const trace::SurfacePoint& first, const DielectricStack& aroundEye);

    /// The root first, then level by level.
    [[nodiscard]] const std::vector<TreeNode>& nodes() const { return nodes_; }
    [[nodiscard]] const TreeNode& root() const { return nodes_.front(); }
    /// For a node with a surface, one entry for each light of the scene.
    [[nodiscard]] std::span<const LightAtNode> lightsOf(const TreeNode& node) const {
        return {lights_.data() + node.firstLight, node.point ? lightCount_ : 0};
    }
    /// The intensity that each of the root's branches adds to the pixel.
    [[nodiscard]] dvec3 addedByReflection() const {
        return root().attenuation * root().weights.reflected * root().reflectedIntensity;
    }
    [[nodiscard]] dvec3 addedByRefraction() const {
        return root().attenuation * root().weights.transmitted * root().refractedIntensity;
    }
    /// The levels of rays that were followed, including the eye ray.
    [[nodiscard]] int levels() const;

private:
    void find(const RayWorld& world, const TreeSettings& settings, TreeNode& node) const;
    void light(const RayWorld& world, const TreeSettings& settings, TreeNode& node);
    void split(const RayWorld& world, const TreeSettings& settings, std::size_t index);
    void splitByOptics(const RayWorld& world, const TreeSettings& settings, std::size_t index);
    /// Returns the new node; references to nodes become invalid.
    TreeNode& add(const RayWorld& world, const TreeSettings& settings, std::size_t parent, Branch branch, const dvec3& u,
                  double contribution);
    void evaluate(const Surfaces& surfaces);

    std::vector<TreeNode> nodes_;
    std::vector<LightAtNode> lights_;
    std::size_t lightCount_ = 0;
};

} // namespace shadowlab::ray_tracing
