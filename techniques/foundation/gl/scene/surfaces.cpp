// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/surfaces.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/normal_transform.h"

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

/// What shaders/surface.vert and shaders/lights_off.frag ask of an object.
void setObject(const Program& program, const EyeMatrices& eye, const scene::Object& object) {
    const dmat4 viewFromMesh = eye.viewFromWorld * scene::worldFromMesh(object);
    program.set("clipFromMesh", mat4(eye.clipFromView * viewFromMesh));
    program.set("viewFromMesh", mat4(viewFromMesh));
    program.set("normalViewFromMesh", mat3(glm::transpose(glm::inverse(dmat3(viewFromMesh)))));
    program.set("stretchesNormals", scene::stretchesNormals(dmat3(object.worldFromObject)) ? 1 : 0);
    program.set("mirrored", scene::isMirrored(object) ? 1 : 0);
    program.set("receivesShadow", object.receivesShadow ? 1 : 0);
}

void drawRun(const Program& program, const SceneBuffers& buffers, std::size_t index, std::uint32_t first,
             std::uint32_t count) {
    if (!program.reads("triangleBase")) return buffers.mesh(index).draw(first, count);
    program.set("triangleBase", buffers.triangleBase(index));
    buffers.mesh(index).drawNumbered(first, count);
}

vec4 placed(const scene::ImagePlacement& placement) { return vec4(dvec4(placement.scale, placement.offset)); }

void setColorMap(const Program& program, const scene::Material& material, const Texture2D& image) {
    const auto wrap = static_cast<GLint>(material.colorPlacement.clamped ? GL_CLAMP_TO_EDGE : GL_REPEAT);
    image.bind(kColorMapUnit);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, axis, wrap);
    program.set("colorMap", kColorMapUnit);
    program.set("colorPlacement", placed(material.colorPlacement));
}

// An emitter in a face is drawn nearer by so many units of the depth buffer, four times what the rounding of two planes in float makes.
constexpr float kContactUnits = 16;

/// And by this share of the depth's slope per pixel: the rasteriser moves corners to a grid within pixels, those of the emitter and of
/// the face by up to half of its step each. Four steps are eight times half a step.
float contactSlope() {
    GLint subpixelBits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subpixelBits);
    return 4.0f / static_cast<float>(1 << subpixelBits);
}

/// A part of an object, `draw()`: an emitter that lies in a face is drawn before it where it shines toward the eye, else behind it
/// (scene/query/emitter_contacts.h).
template <typename Draw>
void drawInContact(const scene::Scene& scene, const SceneBuffers& buffers, std::size_t index, std::size_t part,
                   const Draw& draw) {
    if (!buffers.contacts().isEmitterInFace(index, part)) return draw();
    const scene::Object& object = scene.objects[index];
    const scene::Material& material = scene.materials[object.partMaterials[part]];
    const bool culls = glIsEnabled(GL_CULL_FACE);
    const bool mirrored = scene::isMirrored(object); // what the rasteriser calls its front is then its back
    glEnable(GL_POLYGON_OFFSET_FILL);
    for (const bool isFront : {true, false}) {
        if (culls && !isFront) continue; // drawn objects whose back is culled
        // By rank: a lamp twice as near as another emitter, and one that is dark here farther.
        const int rank = scene::rankInContact(object, material, isFront);
        const auto nearer = static_cast<float>(1 - rank);
        glEnable(GL_CULL_FACE);
        glCullFace(isFront != mirrored ? GL_BACK : GL_FRONT);
        glPolygonOffset(nearer * contactSlope(), nearer * kContactUnits);
        draw();
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (!culls) glDisable(GL_CULL_FACE);
}

void drawPart(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, std::size_t index,
              std::size_t partIndex) {
    const scene::Object& object = scene.objects[index];
    const scene::MeshPart& part = object.mesh->parts[partIndex];
    const scene::Material& material = scene.materials[object.partMaterials[partIndex]];
    program.set("diffuse", material.diffuse);
    program.set("specular", material.specular);
    program.set("shininess", material.shininess);
    program.set("emission", material.emission);
    if (program.reads("colorMap")) {
        setColorMap(program, material, buffers.colorImage(index, partIndex));
        program.set("usesVertexColors", scene::usesVertexColors(scene, object, partIndex) ? 1 : 0);
    }
    const bool mirrored = scene::isMirrored(object); // what the rasteriser calls its front is then its back
    program.set("emittingSides",
                (scene::shinesFrom(material, !mirrored) ? 1 : 0) + (scene::shinesFrom(material, mirrored) ? 2 : 0));
    if (program.reads("frontInShadow")) {
        const vec3 reflected = scene.ambient * material.diffuse;
        const auto sideInShadow = [&](bool isFront) {
            return finished(scene::shinesFrom(material, isFront) ? material.emission + reflected : reflected,
                            scene.exposure);
        };
        program.set("frontInShadow", sideInShadow(!mirrored));
        program.set("backInShadow", sideInShadow(mirrored));
    }
    drawInContact(scene, buffers, index, partIndex,
                  [&] { drawRun(program, buffers, index, part.firstTriangle, part.triangleCount); });
}

/// The variant of a program that cuts holes, in use, with this mask of a part.
const Program& useAlphaTested(const Program& program, const scene::Scene& scene, std::size_t object, std::size_t part,
                              const Texture2D& mask) {
    const Program& alphaTested = program.alphaTested();
    alphaTested.use();
    setAlphaMask(alphaTested, scene.materials[scene.objects[object].partMaterials[part]], mask);
    return alphaTested;
}

/// `drawObject()` if the object may be seen.
template <typename DrawObject>
void drawIfSeen(const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye, std::size_t index,
                const ObjectSetup& setup, const DrawObject& drawObject) {
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
    const scene::Object& object = scene.objects[index];
    if (eye.part && !scene::mayTouch(buffers.bounds()[index], clipFromWorld, *eye.part)) return;
    if (setup && !setup(object)) return;
    // Back faces that front faces hide are culled: half of the triangles of most objects. Not for objects with holes,
    // through which they can be seen.
    if (object.mesh->outward && !buffers.hasHoles(index) &&
        scene::isBeyondNearPlane(buffers.bounds()[index], clipFromWorld)) {
        glEnable(GL_CULL_FACE);
        glCullFace(scene::isMirrored(object) ? GL_FRONT : GL_BACK);
    }
    drawObject();
    glDisable(GL_CULL_FACE);
}

void drawPartDepth(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, std::size_t object,
                   std::size_t part, const dmat4& clipFromMesh) {
    const Texture2D* mask = buffers.mask(object, part);
    const Program& chosen = mask ? useAlphaTested(program, scene, object, part, *mask) : program;
    chosen.use();
    chosen.set("clipFromMesh", mat4(clipFromMesh));
    const scene::MeshPart& run = scene.objects[object].mesh->parts[part];
    drawRun(chosen, buffers, object, run.firstTriangle, run.triangleCount);
}

} // namespace

