// What each pixel finds out for itself, drawn: direct light, and what it has gathered of the light that patches send.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/texture.h"
#include "techniques/frame.h"
#include "techniques/radiosity/display/pixel_gather.h"
#include "techniques/radiosity/lights/pixel_light.h"

namespace shadowlab::radiosity {

class PixelPicture {
public:
    /// Finds the direct light. True when it is complete.
    bool advanceDirect(const scene::Snapshot& snapshot, const View& view, Deadline deadline);
    /// Gathers, once direct light is complete. True when each pixel has sent so many rays.
    bool advanceGather(const PixelGather::Solution& solution, std::size_t samples, Deadline deadline);
    /// How many rays each pixel has sent; with none there is nothing to show.
    [[nodiscard]] std::size_t gathered() const { return gather_.samples(); }

    // All draw into the bound framebuffer, on the surfaces in its depth buffer, and clear the stencil.

    /// Adds the radiance toward the eye that a light's direct light is reflected as.
    void addDirect(const Frame& frame, int light, double exposureFactor) const;
    /// The same of what was gathered.
    void addGathered(const Frame& frame, double exposureFactor) const;
    /// Red: the share of the light that is seen; green: 1 where there is a surface.
    void drawVisibility(const Frame& frame, int light) const;

private:
    void useForLight(const Frame& frame, const gl::Program& program, int light) const;

    PixelLight direct_;
    PixelGather gather_;
    std::uint64_t version_ = 0; ///< of the direct light on the graphics card
    std::vector<gl::Texture2D> shares_;
    gl::Texture2D irradiance_;
    gl::Program reflected_{"surface.vert", "radiosity/pixel_light.frag"};
    gl::Program gathered_{"surface.vert", "radiosity/gathered.frag"};
    gl::Program visibility_{"surface.vert", "radiosity/pixel_light.frag", {"VISIBILITY_ONLY"}};
};

} // namespace shadowlab::radiosity
