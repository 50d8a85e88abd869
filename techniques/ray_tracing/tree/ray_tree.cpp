// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/tree/ray_tree.h"

#include <algorithm>

#include "techniques/ray_tracing/sampling/lobe.h"
#include "techniques/ray_tracing/tree/node_lights.h"

namespace shadowlab::ray_tracing {

namespace {

/// The indices of refraction on both sides of the surface. A sheet has its own medium inside, too thin to bend a ray that leaves
/// it on the other side.
Crossing crossingAt(const Surfaces& surfaces, const TreeNode& node) {
    if (surfaces.isSolid(node.point))
        return node.media.crossing(surfaces.mediumOf(node.point), surfaces.isEntered(node.point));
    return {node.media.ior(), surfaces.materialOf(node.point).ior, true};
}

/// Reflection and refraction at a surface: the two directions, and their weights.
struct Optics {
    dvec3 reflectedWorld{0.0};
    std::optional<dvec3> refractedWorld;
    Weights weights;
};

Optics opticsWith(const dvec3& normalWorld, const Surfaces& surfaces, const TreeNode& node, Fresnel fresnel) {
    const scene::Material& material = surfaces.materialOf(node.point);
    const double ratio = node.iorHere / node.iorBeyond;
    const double cosIncident = -glm::dot(node.u, normalWorld);
    Optics optics;
    optics.weights = weightsOf(material.reflectivity, material.transparency, cosIncident, ratio, fresnel);
    optics.reflectedWorld = reflected(node.u, normalWorld);
    if (material.transparency > 0 && !optics.weights.isTotal)
        optics.refractedWorld = surfaces.isSolid(node.point) ? refracted(node.u, normalWorld, ratio) : node.u;
    return optics;
}

/// With the shading normal, so that a ball made of triangles reflects like a ball; but with the triangle's own normal where a ray
/// would otherwise leave on the wrong side of the triangle.
Optics opticsAt(const Surfaces& surfaces, const TreeNode& node, Fresnel fresnel) {
    // Turned to where the ray comes from, also where it leans away at a rim.
    const dvec3 smoothWorld = glm::dot(node.u, node.normalWorld) > 0 ? -node.normalWorld : node.normalWorld;
    const Optics smooth = opticsWith(smoothWorld, surfaces, node, fresnel);
    const dvec3 flatWorld = surfaces.geometricNormalWorld(node.point);
    const bool fits = glm::dot(smooth.reflectedWorld, flatWorld) > 0 &&
                      !(smooth.refractedWorld && glm::dot(*smooth.refractedWorld, flatWorld) >= 0);
    return fits ? smooth : opticsWith(flatWorld, surfaces, node, fresnel);
}

/// Attempts to find a direction on the right side of the surface. At least half of a lobe lies there, so all attempts fail once
/// in 2^32 rays; then the axis itself is used.
constexpr std::uint32_t kTries = 32;

/// A random direction of the lobe, on the same side of the surface as `sideWorld`; nothing where lobes are cut and it lies below.
std::optional<dvec3> sampleLobe(const RayWorld& world, const TreeSettings& settings, const dvec3& axisWorld,
                                double power, const dvec3& sideWorld, Purpose purpose, std::uint64_t path) {
    for (std::uint32_t attempt = 0; attempt < (settings.wholeLobes ? kTries : 1); ++attempt) {
        const dvec3 direction = lobeDirection(axisWorld, power, world.numbers->pair(purpose, path, attempt));
        if (glm::dot(direction, sideWorld) > 0) return direction;
    }
    if (settings.wholeLobes) return axisWorld;
    return std::nullopt;
}

// Glass makes trees of some dozens of rays; the vector grows for larger ones.
constexpr std::size_t kUsualNodes = 64;

// Russian roulette: a ray that carries at least this share of the pixel is always followed. Less than half of a share is not worth a ray of
// its own; with more, dark surfaces would end paths that cost little and add noise.
constexpr double kSure = 0.5;

// From this level on no ray is sure to be followed: between perfect mirrors, or in a room that reflects everything, it would go on for
// ever. What is followed counts for so much more, a hundredth.
constexpr int kSureLevels = 16;
constexpr double kMostSurvival = 0.99;

// The branches on the way to a node fill its number, two bits each, up to this level; below, they are mixed. Numbers are multiplied by
// eight and by the number of lights before they are used (sample_numbers.h), so a few bits must be left.
constexpr int kNumberedLevels = 26;

/// The number of a node's child. An odd factor mixes: D. Knuth, "The Art of Computer Programming", volume 2, section 3.3.4 (MMIX).
std::uint64_t pathOfChild(const TreeNode& node, Branch branch) {
    const auto turn = static_cast<std::uint64_t>(branch);
    return node.level < kNumberedLevels ? 4 * node.path + turn : node.path * 6364136223846793005u + 1442695040888963407u + turn;
}

/// Follows the ray with a probability that falls with its contribution, and then counts it for as much more: no light is lost on
/// average, and paths end by themselves. J. Arvo and D. Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990.
// [anchor: russian-roulette]
void russianRoulette(TreeNode& node, const SampleNumbers& numbers) {
    node.survival = std::min(node.contribution / kSure, node.level < kSureLevels ? 1.0 : kMostSurvival);
    if (numbers.pair(Purpose::survival, node.path).x < node.survival)
        node.contribution /= node.survival;
    else
        node.end = RayEnd::chance;
}

// Lambert's law: the irradiance of a diffuse surface is weighted by the cosine to its normal.
constexpr double kLambertPower = 1;

} // namespace

void RayTree::trace(const RayWorld& world, const TreeSettings& settings, const dvec3& eyeCentred, const dvec3& u,
                    const trace::SurfacePoint& first, const DielectricStack& aroundEye) {
    nodes_.clear();
    lights_.clear();
    lightCount_ = world.surfaces.scene().lights.size();
    nodes_.reserve(kUsualNodes);
    TreeNode& eye = nodes_.emplace_back();
    eye.fromCentred = eyeCentred;
    eye.u = u;
    eye.media = aroundEye;
    eye.point = first;
    // From the root down: the list grows during the loop.
    // [anchor: tree-grows]
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].end == RayEnd::noTransmission || nodes_[i].end == RayEnd::depth ||
            nodes_[i].end == RayEnd::cutoff || nodes_[i].end == RayEnd::chance)
            continue;
        find(world, settings, nodes_[i]);
        if (!nodes_[i].point) {
            nodes_[i].end = RayEnd::nothingHit;
            continue;
        }
        nodes_[i].attenuation = settings.attenuationAt(nodes_[i].distance);
        light(world, settings, nodes_[i]);
        split(world, settings, i);
    }
    evaluate(world.surfaces);
}

