// The binary tree of one pixel ray, as the lecture draws it: where the ray meets a surface it splits into a reflection ray
// and a refraction ray, and these split again.
//
// T. Whitted, "An Improved Illumination Model for Shaded Display", Communications of the ACM 1980. The tree is built from
// the root down, level by level, and then evaluated from its leaves up: a ray that meets nothing, or is not followed, has
// the background's intensity, one that ends on a light source that light's; a surface adds to its own light what its two
// rays bring, each weighted; and on its way back to where it came from every ray is attenuated by the distance.
// Nodes lie in the order in which they were made, parents before children, so going down is a loop, and coming up the same
// loop backward.
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

/// What stands for a light that has an area.
enum class AreaLights {
    centre,  ///< the point in its middle: hard shadows
    sampled, ///< a place on it, by chance: all samples of a pixel together see how much of it is hidden
    analytic ///< all of it, in closed form; only while nothing moves, else sampled
};

struct TreeSettings {
    int depth = 0;     ///< levels of rays below the eye ray; 0: nothing splits
    double cutoff = 0; ///< a ray that can add no larger share to the pixel than this is not followed
    Fresnel fresnel = Fresnel::exact;
    dvec3 attenuation{1, 0, 0}; ///< c0, c1, c2: after d metres 1 / (c0 + c1 d + c2 d^2) is left
    trace::ShadowStart start = trace::ShadowStart::exact;

    // What is left to chance; needs numbers (RayWorld).
    AreaLights areaLights = AreaLights::centre;
    bool gloss = false, translucency = false; ///< rays spread into the lobes that materials ask for
    bool wholeLobes = true;                   ///< what falls below the surface is drawn again; false: it is lost
    bool interreflection = false;             ///< diffuse surfaces send a ray on, too

    /// No shadow ray where the light could add less to the pixel than can be seen. For pictures; who asks for a tree wants to
    /// know all of it.
    bool skipsFaint = false;

    [[nodiscard]] bool attenuates() const { return attenuation != dvec3(1, 0, 0); }
    /// Of a ray that has come that far.
    [[nodiscard]] double attenuationAt(double distance) const {
        return 1.0 / (attenuation.x + distance * (attenuation.y + distance * attenuation.z));
    }
};

/// Where and when a tree grows.
struct RayWorld {
    const Surfaces& surfaces;
    const trace::MovingScene& scene;
    double time = 0;                          ///< in units of shutter time
    const SampleNumbers* numbers = nullptr;   ///< none: nothing is left to chance
    const AnalyticLights* analytic = nullptr; ///< for AreaLights::analytic
};

/// Why a branch ends, or that it does not.
enum class RayEnd : std::uint8_t {
    splits,         ///< it goes on
    nothingHit,     ///< background
    lightSource,    ///< one that does not reflect
    opaque,         ///< a surface that neither reflects nor lets light pass
    depth,          ///< the tree is deep enough
    cutoff,         ///< it would add too little
    noTransmission, ///< total reflection: there is no such ray
};

enum class Branch : std::uint8_t { eye, reflection, refraction, diffuse };

/// What a light does at a node.
struct LightAtNode {
    trace::Visibility visibility = trace::Visibility::noSurface;
    dvec3 towardWorld{0.0};  ///< L: to its centre, or to the place on it that was chosen
    dvec3 halfwayWorld{0.0}; ///< H, between L and V
    dvec3 intensity{0.0};    ///< sent toward the viewer; zero unless lit
    dvec3 toPlace{0.0};      ///< from the surface to that place, metres; zero: none was chosen
    double areaWeight = 1;   ///< of the sample, where the share of the light's area is asked that is seen
};

/// A ray, and the surface that it meets.
struct TreeNode {
    int parent = -1, level = 0;
    std::uint64_t path = 1; ///< which node of all possible trees: the same number, the same branches on the way to it
    Branch branch = Branch::eye;
    RayEnd end = RayEnd::opaque;
    dvec3 fromCentred{0.0};
    dvec3 u{0.0};               ///< the way of the ray; V is -u
    double contribution = 1;    ///< the share of the pixel that it carries where it begins
    DielectricStack media;      ///< that it travels in
    trace::SurfacePoint point;  ///< none: it meets nothing, or was not followed
    dvec3 positionCentred{0.0}; ///< where it lies at that time
    double distance = 0;        ///< metres
    double attenuation = 1;     ///< what that leaves
    dvec3 normalWorld{0.0};     ///< N, on the viewer's side
    dvec3 reflectedWorld{0.0};  ///< R; zero: there is none
    dvec3 refractedWorld{0.0};  ///< T; zero: there is none
    double iorHere = 1, iorBeyond = 1;
    Weights weights;
    dvec3 diffuseWeight{0.0};                           ///< of what a diffuse surface receives from others
    int reflection = -1, refraction = -1, diffuse = -1; ///< children
    std::size_t firstLight = 0;                         ///< in lightsOf()
    dvec3 local{0.0};              ///< sent by the surface itself: emission, ambient light, lights that it sees
    dvec3 reflectedIntensity{0.0}; ///< I_R
    dvec3 refractedIntensity{0.0}; ///< I_T
    dvec3 diffuseIntensity{0.0};   ///< of the ray that a diffuse surface sends on
    dvec3 intensity{0.0};          ///< I, as it arrives where the ray began

    /// Which of all dimensions of SampleNumbers its samples of a light are, among so many lights.
    [[nodiscard]] std::uint64_t placeOf(int light, std::size_t lights) const {
        return path * lights + static_cast<std::size_t>(light);
    }
    [[nodiscard]] bool isFollowed() const { return point || end == RayEnd::nothingHit; }
};

class RayTree {
public:
    /// Builds and evaluates the tree of a ray from the eye, in that unit direction, which ends at `first`.
    void trace(const RayWorld& world, const TreeSettings& settings, const dvec3& eyeCentred, const dvec3& u,
               const trace::SurfacePoint& first, const DielectricStack& aroundEye);

    /// The root comes first, then level by level.
    [[nodiscard]] const std::vector<TreeNode>& nodes() const { return nodes_; }
    [[nodiscard]] const TreeNode& root() const { return nodes_.front(); }
    /// One for each light of the scene, of a node that has a surface.
    [[nodiscard]] std::span<const LightAtNode> lightsOf(const TreeNode& node) const {
        return {lights_.data() + node.firstLight, node.point ? lightCount_ : 0};
    }
    /// What its rays add to the pixel, by each of the root's branches.
    [[nodiscard]] dvec3 addedByReflection() const {
        return root().attenuation * root().weights.reflected * root().reflectedIntensity;
    }
    [[nodiscard]] dvec3 addedByRefraction() const {
        return root().attenuation * root().weights.transmitted * root().refractedIntensity;
    }
    /// Of rays that were followed, the eye ray's included.
    [[nodiscard]] int levels() const;

private:
    void find(const RayWorld& world, const TreeSettings& settings, TreeNode& node) const;
    void light(const RayWorld& world, const TreeSettings& settings, TreeNode& node);
    void split(const RayWorld& world, const TreeSettings& settings, std::size_t index);
    void splitByOptics(const RayWorld& world, const TreeSettings& settings, std::size_t index);
    /// The new node; nodes may have moved.
    TreeNode& add(const TreeSettings& settings, std::size_t parent, Branch branch, const dvec3& u, double contribution);
    void evaluate(const Surfaces& surfaces);

    std::vector<TreeNode> nodes_;
    std::vector<LightAtNode> lights_;
    std::size_t lightCount_ = 0;
};

} // namespace shadowlab::ray_tracing
