// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/surfaces.h"

#include <algorithm>

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
    program.set("normalsOnFront", object.mesh->normalsOnFront ? 1 : 0);
    program.set("receivesShadow", object.receivesShadow ? 1 : 0);
}

/// What a program asks of a vertex, but for the number of its triangle.
enum class Reads { attributes, positions };

/// A run of triangles of an object, `triangles`: in the mesh's own order or in another one.
template <typename Triangles>
void drawRun(const Program& program, Reads reads, const SceneBuffers& buffers, std::size_t index, const Triangles& triangles,
             std::uint32_t first, std::uint32_t count) {
    if (!program.reads("triangleBase"))
        return reads == Reads::positions ? triangles.drawPositions(first, count) : triangles.draw(first, count);
    program.set("triangleBase", buffers.triangleBase(index));
    triangles.drawNumbered(first, count);
}

/// The same of the mesh's own order; where backs are culled, by the state, those of a large mesh are not even drawn. `clipFromMesh()` is asked
/// for these meshes alone.
template <typename ClipFromMesh>
void drawSides(const Program& program, Reads reads, const SceneBuffers& buffers, std::size_t index, std::uint32_t first,
               std::uint32_t count, const ClipFromMesh& clipFromMesh) {
    if (buffers.listsFronts(index) && glIsEnabled(GL_CULL_FACE))
        return drawRun(program, reads, buffers, index, buffers.fronts(index, viewerMesh(clipFromMesh())), first, count);
    drawRun(program, reads, buffers, index, buffers.mesh(index), first, count);
}

SeenObject seenObject(const scene::Object& object, const SeenRuns& runs, const scene::Bounds& box, const EyeMatrices& eye) {
    const dvec3 eyeWorld = transformPoint(glm::inverse(eye.viewFromWorld), dvec3(0));
    const double toBox = glm::distance(eyeWorld, glm::clamp(eyeWorld, box.lowerWorld, box.upperWorld));
    const double near = eye.clipFromView[3][2] / (eye.clipFromView[2][2] - 1);
    return {layerStep(runs.gap, std::max(toBox, near), eye.clipFromView), scene::isMirrored(object),
            scene::isBeyondNearPlane(box, eye.clipFromView * eye.viewFromWorld)};
}

/// A part of an object, as the eye sees it where others coincide with it.
void drawSeen(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye, std::size_t index,
              std::size_t part) {
    const scene::MeshPart& run = scene.objects[index].mesh->parts[part];
    const SeenRuns* runs = buffers.seenRuns(index);
    if (!runs)
        return drawSides(program, Reads::attributes, buffers, index, run.firstTriangle, run.triangleCount,
                         [&] { return eye.clipFromMesh(scene.objects[index]); });
    drawInLayers(runs->ofPart[part], seenObject(scene.objects[index], *runs, buffers.bounds()[index], eye),
                 [&](std::uint32_t first, std::uint32_t count) {
                     drawRun(program, Reads::attributes, buffers, index, *runs->triangles, first, count);
                 });
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

void drawPart(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
              std::size_t index, std::size_t partIndex) {
    const scene::Object& object = scene.objects[index];
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
    drawSeen(program, scene, buffers, eye, index, partIndex);
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

/// The program that draws the depth of a part, in use.
const Program& useForDepth(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, std::size_t object,
                           std::size_t part, const dmat4& clipFromMesh) {
    const Texture2D* mask = buffers.mask(object, part);
    const Program& chosen = mask ? useAlphaTested(program, scene, object, part, *mask) : program;
    chosen.use();
    chosen.set("clipFromMesh", mat4(clipFromMesh));
    return chosen;
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
            drawPart(program, scene, buffers, eye, object, part);
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
                drawPart(program, scene, buffers, eye, i, part);
                continue;
            }
            const Program& alphaTested = useAlphaTested(program, scene, i, part, *mask);
            setObject(alphaTested, eye, scene.objects[i]);
            drawPart(alphaTested, scene, buffers, eye, i, part);
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
        return drawSides(program, Reads::positions, buffers, object, 0, static_cast<std::uint32_t>(mesh.triangles.size()),
                         [&] { return clipFromMesh; });
    for (std::size_t part = 0; part < mesh.parts.size(); ++part)
        drawRun(useForDepth(program, scene, buffers, object, part, clipFromMesh), Reads::attributes, buffers, object, buffers.mesh(object),
                mesh.parts[part].firstTriangle, mesh.parts[part].triangleCount);
}

void drawTriangles(const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye, std::size_t object, std::uint32_t first,
                   std::uint32_t count) {
    const auto draw = [&](std::uint32_t from, std::uint32_t many) { buffers.mesh(object).draw(from, many); };
    if (const SeenRuns* runs = buffers.seenRuns(object))
        drawInLayers(*runs, first, count, seenObject(scene.objects[object], *runs, buffers.bounds()[object], eye), draw);
    else
        draw(first, count);
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
            if (!buffers.seenRuns(i)) return drawDepth(positionOnly, scene, buffers, i, clipFromMesh);
            for (std::size_t part = 0; part < scene.objects[i].mesh->parts.size(); ++part)
                drawSeen(useForDepth(positionOnly, scene, buffers, i, part, clipFromMesh), scene, buffers, eye, i, part);
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
