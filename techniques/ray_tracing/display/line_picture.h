// Draws lines of the scene over a traced picture, on the processor. There is no depth buffer, but the depth of each pixel's
// surface is known.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

class LinePicture {
public:
    /// Linear display colours, and the depth of each pixel's surface along the camera's axis (infinity: none). Rows from the top.
    LinePicture(std::vector<vec3> colors, std::vector<double> depths, const scene::Camera& camera, ivec2 size);

    /// Draws a line that extends `radius` pixels to each side of its middle. Behind surfaces it is drawn faintly.
    void draw(const dvec3& fromWorld, const dvec3& toWorld, const vec3& color, int radius);

    [[nodiscard]] const std::vector<vec3>& colors() const { return colors_; }

private:
    void stamp(dvec2 pixel, double depth, const vec3& color, int radius);
    std::vector<vec3> colors_;
    std::vector<double> depths_;
    std::vector<std::uint32_t> drawnBy_; ///< the last line drawn on each pixel: a line is mixed in once
    std::uint32_t line_ = 0;
    dmat4 viewFromWorld_;
    double near_, perHeight_; ///< perHeight_: pixels per unit of height at depth one
    ivec2 size_;
};

} // namespace shadowlab::ray_tracing