/// The first surface on the ray's way that is not inside a medium of higher priority. Without splitting all surfaces count, as in
/// other techniques.
void RayTree::find(const RayWorld& world, const TreeSettings& settings, TreeNode& node) const {
    const Surfaces& surfaces = world.surfaces;
    const auto next = [&](const dvec3& fromCentred, std::uint32_t leftOut) {
        trace::Ray ray;
        ray.originCentred = fromCentred;
        ray.directionCentred = node.u;
        ray.nearest = trace::kContactPerMetre * (1.0 + glm::length(fromCentred));
        return world.scene.met(ray, leftOut, world.time);
    };
    if (node.parent >= 0)
        node.point = next(node.fromCentred, nodes_[static_cast<std::size_t>(node.parent)].point.primitive);
    while (settings.depth > 0 && node.point && surfaces.isSolid(node.point)) {
        const Medium medium = surfaces.mediumOf(node.point);
        const bool entered = surfaces.isEntered(node.point);
        if (node.media.crossing(medium, entered).isReal) break;
        node.media.cross(medium, entered);
        node.point = next(world.scene.positionCentred(node.point, world.time), node.point.primitive);
    }
    if (!node.point) return;
    node.positionCentred = world.scene.positionCentred(node.point, world.time);
    node.distance = glm::length(node.positionCentred - node.fromCentred);
}

/// The light that the surface sends by itself and reflects of the lights, as in every other technique. Ambient light stands for
/// interreflection, so it is left out where rays are sent for that; and so is the emission of lights whose light was already
/// sampled at the surface before.
void RayTree::light(const RayWorld& world, const TreeSettings& settings, TreeNode& node) {
    const Surfaces& surfaces = world.surfaces;
    node.normalWorld = surfaces.normalWorld(node.point, -node.u);
    const bool counted = node.branch == Branch::diffuse && surfaces.tracer().objectOf(node.point).emitterOfLight >= 0;
    if (!settings.interreflection)
        node.local = dvec3(surfaces.lightsOff(node.point));
    else if (!counted)
        node.local = dvec3(surfaces.emitted(node.point));
    node.firstLight = lights_.size();
    for (int l = 0; l < static_cast<int>(lightCount_); ++l) {
        lights_.push_back(lightAt(world, settings, node, l));
        node.local += lights_.back().intensity;
    }
}

void RayTree::split(const RayWorld& world, const TreeSettings& settings, std::size_t index) {
    TreeNode& node = nodes_[index];
    const Surfaces& surfaces = world.surfaces;
    const dvec3 diffuse(surfaces.diffuseOf(node.point));
    const bool spreads = settings.interreflection && world.numbers && diffuse != dvec3(0.0);
    if (!surfaces.splits(node.point) && !spreads) {
        node.end = surfaces.emitsHere(node.point) ? RayEnd::lightSource : RayEnd::opaque;
        return;
    }
    if (settings.depth == 0) {
        node.end = RayEnd::depth;
        return;
    }
    node.end = RayEnd::splits;
    if (spreads) {
        const auto direction = sampleLobe(world, settings, node.normalWorld, kLambertPower,
                                          surfaces.geometricNormalWorld(node.point), Purpose::diffuse, node.path);
        if (direction) {
            node.diffuseWeight = diffuse;
            add(world, settings, index, Branch::diffuse, *direction,
                node.contribution * node.attenuation * std::max({diffuse.x, diffuse.y, diffuse.z}));
        }
    }
    if (surfaces.splits(nodes_[index].point)) splitByOptics(world, settings, index);
}

