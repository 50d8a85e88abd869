// Puts programs to use: compiled for the lights and the materials of a scene, with their uniforms.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/gl/scene/surfaces.h"

namespace shadowlab::gl {

namespace {

/// Numbers of shaders/light.glsl.
int lightKind(scene::LightType type) {
    switch (type) {
    case scene::LightType::directional: return 1;
    case scene::LightType::spot: return 2;
    case scene::LightType::rect: return 3;
    default: return 0; // a sphere light is shaded as a point at its centre
    }
}

// Defines for what is constant in a pass: the kind of light, what is written, and whether any material has highlights. A software renderer
// evaluates all branches for every pixel, which took a fifth to a third of the frame time.

void defineMaterials(const scene::Scene& scene, const SceneBuffers& buffers, std::vector<std::string>& defines) {
    if (buffers.anyOwnColors()) defines.emplace_back("COLORED");
    const auto hasNoSpecular = [](const scene::Material& material) { return material.specular == vec3(0); };
    if (std::ranges::all_of(scene.materials, hasNoSpecular)) defines.emplace_back("NO_SPECULAR");
}

std::vector<std::string> knownBefore(const scene::Scene& scene, const SceneBuffers& buffers, const scene::Light& light,
                                     ShadedAs shadedAs) {
    std::vector<std::string> defines{"LIGHT_KIND " + std::to_string(lightKind(light.type))};
    if (shadedAs != ShadedAs::radiance) defines.emplace_back("FINISHED");
    if (shadedAs == ShadedAs::finishedAndInShadow) defines.emplace_back("IN_SHADOW_TOO");
    defineMaterials(scene, buffers, defines);
    return defines;
}

std::vector<std::string> knownOfAllLights(const scene::Scene& scene, const SceneBuffers& buffers, bool nothingHidden) {
    std::string kinds;
    for (const scene::Light& light : scene.lights)
        kinds += (kinds.empty() ? "" : ", ") + std::to_string(lightKind(light.type));
    std::vector<std::string> defines{"LIGHTS " + std::to_string(scene.lights.size()), "LIGHT_KINDS " + kinds};
    if (nothingHidden) defines.emplace_back("NOTHING_HIDDEN");
    defineMaterials(scene, buffers, defines);
    return defines;
}

/// A light as shaders/light.glsl reads it.
struct LightView {
    vec3 positionView, directionView, intensity;
    float halfCone, cosHalfCone, edge; ///< radians
};

LightView lightView(const scene::Light& light, const EyeMatrices& eye) {
    const dvec3 directionWorld =
        light.type == scene::LightType::rect ? scene::rectNormalWorld(light) : light.directionWorld;
    const double halfConeRadians = light.coneDegrees * glm::pi<double>() / 360.0;
    return {.positionView = vec3(transformPoint(eye.viewFromWorld, light.positionWorld)),
            .directionView = vec3(transformDirection(eye.viewFromWorld, directionWorld)),
            .intensity = vec3(dvec3(light.color) * scene::pointIntensity(light)),
            .halfCone = static_cast<float>(halfConeRadians),
            .cosHalfCone = static_cast<float>(std::cos(halfConeRadians)),
            .edge = static_cast<float>(light.edgeDegrees * glm::pi<double>() / 180.0)};
}

} // namespace

void useForLight(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
                 int light, ShadedAs shadedAs) {
    const scene::Light& source = scene.light(light);
    // The visibility shader is too short to gain from variants: one program serves all kinds of light.
    program.useWith(program.isMadeWith("VISIBILITY_ONLY") ? std::vector<std::string>{}
                                                          : knownBefore(scene, buffers, source, shadedAs));
    program.set("ambient", scene.ambient); // where lights off and light are one pass
    program.set("exposure", scene.exposure);
    program.set("lightKind", lightKind(source.type)); // where the program was not made for it
    const LightView seen = lightView(source, eye);
    program.set("lightPositionView", seen.positionView);
    program.set("lightDirectionView", seen.directionView);
    program.set("lightIntensity", seen.intensity);
    program.set("lightHalfCone", seen.halfCone);
    program.set("lightCosHalfCone", seen.cosHalfCone);
    program.set("lightEdge", seen.edge);
    buffers.facing(light).bind(kFacingUnit);
    program.set("lightFacing", kFacingUnit);
}

void useForAllLights(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
                     const Texture2D* hiddenLights) {
    program.useWith(knownOfAllLights(scene, buffers, hiddenLights == nullptr));
    program.set("ambient", scene.ambient);
    program.set("exposure", scene.exposure);
    std::vector<vec4> positionsView, directionsView, intensities, cones;
    for (const scene::Light& light : scene.lights) {
        const LightView seen = lightView(light, eye);
        positionsView.emplace_back(seen.positionView, 1);
        directionsView.emplace_back(seen.directionView, 0);
        intensities.emplace_back(seen.intensity, 0);
        cones.emplace_back(seen.halfCone, seen.cosHalfCone, seen.edge, 0);
    }
    program.set("lightPositionsView", positionsView);
    program.set("lightDirectionsView", directionsView);
    program.set("lightIntensities", intensities);
    program.set("lightCones", cones);
    buffers.facingOfAllLights().bind(kFacingUnit);
    program.set("lightsFacing", kFacingUnit);
    if (!hiddenLights) return;
    hiddenLights->bind(kFirstFreeUnit);
    program.set("hiddenLights", kFirstFreeUnit);
}

void useForMaterials(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers) {
    std::vector<std::string> defines;
    defineMaterials(scene, buffers, defines);
    program.useWith(defines);
}

void useLightsOff(const Program& lightsOff, const scene::Scene& scene, const SceneBuffers& buffers, const vec3& ambient) {
    const auto useOne = [&](const Program& program) {
        useForMaterials(program, scene, buffers);
        program.set("ambient", ambient);
    };
    if (buffers.anyHoles()) useOne(lightsOff.alphaTested());
    useOne(lightsOff);
}

} // namespace shadowlab::gl
