// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_lights.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

double inDegrees(double radians) { return radians * 180.0 / glm::pi<double>(); }

/// Unit vector of a node's axis in the world; zero where its transform has none.
dvec3 axisOf(const GltfNode& node, const dvec3& axis) {
    const dvec3 turned = dmat3(node.worldFromNode) * axis;
    const double length = glm::length(turned);
    return length > 0 && std::isfinite(length) ? turned / length : dvec3(0.0);
}

/// The index of the light that a node carries; -1: none.
int lightOf(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_lights_punctual");
    return found == node.extensions.end() ? -1 : static_cast<int>(gltfNumber(found->second, "light", -1));
}

void setCone(const GltfSource& source, std::size_t index, const tinygltf::SpotLight& spot, Light& light) {
    const double inner = spot.innerConeAngle, outer = spot.outerConeAngle;
    if (!(outer > 0 && outer <= glm::half_pi<double>() + 1e-6 && inner >= 0 && inner < outer))
        source.fail("lights", index,
                    "is a spot light whose cone is from " + numberText(inner) + " to " + numberText(outer) +
                        " radians; it must be 0 <= innerConeAngle < outerConeAngle <= pi/2");
    // The whole apex angle, which must stay below a straight one; and the band within it where the light fades.
    light.coneDegrees = std::min(2.0 * inDegrees(outer), 179.99);
    light.edgeDegrees = std::min(inDegrees(outer - inner), 0.5 * light.coneDegrees);
}

} // namespace

std::vector<Light> gltfLights(GltfSource& source, const tinygltf::Model& model, const std::vector<GltfNode>& nodes) {
    std::vector<Light> lights;
    for (const GltfNode& node : nodes) {
        const int index = lightOf(model.nodes[node.index]);
        if (index < 0) continue;
        const auto at = static_cast<std::size_t>(index);
        const tinygltf::Light& given = model.lights[at];
        Light light;
        light.name = node.name;
        light.type = given.type == "spot" ? LightType::spot : given.type == "directional" ? LightType::directional : LightType::point;
        light.positionWorld = dvec3(node.worldFromNode[3]);
        light.directionWorld = axisOf(node, {0, 0, -1});
        if (given.color.size() == 3) light.color = vec3(dvec3(given.color[0], given.color[1], given.color[2]));
        light.intensity = given.intensity;
        if (!(glm::length(light.positionWorld) <= Limits{}.coordinate))
            source.fail("nodes", node.index,
                        "has a light beyond " + numberText(Limits{}.coordinate) + " m from the origin; bring it nearer");
        if (light.type == LightType::spot) setCone(source, at, given.spot, light);
        if (light.type != LightType::point && light.directionWorld == dvec3(0.0)) {
            source.note("nodes", node.index, "its light has no direction, because its scale is 0; it is left out");
            continue;
        }
        if (light.type == LightType::point) light.directionWorld = Light{}.directionWorld;
        lights.push_back(std::move(light));
    }
    return lights;
}

std::vector<Viewpoint> gltfCameras(GltfSource& source, const tinygltf::Model& model, const std::vector<GltfNode>& nodes,
                                   const Bounds& bounds) {
    std::vector<Viewpoint> viewpoints;
    for (const GltfNode& node : nodes) {
        const int index = model.nodes[node.index].camera;
        if (index < 0) continue;
        const auto at = static_cast<std::size_t>(index);
        const tinygltf::Camera& given = model.cameras[at];
        if (given.type != "perspective") {
            source.note("cameras", at, "orthographic cameras are left out; there are only perspective ones");
            continue;
        }
        const tinygltf::PerspectiveCamera& lens = given.perspective;
        if (!(lens.yfov > 0 && lens.yfov < glm::pi<double>()))
            source.fail("cameras", at, "has a yfov of " + numberText(lens.yfov) + " radians; it must be above 0 and below pi");
        if (!(lens.znear > 0) || !(lens.zfar == 0 || lens.zfar > lens.znear))
            source.fail("cameras", at,
                        "sees from znear " + numberText(lens.znear) + " to zfar " + numberText(lens.zfar) +
                            "; znear must be above 0, and zfar beyond it");
        if (lens.znear > Limits{}.coordinate || !(glm::length(dvec3(node.worldFromNode[3])) <= Limits{}.coordinate))
            source.fail("nodes", node.index,
                        "has a camera that stands, or sees from, beyond " + numberText(Limits{}.coordinate) +
                            " m from the origin; bring it nearer");
        Viewpoint viewpoint{node.name, {}};
        Camera& camera = viewpoint.camera;
        camera.positionWorld = dvec3(node.worldFromNode[3]);
        const dvec3 forwardWorld = axisOf(node, {0, 0, -1});
        camera.upWorld = axisOf(node, {0, 1, 0});
        const dvec3 middle = bounds.isEmpty() ? camera.positionWorld : 0.5 * (bounds.lowerWorld + bounds.upperWorld);
        const double depth = glm::dot(middle - camera.positionWorld, forwardWorld);
        camera.targetWorld = camera.positionWorld + (depth > lens.znear ? depth : std::max(1.0, 2 * lens.znear)) * forwardWorld;
        camera.fovYDegrees = inDegrees(lens.yfov);
        camera.near = lens.znear;
        if (lens.zfar > 0) camera.far = lens.zfar;
        if (!hasView(camera)) {
            source.note("nodes", node.index, "its camera has no direction, because its transform flattens it; it is left out");
            continue;
        }
        viewpoints.push_back(std::move(viewpoint));
    }
    return viewpoints;
}

} // namespace shadowlab::scene
