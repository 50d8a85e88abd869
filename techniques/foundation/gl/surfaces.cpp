// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/surfaces.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::gl {

namespace {

/// Numbers of shaders/light.glsl.
int lightKind(scene::LightType type) {
    switch (type) {
    case scene::LightType::directional: return 1;
    case scene::LightType::spot: return 2;
    case scene::LightType::rect: return 3;
    default: return 0; // a sphere shines like a point at its centre
    }
}

void drawParts(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, std::size_t index) {
    const scene::Object& object = scene.objects[index];
    for (std::size_t p = 0; p < object.mesh->parts.size(); ++p) {
        const scene::MeshPart& part = object.mesh->parts[p];
        const scene::Material& material = scene.materials[object.partMaterials[p]];
        program.set("diffuse", material.diffuse);
        program.set("specular", material.specular);
        program.set("shininess", material.shininess);
        program.set("emission", material.emission);
        program.set("triangleBase", buffers.triangleBase(index) + static_cast<int>(part.firstTriangle));
        buffers.mesh(index).draw(part.firstTriangle, part.triangleCount);
    }
}

} // namespace

EyeMatrices eyeMatrices(const scene::Camera& camera, ivec2 size) {
    return {scene::viewFromWorld(camera), scene::clipFromView(camera, static_cast<double>(size.x) / size.y),
            std::nullopt};
}

void drawSurfaces(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers,
                  const EyeMatrices& eye, const ObjectSetup& setup) {
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        if (eye.part && !scene::mayTouch(buffers.bounds()[i], clipFromWorld, *eye.part)) continue;
        if (setup && !setup(object)) continue;
        const dmat4 viewFromMesh = eye.viewFromWorld * scene::worldFromMesh(object);
        const bool rectSurface =
            object.emitterOfLight >= 0 &&
            scene.lights[static_cast<std::size_t>(object.emitterOfLight)].type == scene::LightType::rect;
        program.set("clipFromMesh", mat4(eye.clipFromView * viewFromMesh));
        program.set("viewFromMesh", mat4(viewFromMesh));
        program.set("normalViewFromMesh", mat3(glm::transpose(glm::inverse(dmat3(viewFromMesh)))));
        program.set("mirrored", scene::isMirrored(object) ? 1 : 0);
        program.set("receivesShadow", object.receivesShadow ? 1 : 0);
        program.set("emitsFromFrontOnly", rectSurface ? 1 : 0);
        // Back faces that front faces hide are left out: half of the triangles of most objects.
        if (object.mesh->outward && scene::isBeyondNearPlane(buffers.bounds()[i], clipFromWorld)) {
            glEnable(GL_CULL_FACE);
            glCullFace(scene::isMirrored(object) ? GL_FRONT : GL_BACK);
        }
        drawParts(program, scene, buffers, i);
        glDisable(GL_CULL_FACE);
    }
}

void setLight(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
              int light) {
    const scene::Light& source = scene.lights[static_cast<std::size_t>(light)];
    const dvec3 directionWorld =
        source.type == scene::LightType::rect ? scene::rectNormalWorld(source) : source.directionWorld;
    const double halfConeRadians = source.coneDegrees * glm::pi<double>() / 360.0;
    program.set("lightKind", lightKind(source.type));
    program.set("lightPositionView", vec3(transformPoint(eye.viewFromWorld, source.positionWorld)));
    program.set("lightDirectionView", vec3(transformDirection(eye.viewFromWorld, directionWorld)));
    program.set("lightIntensity", vec3(dvec3(source.color) * scene::pointIntensity(source)));
    program.set("lightHalfCone", static_cast<float>(halfConeRadians));
    program.set("lightCosHalfCone", static_cast<float>(std::cos(halfConeRadians)));
    program.set("lightEdge", static_cast<float>(source.edgeDegrees * glm::pi<double>() / 180.0));
    buffers.facing(light).bind(kFacingUnit);
    program.set("lightFacing", kFacingUnit);
}

void drawLightsOff(const Program& lightsOff, const scene::Scene& scene, const SceneBuffers& buffers,
                   const EyeMatrices& eye, const ObjectSetup& setup) {
    glClearColor(scene.background.r, scene.background.g, scene.background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    lightsOff.use();
    lightsOff.set("ambient", scene.ambient);
    drawSurfaces(lightsOff, scene, buffers, eye, setup);
}

void setAddLightState() {
    setVisibilityState();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
}

void setVisibilityState() {
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
}

} // namespace shadowlab::gl