EyeMatrices eyeMatrices(const scene::Camera& camera, ivec2 size) {
    return {scene::viewFromWorld(camera), scene::clipFromView(camera, static_cast<double>(size.x) / size.y),
            std::nullopt};
}

void drawSurfaces(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers,
                  const EyeMatrices& eye, const ObjectSetup& setup) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        drawSurface(program, scene, buffers, eye, i, setup);
}

void drawSurface(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
                 std::size_t object, const ObjectSetup& setup) {
    drawIfSeen(scene, buffers, eye, object, setup, [&] {
        setObject(program, eye, scene.objects[object]);
        for (std::size_t part = 0; part < scene.objects[object].mesh->parts.size(); ++part)
            drawPart(program, scene, buffers, object, part);
    });
}

void drawSurfacesWithHoles(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers,
                           const EyeMatrices& eye, const ObjectSetup& setup) {
    // Object by object and part by part, as drawSurfaces does: of two surfaces at one depth the first drawn is the visible
    // one, in every pass.
    const auto drawObject = [&](std::size_t i) {
        setObject(program, eye, scene.objects[i]);
        for (std::size_t part = 0; part < scene.objects[i].mesh->parts.size(); ++part) {
            const Texture2D* mask = buffers.mask(i, part);
            if (!mask) {
                drawPart(program, scene, buffers, i, part);
                continue;
            }
            const Program& alphaTested = useAlphaTested(program, scene, i, part, *mask);
            setObject(alphaTested, eye, scene.objects[i]);
            drawPart(alphaTested, scene, buffers, i, part);
            program.use();
        }
    };
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        drawIfSeen(scene, buffers, eye, i, setup, [&] { drawObject(i); });
}

void drawDepth(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, std::size_t object,
               const dmat4& clipFromMesh) {
    const scene::Mesh& mesh = *scene.objects[object].mesh;
    program.use();
    program.set("clipFromMesh", mat4(clipFromMesh));
    if (!buffers.hasHoles(object))
        return drawRun(program, buffers, object, 0, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (std::size_t part = 0; part < mesh.parts.size(); ++part)
        drawPartDepth(program, scene, buffers, object, part, clipFromMesh);
}

vec3 finished(const vec3& radiance, float exposure) {
    const image::Color8 color = image::encoded(exposure * radiance);
    return vec3(color.r, color.g, color.b) / 255.0f;
}

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

void setAlphaMask(const Program& alphaTested, const scene::Material& material, const Texture2D& mask) {
    mask.bind(kAlphaMaskUnit);
    alphaTested.set("alphaMask", kAlphaMaskUnit);
    alphaTested.set("alphaPlacement", placed(material.alphaPlacement));
    alphaTested.set("alphaClamped", material.alphaPlacement.clamped ? 1 : 0);
}

void useLightsOff(const Program& lightsOff, const scene::Scene& scene, const SceneBuffers& buffers, const vec3& ambient) {
    const auto useOne = [&](const Program& program) {
        useForMaterials(program, scene, buffers);
        program.set("ambient", ambient);
    };
    if (buffers.anyHoles()) useOne(lightsOff.alphaTested());
    useOne(lightsOff);
}

void drawLightsOff(const Program& lightsOff, const scene::Scene& scene, const SceneBuffers& buffers,
                   const EyeMatrices& eye, const ObjectSetup& setup) {
    glClearColor(scene.background.r, scene.background.g, scene.background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    useLightsOff(lightsOff, scene, buffers, scene.ambient);
    drawSurfacesWithHoles(lightsOff, scene, buffers, eye, setup);
}

void drawSurfaceDepth(const Program& positionOnly, const scene::Scene& scene, const SceneBuffers& buffers,
                      const EyeMatrices& eye) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        drawIfSeen(scene, buffers, eye, i, {}, [&] {
            const dmat4 clipFromMesh = eye.clipFromMesh(scene.objects[i]);
            if (!buffers.contacts().hasEmitterInFace(i))
                return drawDepth(positionOnly, scene, buffers, i, clipFromMesh);
            for (std::size_t part = 0; part < scene.objects[i].mesh->parts.size(); ++part)
                drawInContact(scene, buffers, i, part,
                              [&] { drawPartDepth(positionOnly, scene, buffers, i, part, clipFromMesh); });
        });
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
