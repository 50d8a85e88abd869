// Drawing the scene's surfaces as the eye sees them: the matrices, the lights-off pass, and one light at a time.
//
// Every technique shades through these functions and the same GLSL (shaders/shade_light.frag), so that the images of
// two techniques differ in their shadows alone. A technique's own part is one GLSL function, shadowVisibility().
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>

#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/scene/scene_buffers.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/view/picture_part.h"

namespace shadowlab::gl {

/// Double, so that what is composed with them loses nothing far from the world's origin; cast to float last.
struct EyeMatrices {
    dmat4 viewFromWorld{1.0}, clipFromView{1.0};
    /// The part of the picture that is drawn; objects outside of it are culled. None: nothing is culled.
    std::optional<scene::PicturePart> part = std::nullopt;
    [[nodiscard]] dmat4 clipFromMesh(const scene::Object& object) const {
        return clipFromView * (viewFromWorld * scene::worldFromMesh(object));
    }
};
EyeMatrices eyeMatrices(const scene::Camera& camera, ivec2 size);

/// Texture units of the facing signs, of alpha masks and of colour images; a technique's own textures use the units after them.
constexpr int kFacingUnit = 0;
constexpr int kAlphaMaskUnit = 1;
constexpr int kColorMapUnit = 2;
constexpr int kFirstFreeUnit = 3;

/// Called for each object with the program in use, before its parts are drawn; false leaves the object out.
using ObjectSetup = std::function<bool(const scene::Object&)>;

/// Draws all objects that may be seen in their order, setting the uniforms that shaders/surface.vert and
/// shaders/material.glsl name. The program must be in use. Ignores holes: for passes with depth test EQUAL, where nothing
/// is drawn in a hole because the depth buffer has other depths there.
void drawSurfaces(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers,
                  const EyeMatrices& eye, const ObjectSetup& setup = {});

/// The same for one object, for a technique that draws them in different ways.
void drawSurface(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
                 std::size_t object, const ObjectSetup& setup = {});

/// The same for passes that write depth, with holes cut out. Parts with holes are drawn by program.alphaTested(), so the
/// fragment shader has to include shaders/cut_holes.glsl, and uniforms of the pass have to be set for both programs.
void drawSurfacesWithHoles(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers,
                           const EyeMatrices& eye, const ObjectSetup& setup = {});

/// Draws one object, its holes left out, as a camera of any kind sees it (a light's, for a shadow map): for a program that
/// needs clipFromMesh alone, of "position.vert" and "nothing.frag". Puts the program to use.
void drawDepth(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, std::size_t object,
               const dmat4& clipFromMesh);

/// Draws a run of triangles of an object, as the mesh counts them, with the depths that the passes above give them: for a technique
/// that has set up a program of its own, and compares depths.
void drawTriangles(const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye, std::size_t object, std::uint32_t first,
                   std::uint32_t count);

/// What shaders/shade_light.frag writes.
enum class ShadedAs {
    radiance,            ///< to be added to the target
    finished,            ///< the pixel as it is shown, lights-off radiance included
    finishedAndInShadow, ///< the same, and in a second output the pixel as it is shown where the light is hidden
};

/// A radiance as a finished picture shows it: shaders/picture/encode.frag on the processor.
vec3 finished(const vec3& radiance, float exposure);

/// Puts the program to use, as it is made for lights of this kind and the materials of this scene, sets the uniforms of
/// shaders/light.glsl and binds the facing signs. Set other uniforms after it, and follow with drawSurfaces.
void useForLight(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
                 int light, ShadedAs shadedAs = ShadedAs::radiance);

/// The same for "shade_lights.frag", which shades with all lights of the scene at once, kMostLightsAtOnce at most. `hiddenLights`: a
/// picture with a bit for each light (shaders/hide_light.frag); null: no light is hidden anywhere.
void useForAllLights(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
                     const Texture2D* hiddenLights);

/// Puts a program to use that reads shaders/material.glsl but no light, as it is made for the materials of this scene.
void useForMaterials(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers);

/// The same for "lights_off.frag", and for its variant that cuts holes, with this ambient light.
void useLightsOff(const Program& lightsOff, const scene::Scene& scene, const SceneBuffers& buffers, const vec3& ambient);

/// Chooses, for surfaces with holes, what cuts them: the program has to be in use.
void setAlphaMask(const Program& alphaTested, const scene::Material& material, const Texture2D& mask);

/// Clears colour to the background, depth and stencil, and draws emission + ambient with depth: all lights off.
void drawLightsOff(const Program& lightsOff, const scene::Scene& scene, const SceneBuffers& buffers,
                   const EyeMatrices& eye, const ObjectSetup& setup = {});

/// Draws the depth of all surfaces, their holes left out, and nothing else. Clears nothing.
void drawSurfaceDepth(const Program& positionOnly, const scene::Scene& scene, const SceneBuffers& buffers,
                      const EyeMatrices& eye);

/// GL state for adding one light to what drawLightsOff has drawn: depth GL_EQUAL, no depth writes, additive blending,
/// and a stencil that lets each pixel be lit once (of two surfaces at one depth the first drawn is the visible one).
/// Where the stencil is not zero nothing is lit: a shadow volume's count goes there.
void setAddLightState();

/// The same, but writing instead of adding: for a visibility picture.
void setVisibilityState();

} // namespace shadowlab::gl
