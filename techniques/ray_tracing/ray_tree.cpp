// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/ray_tree.h"

#include <algorithm>

#include "techniques/foundation/scene/shading.h"

namespace shadowlab::ray_tracing {

namespace {

/// What a ray finds where it ended. A sheet has its own medium within, too thin to bend a ray that comes out behind it.
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

/// With the shading normal, so that a ball made of triangles mirrors like a ball; but where that would send a ray to the
/// wrong side of the triangle, with the triangle's own.
Optics opticsAt(const Surfaces& surfaces, const TreeNode& node, Fresnel fresnel) {
    const Optics smooth = opticsWith(node.normalWorld, surfaces, node, fresnel);
    const dvec3 flatWorld = surfaces.geometricNormalWorld(node.point);
    const bool fits = glm::dot(smooth.reflectedWorld, flatWorld) > 0 &&
                      !(smooth.refractedWorld && glm::dot(*smooth.refractedWorld, flatWorld) >= 0);
    return fits ? smooth : opticsWith(flatWorld, surfaces, node, fresnel);
}

} // namespace

void RayTree::trace(const Surfaces& surfaces, const TreeSettings& settings, const dvec3& eyeCentred, const dvec3& u,
                    const trace::SurfacePoint& first, const DielectricStack& aroundEye) {
    nodes_.clear();
    lights_.clear();
    lightCount_ = surfaces.scene().lights.size();
    TreeNode eye;
    eye.fromCentred = eyeCentred;
    eye.u = u;
    eye.media = aroundEye;
    eye.point = first;
    nodes_.push_back(std::move(eye));
    // Going down: the list grows while it is gone through.
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].end == RayEnd::noTransmission || nodes_[i].end == RayEnd::depth ||
            nodes_[i].end == RayEnd::cutoff)
            continue;
        find(surfaces, settings, nodes_[i]);
        if (!nodes_[i].point) {
            nodes_[i].end = RayEnd::nothingHit;
            continue;
        }
        nodes_[i].attenuation = settings.left(nodes_[i].distance);
        light(surfaces, settings, nodes_[i]);
        split(surfaces, settings, i);
    }
    evaluate(surfaces);
}

/// The first surface on the ray's way that is really there. Without any splitting all of them are, as in other techniques.
void RayTree::find(const Surfaces& surfaces, const TreeSettings& settings, TreeNode& node) const {
    const trace::SceneTracer& tracer = surfaces.tracer();
    if (node.parent >= 0) node.point = tracer.nextPoint(nodes_[static_cast<std::size_t>(node.parent)].point, node.u);
    while (settings.depth > 0 && node.point && surfaces.isSolid(node.point)) {
        const Medium medium = surfaces.mediumOf(node.point);
        const bool entered = surfaces.isEntered(node.point);
        if (node.media.crossing(medium, entered).isReal) break;
        node.media.cross(medium, entered);
        node.point = tracer.nextPoint(node.point, node.u);
    }
    if (node.point) node.distance = glm::length(tracer.positionCentred(node.point) - node.fromCentred);
}

/// The surface's own light: as in every other technique.
void RayTree::light(const Surfaces& surfaces, const TreeSettings& settings, TreeNode& node) {
    const trace::SceneTracer& tracer = surfaces.tracer();
    const dvec3 positionWorld = tracer.positionWorld(node.point);
    node.normalWorld = surfaces.normalWorld(node.point, -node.u);
    node.local = dvec3(surfaces.lightsOff(node.point));
    node.firstLight = lights_.size();
    for (int l = 0; l < static_cast<int>(lightCount_); ++l) {
        LightAtNode at;
        at.towardWorld = scene::towardLightWorld(surfaces.scene().lights[static_cast<std::size_t>(l)], positionWorld);
        at.halfwayWorld = glm::normalize(at.towardWorld - node.u);
        at.visibility = tracer.visibility(node.point, l, settings.start);
        if (at.visibility == trace::Visibility::lit)
            at.intensity = surfaces.lit(node.point, l, positionWorld, node.normalWorld, -node.u);
        node.local += at.intensity;
        lights_.push_back(at);
    }
}

void RayTree::split(const Surfaces& surfaces, const TreeSettings& settings, std::size_t index) {
    TreeNode& node = nodes_[index];
    if (!surfaces.splits(node.point)) {
        const bool shines = surfaces.materialOf(node.point).emission != vec3(0) && surfaces.emitsHere(node.point);
        node.end = shines ? RayEnd::lightSource : RayEnd::opaque;
        return;
    }
    if (settings.depth == 0) {
        node.end = RayEnd::depth;
        return;
    }
    node.end = RayEnd::splits;
    const Crossing crossing = crossingAt(surfaces, node);
    node.iorHere = crossing.iorHere;
    node.iorBeyond = crossing.iorBeyond;
    const Optics optics = opticsAt(surfaces, node, settings.fresnel);
    node.weights = optics.weights;
    TreeNode child;
    child.level = node.level + 1;
    child.fromCentred = surfaces.tracer().positionCentred(node.point);
    child.media = node.media;
    if (node.weights.reflected > 0) {
        node.reflectedWorld = optics.reflectedWorld;
        child.branch = Branch::reflection;
        child.u = optics.reflectedWorld;
        child.contribution = node.contribution * node.attenuation * node.weights.reflected;
        add(settings, index, child); // `node` may have moved from here on
    }
    child.branch = Branch::refraction;
    if (optics.weights.isTotal) {
        child.end = RayEnd::noTransmission;
        child.u = dvec3(0.0);
        child.contribution = 0;
        add(settings, index, std::move(child));
    } else if (optics.refractedWorld && optics.weights.transmitted > 0) {
        TreeNode& parent = nodes_[index];
        parent.refractedWorld = *optics.refractedWorld;
        child.u = *optics.refractedWorld;
        child.contribution = parent.contribution * parent.attenuation * parent.weights.transmitted;
        if (surfaces.isSolid(parent.point))
            child.media.cross(surfaces.mediumOf(parent.point), surfaces.isEntered(parent.point));
        add(settings, index, std::move(child));
    }
}

void RayTree::add(const TreeSettings& settings, std::size_t parent, TreeNode child) {
    const int number = static_cast<int>(nodes_.size());
    (child.branch == Branch::reflection ? nodes_[parent].reflection : nodes_[parent].refraction) = number;
    child.parent = static_cast<int>(parent);
    if (child.end != RayEnd::noTransmission) {
        if (child.level > settings.depth)
            child.end = RayEnd::depth;
        else if (child.contribution < settings.cutoff)
            child.end = RayEnd::cutoff;
    }
    nodes_.push_back(std::move(child));
}

/// Coming up: every node has its children behind it.
void RayTree::evaluate(const Surfaces& surfaces) {
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        TreeNode& node = nodes_[i];
        if (node.point)
            node.intensity = node.attenuation * (node.local + node.weights.reflected * node.reflectedIntensity +
                                                 node.weights.transmitted * node.refractedIntensity);
        else if (node.end != RayEnd::noTransmission)
            node.intensity = dvec3(surfaces.scene().background);
        if (node.parent < 0) continue;
        TreeNode& parent = nodes_[static_cast<std::size_t>(node.parent)];
        (node.branch == Branch::reflection ? parent.reflectedIntensity : parent.refractedIntensity) = node.intensity;
    }
}

int RayTree::levels() const {
    int levels = 0;
    for (const TreeNode& node : nodes_)
        if (node.isFollowed()) levels = std::max(levels, node.level + 1);
    return levels;
}

} // namespace shadowlab::ray_tracing
