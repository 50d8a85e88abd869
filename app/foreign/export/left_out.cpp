// SPDX-License-Identifier: MIT
#include "app/foreign/export/left_out.h"

#include <algorithm>

namespace shadowlab::foreign {

void LeftOut::named(std::vector<std::string> names, const std::string& sentence) {
    constexpr std::size_t kMost = 6; // the rest are counted
    std::vector<std::string> once;
    for (std::string& name : names)
        if (std::ranges::find(once, name) == once.end()) once.push_back(std::move(name));
    if (once.empty()) return;
    std::string all;
    for (std::size_t i = 0; i < std::min(once.size(), kMost); ++i)
        all += (i == 0 ? "" : ", ") + once[i];
    if (once.size() > kMost) all += " and " + std::to_string(once.size() - kMost) + " more";
    sentences_.push_back(all + ": " + sentence);
}

void LeftOut::lights(const std::function<bool(const scene::Light&)>& has, const std::string& sentence) {
    std::vector<std::string> names;
    for (const scene::Light& light : scene_.lights)
        if (has(light)) names.push_back("light \"" + light.name + "\"");
    named(std::move(names), sentence);
}

void LeftOut::materials(const std::function<bool(const PlainMaterial&)>& has, const std::string& sentence) {
    std::vector<bool> isLamp(scene_.materials.size());
    for (const PlainMesh& mesh : scene_.meshes)
        if (mesh.emitterOfLight >= 0) isLamp[mesh.material] = true;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene_.materials.size(); ++i)
        if (!isLamp[i] && has(scene_.materials[i])) names.push_back("material \"" + scene_.materials[i].values.name + "\"");
    named(std::move(names), sentence);
}

void LeftOut::meshes(const std::function<bool(const PlainMesh&)>& has, const std::string& sentence) {
    std::vector<std::string> names;
    for (const PlainMesh& mesh : scene_.meshes)
        if (mesh.emitterOfLight < 0 && has(mesh)) names.push_back("object \"" + mesh.name + "\"");
    named(std::move(names), sentence);
}

void LeftOut::noCastsShadow() {
    meshes([](const PlainMesh& mesh) { return !mesh.castsShadow; }, "casts no shadow in the scene (`castsShadow`: false); here it does");
}

void LeftOut::noReceivesShadow() {
    meshes([](const PlainMesh& mesh) { return !mesh.receivesShadow; },
           "is never shadowed in the scene (`receivesShadow`: false); here it is");
}

void LeftOut::noAmbient() {
    if (scene_.ambient != vec3(0)) add("ambient light, which reaches everything alike: shadows are black");
}

void LeftOut::noBackground() {
    if (scene_.background != vec3(0)) add("the colour of the background");
}

void LeftOut::noExposure() {
    if (scene_.exposure != 1.0f) add("the exposure; colours of the finished picture are to be multiplied by it");
}

void LeftOut::noNear() {
    const auto reaches = [this](const PlainMesh& mesh) {
        return std::ranges::any_of(mesh.positions, [this](const vec3& position) {
            return glm::dot(scene_.eye.position - dvec3(position), scene_.eye.back) < scene_.eye.near &&
                   glm::dot(scene_.eye.position - dvec3(position), scene_.eye.back) > 0;
        });
    };
    meshes(reaches, "has a corner nearer to the eye than the near plane, which cuts in the scene and does not here");
}

void LeftOut::soften(const std::string& sentence) {
    lights([](const scene::Light& light) { return light.type == scene::LightType::spot && light.edgeDegrees > 0; }, sentence);
}

bool isMirror(const PlainMaterial& material) { return material.values.reflectivity > 0; }
bool isGlass(const PlainMaterial& material) { return material.values.transparency > 0; }
bool shines(const PlainMaterial& material) { return material.values.emission != vec3(0); }
bool hasHighlight(const PlainMaterial& material) { return material.values.specular != vec3(0); }
bool isBlurred(const PlainMaterial& material) {
    return (isMirror(material) && material.values.glossDegrees > 0) || (isGlass(material) && material.values.translucencyDegrees > 0);
}

} // namespace shadowlab::foreign