void RayTree::splitByOptics(const RayWorld& world, const TreeSettings& settings, std::size_t index) {
    const Surfaces& surfaces = world.surfaces;
    TreeNode& node = nodes_[index];
    const trace::SurfacePoint point = node.point;
    const std::uint64_t path = node.path;
    const scene::Material& material = surfaces.materialOf(point);
    const Crossing crossing = crossingAt(surfaces, node);
    node.iorHere = crossing.iorHere;
    node.iorBeyond = crossing.iorBeyond;
    // [anchor: tree-splits]
    const Optics optics = opticsAt(surfaces, node, settings.fresnel);
    const Weights& weights = optics.weights;
    const bool letsThrough = optics.refractedWorld && weights.transmitted > 0;
    node.weights = weights;
    if (weights.reflected > 0) node.reflectedWorld = optics.reflectedWorld;
    if (letsThrough) node.refractedWorld = *optics.refractedWorld;
    const double arriving = node.contribution * node.attenuation;
    // `node` may move from here on.
    if (weights.reflected > 0) {
        std::optional<dvec3> direction = optics.reflectedWorld;
        if (settings.gloss && world.numbers && material.glossDegrees > 0)
            direction = sampleLobe(world, settings, *direction, lobePower(material.glossDegrees),
                                   surfaces.geometricNormalWorld(point), Purpose::reflection, path);
        if (direction) add(world, settings, index, Branch::reflection, *direction, arriving * weights.reflected);
    }
    if (weights.isTotal) {
        add(world, settings, index, Branch::refraction, dvec3(0.0), 0).end = RayEnd::noTransmission;
    } else if (letsThrough) {
        std::optional<dvec3> direction = optics.refractedWorld;
        if (settings.translucency && world.numbers && material.translucencyDegrees > 0)
            direction = sampleLobe(world, settings, *direction, lobePower(material.translucencyDegrees),
                                   -surfaces.geometricNormalWorld(point), Purpose::refraction, path);
        if (!direction) return;
        TreeNode& child = add(world, settings, index, Branch::refraction, *direction, arriving * weights.transmitted);
        if (surfaces.isSolid(point)) child.media.cross(surfaces.mediumOf(point), surfaces.isEntered(point));
    }
}

TreeNode& RayTree::add(const RayWorld& world, const TreeSettings& settings, std::size_t parent, Branch branch,
                       const dvec3& u, double contribution) {
    const int number = static_cast<int>(nodes_.size());
    TreeNode& child = nodes_.emplace_back();
    TreeNode& from = nodes_[parent];
    (branch == Branch::reflection   ? from.reflection
     : branch == Branch::refraction ? from.refraction
                                    : from.diffuse) = number;
    child.parent = static_cast<int>(parent);
    child.level = from.level + 1;
    child.path = pathOfChild(from, branch);
    child.branch = branch;
    child.fromCentred = from.positionCentred;
    child.u = u;
    child.contribution = contribution;
    child.media = from.media;
    if (settings.roulette && settings.interreflection && world.numbers)
        russianRoulette(child, *world.numbers);
    else if (child.level > settings.depth)
        child.end = RayEnd::depth;
    else if (contribution < settings.cutoff)
        child.end = RayEnd::cutoff;
    return child;
}

/// From the leaves up: children always come after their parent.
void RayTree::evaluate(const Surfaces& surfaces) {
    // [anchor: tree-evaluates]
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        TreeNode& node = nodes_[i];
        if (node.point)
            node.intensity = node.attenuation / node.survival *
                             (node.local + node.weights.reflected * node.reflectedIntensity +
                              node.weights.transmitted * node.refractedIntensity +
                              node.diffuseWeight * node.diffuseIntensity);
        else if (node.end != RayEnd::noTransmission && node.end != RayEnd::chance)
            node.intensity = dvec3(surfaces.scene().background) / node.survival;
        if (node.parent < 0) continue;
        TreeNode& parent = nodes_[static_cast<std::size_t>(node.parent)];
        (node.branch == Branch::reflection   ? parent.reflectedIntensity
         : node.branch == Branch::refraction ? parent.refractedIntensity
                                             : parent.diffuseIntensity) = node.intensity;
    }
}

int RayTree::levels() const {
    int levels = 0;
    for (const TreeNode& node : nodes_)
        if (node.isFollowed()) levels = std::max(levels, node.level + 1);
    return levels;
}

} // namespace shadowlab::ray_tracing
