// Drawing the scene's surfaces as the eye sees them: the matrices, the lights-off pass, and one light at a time.
//
// Every technique shades through these functions and the same GLSL (shaders/shade_light.frag), so that the images of
// two techniques differ in their shadows alone. A technique's own part is one GLSL function, shadowVisibility().
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>

#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/scene_buffers.h"
#include "techniques/foundation/scene/picture_part.h"
#include "techniques/foundation/scene/scene.h"

namespace shadowlab::gl {

/// Double, so that what is composed with them loses nothing far from the world's origin; cast to float last.
struct EyeMatrices {
    dmat4 viewFromWorld{1.0}, clipFromView{1.0};
    /// The part of the picture that is drawn. Objects that cannot touch it are left out; none: all are drawn.
    std::optional<scene::PicturePart> part = std::nullopt;
    [[nodiscard]] dmat4 clipFromMesh(const scene::Object& object) const {
        return clipFromView * (viewFromWorld * scene::worldFromMesh(object));
    }
};
EyeMatrices eyeMatrices(const scene::Camera& camera, ivec2 size);

/// Texture unit of the facing signs; a technique's own textures use the units after it.
constexpr int kFacingUnit = 0;
constexpr int kFirstFreeUnit = 1;

/// Called for each object with the program in use, before its parts are drawn; false leaves the object out.
using ObjectSetup = std::function<bool(const scene::Object&)>;

/// Draws all objects that may be seen in their order, setting the uniforms that shaders/surface.vert and shaders/material.glsl name.
/// The program must be in use.
void drawSurfaces(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers,
                  const EyeMatrices& eye, const ObjectSetup& setup = {});

/// Sets the uniforms of shaders/light.glsl and binds the facing signs. Follow with drawSurfaces.
void setLight(const Program& program, const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye,
              int light);

/// Clears colour to the background, depth and stencil, and draws emission + ambient with depth: all lights off.
void drawLightsOff(const Program& lightsOff, const scene::Scene& scene, const SceneBuffers& buffers,
                   const EyeMatrices& eye, const ObjectSetup& setup = {});

/// GL state for adding one light to what drawLightsOff has drawn: depth GL_EQUAL, no depth writes, additive blending,
/// and a stencil that lets each pixel be lit once (of two surfaces at one depth the first drawn is the visible one).
/// Where the stencil is not zero nothing is lit: a shadow volume's count goes there.
void setAddLightState();

/// The same, but writing instead of adding: for a visibility picture.
void setVisibilityState();

} // namespace shadowlab::gl
