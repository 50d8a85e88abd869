// A number for each side of each patch, shown on the surfaces of the scene: for radiosity.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/lecture/parts/patches.h"

namespace shadowlab::lecture {

/// Values are of sides: of the front of patch p it is the one at 2 p, of its back the one at 2 p + 1.
class PatchPicture {
public:
    /// Clears the picture, and draws the depths of the surfaces and their own light: first of all.
    void begin(const Frame& frame, const RayScene& rays, const DividedSurfaces& surfaces);
    /// A Lambertian reflector of radiosity B has the intensity B / pi in all directions.
    void drawRadiosity(const Frame& frame, std::span<const dvec3> B) const;

    // Stages, where they are wanted. A number is given as (number, 1, 0); the scale goes up to the largest of them, at least to `least`.
    void publishPatches(Frame& frame) const;
    void publishNumbers(Frame& frame, std::string_view stage, std::span<const dvec3> numbers, double least,
                        std::string unit) const;
    void publishVisibility(Frame& frame, int light, std::span<const dvec3> seen) const;

private:
    void draw(const Frame& frame, const gl::Program& program, std::span<const dvec3> values) const;
    void drawValues(const Frame& frame, std::span<const dvec3> values, float factor, bool showsLights) const;
    gl::TableTexture divisions_;
    std::size_t sides_ = 0;
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program values_{"surface.vert", "lecture/patch.frag"};
    gl::Program visibility_{"surface.vert", "lecture/patch.frag", {"VISIBILITY"}};
};

} // namespace shadowlab::lecture
