// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/surfaces.h"

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/normal_transform.h"

namespace shadowlab::gl {

namespace {

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

void setAlphaMask(const Program& alphaTested, const scene::Material& material, const Texture2D& mask) {
    mask.bind(kAlphaMaskUnit);
    alphaTested.set("alphaMask", kAlphaMaskUnit);
    alphaTested.set("alphaPlacement", placed(material.alphaPlacement));
    alphaTested.set("alphaClamped", material.alphaPlacement.clamped ? 1 : 0);
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
