// The first and the last pass of every technique that draws with the rasteriser: the scene with its lights off, and a light.
//
// There are two roads to the same picture. Where stages, steps or supersampling are wanted, both passes draw radiance
// in floats: lights off, then each light added. That is how the lecture tells it. Where a picture to look at is all that
// is wanted (Frame::drawFinished), pixels are drawn as they are shown, and no surface is shaded twice; on two processor cores that
// takes about half as long. Both roads give the same picture, up to one level of 255: floats of 16 bits round a sum that the other
// road encodes unrounded.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/frame.h"

namespace shadowlab {

/// For a technique whose fragment shader decides what is in shadow.
class ShadingPasses {
public:
    /// Who needs depths between the two passes, or has a shader for which hidden surfaces are dear, draws them `first`.
    enum class Depths { first, withLight };

    /// Of the pass "lights-off". Finished pixels: only clears, and draws depths if they are wanted first.
    void lightsOff(const Frame& frame, Depths depths);
    /// State of the pass "light", and what the light's program has to write; follow with gl::useForLight and drawing all surfaces.
    gl::ShadedAs beginLight(const Frame& frame) const;

private:
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program depths_{"position.vert", "nothing.frag"};
    Depths drawn_ = Depths::first;
};

/// For a technique that decides with the stencil, after the surfaces are drawn. Finished pixels of one light are drawn twice, lit and
/// in shadow, and chosen from in the end; where all surfaces have one colour in shadow, they are drawn lit, and that colour over them. Of
/// several lights those that are hidden are noted one by one, and then all are shaded at once.
class StencilledPasses {
public:
    /// Of the pass "lights-off". Finished pixels: draws each surface lit by the one light, and as it is where that is hidden; or, of
    /// several lights, depths alone.
    void lightsOff(Frame& frame);
    /// Of the pass "light", for finished pixels: the light is hidden where the stencil, masked, is not zero; and nowhere outside of
    /// `part`, if that is given.
    void hide(Frame& frame, int light, const std::optional<scene::PicturePart>& part, GLuint stencilMask) const;
    /// After the last light, whose pass "light" it goes on with, for finished pixels of several lights: shades with all that are not
    /// hidden.
    void shadeFinished(Frame& frame, const PassInfo& light) const;
    /// The program that adds a light to radiance.
    [[nodiscard]] const gl::Program& light() const { return light_; }

private:
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program light_{"surface.vert", "shade_light.frag"};
    gl::Program inShadow_{"fullscreen.vert", "in_shadow.frag"};
    gl::Program color_{"fullscreen.vert", "constant.frag"};
    gl::Program depths_{"position.vert", "nothing.frag"};
    gl::Program hide_{"fullscreen.vert", "hide_light.frag"};
    gl::Program allLights_{"surface.vert", "shade_lights.frag"};
    std::optional<vec3> onlyLightsOff_; ///< radiance of all surfaces without the one light, where it is the same
};

} // namespace shadowlab
