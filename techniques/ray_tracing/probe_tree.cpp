// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe_tree.h"

#include <string>

#include "techniques/ray_tracing/ray_ends.h"

namespace shadowlab::ray_tracing {

namespace {

std::string text(const dvec3& v) {
    return std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z);
}

std::string labelOf(const TreeNode& node) {
    const std::string level = " " + std::to_string(node.level);
    switch (node.branch) {
    case Branch::eye: return "eye ray";
    case Branch::reflection: return "reflection ray R" + level;
    case Branch::refraction: return "refraction ray T" + level;
    }
    return "";
}

std::string endOf(const TreeNode& node) {
    switch (node.end) {
    case RayEnd::splits: return "splits";
    case RayEnd::nothingHit: return "ends: meets nothing, background";
    case RayEnd::lightSource: return "ends: a light source that does not reflect";
    case RayEnd::opaque: return "ends: neither reflects nor lets light pass";
    case RayEnd::depth: return node.point ? "ends: depth is 0" : "not followed: the tree is deep enough";
    case RayEnd::cutoff: return "not followed: would add less than the cut-off";
    case RayEnd::noTransmission: return "none: total reflection";
    }
    return "";
}

std::string answerOf(const Surfaces& surfaces, const trace::SurfacePoint& point, int light) {
    const trace::SceneTracer& tracer = surfaces.tracer();
    if (!tracer.facesLight(point, light)) return "not sent: faces away, or outside the light";
    if (!tracer.objectOf(point).receivesShadow) return "not sent: receives no shadow";
    const std::uint32_t blocker = tracer.blocker(point, light);
    if (blocker == trace::kNoPrimitive) return "arrives";
    return "blocked by " + surfaces.scene().objects[tracer.world().objects[blocker]].name;
}

std::vector<Probe::Fact> factsOf(const TreeNode& node, const Surfaces& surfaces) {
    std::vector<Probe::Fact> facts;
    const auto fact = [&](std::string label, std::string value, std::string unit = "") {
        facts.push_back({std::move(label), std::move(value), std::move(unit)});
    };
    if (node.point) {
        fact("hits", surfaces.tracer().objectOf(node.point).name);
        fact("after", std::to_string(node.distance), "m");
        fact("at", text(surfaces.tracer().positionWorld(node.point)), "m");
    }
    fact("branch", endOf(node));
    fact("contribution", std::to_string(node.contribution));
    if (node.end != RayEnd::noTransmission) {
        fact("u", text(node.u));
        fact("V", text(-node.u));
    }
    if (node.point) fact("N", text(node.normalWorld));
    if (node.end == RayEnd::splits) {
        if (node.reflectedWorld != dvec3(0)) fact("R", text(node.reflectedWorld));
        if (node.refractedWorld != dvec3(0)) fact("T", text(node.refractedWorld));
        if (surfaces.materialOf(node.point).transparency > 0)
            fact("index of refraction", std::to_string(node.iorHere) + " to " + std::to_string(node.iorBeyond));
        fact("weight of I_R", std::to_string(node.weights.reflected));
        fact("weight of I_T", std::to_string(node.weights.transmitted));
        fact("I_R", text(node.reflectedIntensity));
        fact("I_T", text(node.refractedIntensity));
    }
    if (node.point) {
        fact("own light", text(node.local));
        fact("attenuation", std::to_string(node.attenuation));
    }
    fact("I", text(node.intensity));
    return facts;
}

} // namespace

void describeTree(const RayTree& tree, const Surfaces& surfaces, int light, Probe& probe) {
    const trace::SceneTracer& tracer = surfaces.tracer();
    const scene::Bounds bounds = boundsOf(surfaces.scene());
    std::vector<int> places; // of the tree's nodes in the probe's
    for (const TreeNode& node : tree.nodes()) {
        const int place = static_cast<int>(probe.tree.size());
        places.push_back(place);
        const int parent = node.parent < 0 ? -1 : places[static_cast<std::size_t>(node.parent)];
        probe.tree.push_back({parent, labelOf(node), factsOf(node, surfaces)});
        for (std::size_t l = 0; l < tree.lightsOf(node).size(); ++l) {
            const LightAtNode& at = tree.lightsOf(node)[l];
            probe.tree.push_back({place,
                                  "shadow ray to " + surfaces.scene().lights[l].name,
                                  {{"result", answerOf(surfaces, node.point, static_cast<int>(l)), ""},
                                   {"L", text(at.towardWorld), ""},
                                   {"H", text(at.halfwayWorld), ""},
                                   {"I", text(at.intensity), ""}}});
        }
        if (node.parent < 0 || !node.isFollowed()) continue;
        const dvec3 fromWorld = tracer.world().originWorld + node.fromCentred;
        if (!node.point) {
            probe.geometry.push_back({labelOf(node), fromWorld, endBeyond(bounds, fromWorld, node.u)});
            continue;
        }
        const dvec3 endWorld = tracer.positionWorld(node.point);
        probe.geometry.push_back({labelOf(node), fromWorld, endWorld});
        const auto lights = tree.lightsOf(node);
        if (light < 0 || light >= static_cast<int>(lights.size()) ||
            lights[static_cast<std::size_t>(light)].visibility < trace::Visibility::shadowed)
            continue;
        probe.geometry.push_back({"shadow ray", endWorld, shadowRayEnd(tracer, node.point, light, bounds)});
    }
}

} // namespace shadowlab::ray_tracing
