// Lines in the scene drawn over a picture that rays have made, on the processor: it has no depth buffer, but knows how far
// away each pixel's surface is.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

class LinePicture {
public:
    /// Linear display colours, and how far each pixel's surface lies along the camera's axis (infinity: there is none). Rows
    /// from the top.
    LinePicture(std::vector<vec3> colors, std::vector<double> depths, const scene::Camera& camera, ivec2 size);

    /// A line of `radius` pixels to each side of its middle. What lies behind a surface shows through faintly.
    void draw(const dvec3& fromWorld, const dvec3& toWorld, const vec3& color, int radius);

    [[nodiscard]] const std::vector<vec3>& colors() const { return colors_; }

private:
    void stamp(dvec2 pixel, double depth, const vec3& color, int radius);
    std::vector<vec3> colors_;
    std::vector<double> depths_;
    std::vector<std::uint32_t> drawnBy_; ///< the line that a pixel was last mixed with: each mixes once
    std::uint32_t line_ = 0;
    dmat4 viewFromWorld_;
    double near_, perHeight_; ///< perHeight_: pixels per unit of height at depth one
    ivec2 size_;
};

} // namespace shadowlab::ray_tracing
