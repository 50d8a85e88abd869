// The scene with its lights off, and with one light on where the stencil is zero: the first and the last step of every algorithm
// that marks shadows in the stencil buffer. How the marks come about is the algorithm's own.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"

namespace shadowlab::lecture {

class LitScene {
public:
    void lightsOff(const Frame& frame) const;
    /// Adds what the light gives to every visible point whose stencil is zero, and to what receives no shadows.
    void lightOn(const Frame& frame, int light) const;

    /// The stage "visibility". `mark` does in a cleared stencil what the algorithm does.
    void publishVisibility(Frame& frame, int light, const std::function<void()>& mark) const;
    /// A stage of the values that `mark` leaves in a cleared stencil, from -8 to 8.
    void publishStencil(Frame& frame, std::string_view stage, int light, const std::function<void()>& mark) const;

private:
    void drawWhere(const Frame& frame, GLenum comparison, int value, const vec4& color) const;
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program lightOn_{"surface.vert", "shade_light.frag"};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    gl::Program color_{"surface.vert", "constant.frag"};
};

/// Draws triangles, or lines, of homogeneous points in mesh space: for vertex shaders that take these at location 0.
void drawPoints(GLenum kind, const std::vector<vec4>& homogeneousMesh);

/// GL state for half-transparent faces over a finished picture: those on a surface are seen, those behind it are not.
void setTransparentState();

} // namespace shadowlab::lecture
