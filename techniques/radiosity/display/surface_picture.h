// Draws values of patches: the scene's own triangles, each pixel with the value of the patch that it shows.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/texture.h"
#include "techniques/frame.h"
#include "techniques/radiosity/display/surface_cells.h"

namespace shadowlab::radiosity {

class SurfacePicture {
public:
    /// Uploads the cells. Values uploaded before are no longer valid.
    void setCells(const SurfaceCells& cells);

    /// Values of cells on the graphics card.
    struct Values {
        gl::TableTexture ofPatches, ofBorders;
    };
    static Values upload(const CellValues& values);
    /// A light map on the graphics card (light_map.h).
    struct Lattices {
        gl::TableTexture table, values;
    };
    static Lattices upload(const std::vector<vec4>& lattices, const std::vector<vec4>& atPoints);

    // All draw into the bound framebuffer, on the surfaces in its depth buffer, and clear the stencil.

    /// The radiance toward the eye, linear RGB, by the radiosity of each patch; what belongs to no patch shows its emission.
    void drawRadiosity(const Frame& frame, const Values& radiosity, bool interpolates, double exposureFactor) const;
    /// The same by the irradiance, interpolated, and reflected by each pixel's own material. `map`: further irradiance, or
    /// nullptr.
    void drawReflected(const Frame& frame, const Values& irradiance, const Lattices* map, double exposureFactor) const;
    /// Red: the value's red; green: 1 where there is a patch.
    void drawScalar(const Frame& frame, const Values& values, bool interpolates) const;
    /// Red: the value's red where the visible side faces the light; green: 1 where there is a surface.
    void drawVisibility(const Frame& frame, const Values& values, bool interpolates, int light) const;
    void drawVisibility(const Frame& frame, const Values& values, const Lattices& map, int light) const;
    /// The values' colours, with the border of every patch.
    void drawOutlines(const Frame& frame, const Values& values, const vec3& lineColor) const;

private:
    static void bind(const Lattices& map, const gl::Program& program);
    void draw(const Frame& frame, const gl::Program& program, const Values& values, bool interpolates,
              const std::function<void()>& setUniforms = {}) const;

    gl::TableTexture places_, roots_, lines_, branches_, table_, borders_;
    gl::Program radiosity_{"radiosity/surface.vert", "radiosity/values.frag", {"RADIOSITY"}};
    gl::Program reflected_{"radiosity/surface.vert", "radiosity/values.frag", {"IRRADIANCE"}};
    gl::Program reflectedWithMap_{"radiosity/surface.vert", "radiosity/values.frag", {"IRRADIANCE", "LIGHT_MAP"}};
    gl::Program scalar_{"radiosity/surface.vert", "radiosity/values.frag"};
    gl::Program visibility_{"radiosity/surface.vert", "radiosity/values.frag", {"VISIBILITY"}};
    gl::Program visibilityMap_{"radiosity/surface.vert", "radiosity/values.frag", {"VISIBILITY", "LIGHT_MAP"}};
    gl::Program outlines_{"radiosity/surface.vert", "radiosity/outlines.frag"};
};

} // namespace shadowlab::radiosity
