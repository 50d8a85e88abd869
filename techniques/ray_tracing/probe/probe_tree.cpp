// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/pixel_probe.h"

#include <string>

#include "techniques/ray_tracing/probe/ray_shapes.h"

namespace shadowlab::ray_tracing {

namespace {

Probe::Role roleOf(Branch branch) {
    if (branch == Branch::eye) return Probe::Role::eye;
    return branch == Branch::reflection ? Probe::Role::reflection : Probe::Role::refraction;
}

/// Empty where the ray splits.
std::string endOf(const TreeNode& node) {
    switch (node.end) {
    case RayEnd::splits: return "";
    case RayEnd::nothingHit: return "meets nothing: background";
    case RayEnd::lightSource: return "a light source that does not reflect";
    case RayEnd::opaque: return "neither reflects nor lets light pass";
    case RayEnd::depth: return node.point ? "depth is 0" : "not followed: the tree is deep enough";
    case RayEnd::cutoff: return "not followed: would add less than the cut-off";
    case RayEnd::chance: return "ended by chance: those that go on count for more";
    case RayEnd::noTransmission: return "none: total reflection";
    }
    return "";
}

/// Adds the nodes and lines of one tree to a probe.
class Describer {
public:
    Describer(const RayTree& tree, const Surfaces& surfaces, int light, Probe& probe)
        : tree_(tree), surfaces_(surfaces), tracer_(surfaces.tracer()), bounds_(boundsOf(surfaces.scene())),
          light_(light), probe_(probe) {}

    void describe() {
        probe_.geometry.clear();
        int surface = 0;
        for (const TreeNode& node : tree_.nodes()) {
            places_.push_back(static_cast<int>(probe_.tree.size()));
            numbers_.push_back(node.point ? ++surface : 0);
            probe_.tree.push_back(nodeOf(node));
            if (node.point)
                for (std::size_t l = 0; l < tree_.lightsOf(node).size(); ++l)
                    addShadowRay(node, places_.back(), static_cast<int>(l));
        }
        addVectors();
    }

private:
    using Facts = std::vector<Probe::Fact>;

    Probe::Node nodeOf(const TreeNode& node) {
        Probe::Node shown{node.parent < 0 ? -1 : places_[static_cast<std::size_t>(node.parent)], labelOf(node),
                          factsOf(node)};
        shown.role = roleOf(node.branch);
        if (node.parent >= 0) shown.sign = signOf(node);
        shown.end = endOf(node);
        shown.share = node.contribution;
        shown.intensity = node.intensity;
        if (node.point) {
            shown.surface = "S" + std::to_string(numbers_.back());
            shown.object = tracer_.objectOf(node.point).name;
            shown.normalWorld = node.normalWorld;
        }
        if (!node.isFollowed()) return shown;
        const dvec3 fromWorld = tracer_.world().originWorld + node.fromCentred;
        const dvec3 toWorld = node.point ? tracer_.positionWorld(node.point) : endBeyond(bounds_, fromWorld, node.u);
        shown.segment = static_cast<int>(probe_.geometry.size());
        probe_.geometry.push_back({shown.label, fromWorld, toWorld, shown.role, !node.point});
        return shown;
    }

    [[nodiscard]] std::string signOf(const TreeNode& node) const {
        return (node.branch == Branch::reflection ? "R" : "T") +
               std::to_string(numbers_[static_cast<std::size_t>(node.parent)]);
    }
    [[nodiscard]] std::string labelOf(const TreeNode& node) const {
        if (node.parent < 0) return "eye ray";
        return (node.branch == Branch::reflection ? "reflection ray " : "refraction ray ") + signOf(node);
    }

    [[nodiscard]] Facts factsOf(const TreeNode& node) const {
        Facts facts;
        if (node.point) {
            facts.push_back({"hits", tracer_.objectOf(node.point).name, ""});
            facts.push_back({"surface", "S" + std::to_string(numbers_.back()), ""});
            facts.push_back({"material", surfaces_.materialOf(node.point).name, ""});
            facts.push_back(probeFact("after", node.distance, "m"));
            facts.push_back(probeFact("at", tracer_.positionWorld(node.point), "m"));
        }
        facts.push_back({"branch", node.end == RayEnd::splits ? "splits" : endOf(node), ""});
        facts.push_back(probeFact("contribution", node.contribution));
        if (node.end != RayEnd::noTransmission) {
            facts.push_back(probeFact("u", node.u));
            facts.push_back(probeFact("V", -node.u));
        }
        if (node.point) facts.push_back(probeFact("N", node.normalWorld));
        if (node.end == RayEnd::splits) addSplit(node, facts);
        if (node.point) {
            // A high power of a small cosine may be 1e-187: shown as 0.
            constexpr double kNoLight = 1e-30;
            facts.push_back(probeFact(
                "own light", glm::mix(node.local, dvec3(0), glm::lessThan(glm::abs(node.local), dvec3(kNoLight)))));
            facts.push_back(probeFact("attenuation", node.attenuation));
        }
        if (node.end != RayEnd::noTransmission) facts.push_back(probeFact("I", node.intensity));
        return facts;
    }

