// Lines and faces in world space, drawn over a picture: lines of a width that is seen from the last row, faces that let
// through what is behind them.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/technique.h"

namespace shadowlab::picture {

/// A segment as it lies in the picture: in pixels from the lower left corner, as GL counts, and in depth -1..1.
struct ScreenSegment {
    vec3 from{0.0f}, to{0.0f};
};

/// The segments (two points each) that lie before the camera's near plane and not wholly beside its picture, cut to a
/// little more than the picture. Computed in double.
std::vector<ScreenSegment> projectSegments(std::span<const dvec3> pointsWorld, const scene::Camera& camera, ivec2 size);

/// The faces (three points each) that lie before the camera's near plane, cut to it, as triangles in pixels from the lower
/// left corner; they may reach beyond the picture.
std::vector<std::array<dvec2, 3>> projectFaces(std::span<const dvec3> pointsWorld, const scene::Camera& camera, ivec2 size);

/// Width of the lines in pixels, in a picture of that height: what look::lineRadius says, and never less than two.
float lineWidth(int height);

class ShapePainter {
public:
    /// Draws into the bound framebuffer of that size, blending over linear display colours. Its depth is that of the
    /// scene, drawn with this very camera (gl::eyeMatrices) and offset a little away from it; it is not written. What the
    /// scene hides shows through faintly. GL state as after setBaselineState(), or with a scissor set.
    /// `onTop`: as if there were no scene.
    void draw(std::span<const SceneShape* const> shapes, const scene::Camera& camera, ivec2 size, bool onTop = false) const;

    /// Lines of that width as they lie in the picture, over everything.
    void drawOnPicture(const std::vector<ScreenSegment>& segments, const vec3& colorLinear, float width, ivec2 size) const;

private:
    struct Lines;
    struct Faces;
    void drawFaces(const std::vector<Faces>& all, const scene::Camera& camera, ivec2 size, float share) const;
    void drawLines(const std::vector<Lines>& all, ivec2 size, bool hidden) const;
    gl::Program line_{"picture/line.vert", "picture/line.frag"};
    gl::Program face_{"position.vert", "constant.frag"};
};

} // namespace shadowlab::picture
