// Pixels taken by chance, of every built-in scene, and what a technique's probe says of each.
// SPDX-License-Identifier: MIT
#pragma once
#include <random>
#include <string>
#include <vector>

#include "app/context/assets.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/holes.h"
#include "tests/support/brute_force.h"

namespace shadowlab::testing {

constexpr ivec2 kPictureSize{320, 180};

struct AskedPixel {
    const scene::Scene& scene;
    const std::vector<WorldTriangle>& triangles;
    const std::string& name; ///< of the scene
    ivec2 pixel;
    int light = 0;
    Probe probe;
    dvec3 eyeWay, pointWorld; ///< computed here
    std::size_t seen = 0;     ///< triangle that the eye sees, of all
    [[nodiscard]] std::string where() const {
        return name + " at " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) + " light " +
               std::to_string(light);
    }
    [[nodiscard]] dvec4 lightWorld() const {
        const scene::Light& source = scene.light(light);
        return source.type == scene::LightType::directional ? dvec4(-source.directionWorld, 0)
                                                            : dvec4(source.positionWorld, 1);
    }
    /// From the point to the light; of a directional light a unit vector.
    [[nodiscard]] dvec3 towardLight() const { return dvec3(lightWorld()) - pointWorld * lightWorld().w; }
    /// The eye's side of the seen triangle.
    [[nodiscard]] dvec3 normal() const {
        const dvec3 normal = glm::normalize(triangles[seen].normal());
        return glm::dot(normal, eyeWay) < 0 ? normal : -normal;
    }
};

/// Does any object of the scene have holes? What lies in a hole is not looked into here.
inline bool hasHoles(const scene::Scene& scene) {
    for (const scene::Object& object : scene.objects)
        if (scene::hasHoles(scene, object)) return true;
    return false;
}

struct AskedSettings {
    std::string technique;
    std::vector<std::pair<std::string, std::string>> values;
    int pixels = 12; ///< of each scene and light
    unsigned seed = 1;
};

/// Does any casting triangle stand between the point and the light?
inline bool isBlocked(const AskedPixel& asked) {
    for (std::size_t i = 0; i < asked.triangles.size(); ++i) {
        if (i == asked.seen || !asked.scene.objects[asked.triangles[i].object].castsShadow) continue;
        const auto hit = meets(asked.triangles[i], asked.pointWorld, asked.towardLight());
        if (hit && hit->inside > 0 && hit->along > 1e-9 && (asked.lightWorld().w == 0 || hit->along < 1)) return true;
    }
    return false;
}

constexpr int kLitKept = 5; ///< of the pixels that nothing stands before, one in so many is asked: most are lit

/// Calls onPixel(AskedPixel) for pixels by chance whose eye ray passes no edge. Returns how many were left out for that.
template <typename OnPixel>
int forRandomPixels(const AskedSettings& settings, const OnPixel& onPixel, bool withHoles = true) {
    const auto root = context::assetsRoot();
    int leftOut = 0;
    for (const std::string& name : scene::builtInScenes(root)) {
        const scene::Snapshot scene = scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}});
        if (!withHoles && hasHoles(*scene)) continue;
        const std::vector<WorldTriangle> triangles = allTriangles(*scene);
        picture::Slot slot = picture::Session::makeSlot(settings.technique);
        for (const auto& [param, value] : settings.values)
            params::setFromText(params::find(slot.params, param, settings.technique), value, settings.technique);
        std::mt19937 random(settings.seed);
        View view;
        view.camera = scene->camera;
        view.size = kPictureSize;
        for (int light = 0; light < static_cast<int>(scene->lights.size()); ++light)
            for (int i = 0; i < settings.pixels; ++i) {
                const ivec2 pixel(static_cast<int>(random() % static_cast<unsigned>(kPictureSize.x)),
                                  static_cast<int>(random() % static_cast<unsigned>(kPictureSize.y)));
                const dvec3 way = eyeWay(scene->camera, dvec2(pixel) + 0.5, kPictureSize);
                const dvec3 forward = glm::normalize(scene->camera.targetWorld - scene->camera.positionWorld);
                const double near = scene->camera.near / glm::dot(way, forward);
                const auto first = firstOn(triangles, scene->camera.positionWorld, way, near,
                                           [](const WorldTriangle&) { return true; });
                if (!first) continue;
                if (!first->isClear || scene::hasHoles(*scene, scene->objects[triangles[first->index].object])) {
                    ++leftOut;
                    continue;
                }
                const AskedPixel place{*scene,      triangles, name, pixel,
                                       light,       {},        way,  scene->camera.positionWorld + first->along * way,
                                       first->index};
                if (!isBlocked(place) && i % kLitKept != 0) continue;
                view.picked = pixel;
                AskedPixel asked = place;
                asked.probe = slot.technique->probe(scene, view, pixel, light);
                onPixel(asked);
            }
    }
    return leftOut;
}

inline const Probe::Fact* factNamed(const Probe& probe, std::string_view label) {
    for (const Probe::Fact& fact : probe.facts)
        if (fact.label == label) return &fact;
    return nullptr;
}

/// What was compared, and how far it was off at most.
struct Deviation {
    int compared = 0;
    double largest = 0;
    void add(double difference) {
        ++compared;
        largest = std::max(largest, std::abs(difference));
    }
};

} // namespace shadowlab::testing