    void addSplit(const TreeNode& node, Facts& facts) const {
        if (node.reflectedWorld != dvec3(0)) facts.push_back(probeFact("R", node.reflectedWorld));
        if (node.refractedWorld != dvec3(0)) facts.push_back(probeFact("T", node.refractedWorld));
        if (surfaces_.materialOf(node.point).transparency > 0)
            facts.push_back({"index of refraction",
                             probeText(node.iorHere) + " to " + probeText(node.iorBeyond),
                             "",
                             {node.iorHere, node.iorBeyond}});
        facts.push_back(probeFact("weight of I_R", node.weights.reflected));
        facts.push_back(probeFact("weight of I_T", node.weights.transmitted));
        facts.push_back(probeFact("I_R", node.reflectedIntensity));
        facts.push_back(probeFact("I_T", node.refractedIntensity));
    }

    void addShadowRay(const TreeNode& node, int parent, int light) {
        const LightAtNode& at = tree_.lightsOf(node)[static_cast<std::size_t>(light)];
        const scene::Light& source = surfaces_.scene().light(light);
        const std::string result = answerOf(node.point, light);
        Probe::Node shown{parent,
                          "shadow ray to " + source.name,
                          {{"result", result, ""},
                           probeFact("L", at.towardWorld),
                           probeFact("H", at.halfwayWorld),
                           probeFact("I", at.intensity)}};
        const bool arrives = result == "arrives";
        shown.role = arrives ? Probe::Role::arriving : Probe::Role::blocked;
        shown.light = light;
        shown.end = result;
        shown.intensity = at.intensity;
        if (light == light_ && at.visibility >= trace::Visibility::shadowed) {
            shown.segment = static_cast<int>(probe_.geometry.size());
            probe_.geometry.push_back({"shadow ray", tracer_.positionWorld(node.point),
                                       shadowRayEnd(tracer_, node.point, light, bounds_), shown.role,
                                       arrives && source.type == scene::LightType::directional});
        }
        probe_.tree.push_back(std::move(shown));
    }

    [[nodiscard]] std::string answerOf(const trace::SurfacePoint& point, int light) const {
        if (!tracer_.facesLight(point, light)) return "not sent: faces away, or outside the light";
        if (!tracer_.objectOf(point).receivesShadow) return "not sent: receives no shadow";
        const std::uint32_t blocker = tracer_.blocker(point, light);
        if (blocker == trace::kNoPrimitive) return "arrives";
        return "blocked by " + surfaces_.scene().objects[tracer_.world().objects[blocker]].name;
    }

    void addVectors() {
        const TreeNode& root = tree_.root();
        const auto add = [&](const char* letter, const dvec3& directionWorld) {
            if (directionWorld != dvec3(0)) probe_.vectors.push_back({letter, directionWorld});
        };
        add("u", root.u);
        add("V", -root.u);
        add("N", root.normalWorld);
        add("R", root.reflectedWorld);
        add("T", root.refractedWorld);
        if (light_ < 0 || light_ >= static_cast<int>(tree_.lightsOf(root).size())) return;
        add("L", tree_.lightsOf(root)[static_cast<std::size_t>(light_)].towardWorld);
        add("H", tree_.lightsOf(root)[static_cast<std::size_t>(light_)].halfwayWorld);
    }

    const RayTree& tree_;
    const Surfaces& surfaces_;
    const trace::SceneTracer& tracer_;
    const scene::Bounds bounds_;
    const int light_;
    Probe& probe_;
    std::vector<int> places_;  ///< for each node of the tree its number in the probe
    std::vector<int> numbers_; ///< for each node the number of its surface; 0: none
};

} // namespace

void describeTree(const RayTree& tree, const Surfaces& surfaces, int light, Probe& probe) {
    Describer(tree, surfaces, light, probe).describe();
}

} // namespace shadowlab::ray_tracing
