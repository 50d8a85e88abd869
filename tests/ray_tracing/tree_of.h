// Trees of single rays through a scene made for a test.
// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/ray_tracing/tree/ray_tree.h"
#include "techniques/technique.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

/// A scene ready for rays.
class TracedScene {
public:
    explicit TracedScene(scene::Scene scene) {
        scene.revisions = {}; // a copy that was changed is another scene
        EXPECT_TRUE(tracer_.advance(snapshot(std::move(scene)), Deadline::max()));
        surfaces_.emplace(tracer_);
    }
    TracedScene(const TracedScene&) = delete; // the surfaces point into it
    TracedScene& operator=(const TracedScene&) = delete;

    [[nodiscard]] const trace::SceneTracer& tracer() const { return tracer_; }
    [[nodiscard]] const ray_tracing::Surfaces& surfaces() const { return *surfaces_; }
    [[nodiscard]] dvec3 centred(const dvec3& positionWorld) const {
        return positionWorld - tracer_.world().originWorld;
    }
    [[nodiscard]] dvec3 positionWorld(const ray_tracing::TreeNode& node) const {
        return tracer_.positionWorld(node.point);
    }

    /// Empty where the ray meets nothing.
    [[nodiscard]] ray_tracing::RayTree tree(const dvec3& fromWorld, const dvec3& towardWorld,
                                            const ray_tracing::TreeSettings& settings) const {
        const dvec3 u = glm::normalize(towardWorld - fromWorld);
        const trace::SurfacePoint first = tracer_.nextPoint(centred(fromWorld), trace::kNoPrimitive, u);
        ray_tracing::RayTree tree;
        if (first)
            tree.trace({*surfaces_, trace::MovingScene(tracer_)}, settings, centred(fromWorld), u, first,
                       surfaces_->mediaAround(centred(fromWorld)));
        return tree;
    }

private:
    trace::SceneTracer tracer_;
    std::optional<ray_tracing::Surfaces> surfaces_;
};

/// Black unless told otherwise, so that a surface has no light of its own.
inline std::uint32_t addMaterial(scene::Scene& scene, double reflectivity, double transparency, double ior = 1.5,
                                 int priority = 0, float emission = 0) {
    scene::Material material;
    material.diffuse = vec3(0.0f);
    material.reflectivity = reflectivity;
    material.transparency = transparency;
    material.ior = ior;
    material.priority = priority;
    material.emission = vec3(emission);
    material.emits = scene::EmittingSides::both;
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

inline scene::Object& addObject(scene::Scene& scene, scene::Mesh mesh, std::uint32_t material,
                                const dmat4& worldFromObject) {
    scene::Object& object = addObject(scene, std::move(mesh), worldFromObject);
    object.partMaterials.assign(object.mesh->parts.size(), material);
    return object;
}

/// The chain of refraction rays, from the eye ray on.
inline std::vector<ray_tracing::TreeNode> refractions(const ray_tracing::RayTree& tree) {
    std::vector<ray_tracing::TreeNode> chain;
    for (int i = 0; i >= 0; i = chain.back().refraction)
        chain.push_back(tree.nodes()[static_cast<std::size_t>(i)]);
    return chain;
}

} // namespace shadowlab::testing
