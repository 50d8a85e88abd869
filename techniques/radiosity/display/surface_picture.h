// Drawing what patches are worth: the scene's own triangles, each pixel with the value of the patch that it shows.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/texture.h"
#include "techniques/frame.h"
#include "techniques/radiosity/display/surface_cells.h"

namespace shadowlab::radiosity {

class SurfacePicture {
public:
    /// Uploads where patches are. Values given before are of no use any more.
    void setCells(const SurfaceCells& cells);

    /// Values on the graphics card.
    struct Values {
        gl::TableTexture ofPatches, ofBorders;
    };
    static Values upload(const CellValues& values);
    /// A light map there (light_map.h).
    struct Lattices {
        gl::TableTexture table, values;
    };
    static Lattices upload(const std::vector<vec4>& lattices, const std::vector<vec4>& atPoints);

    // Into what is bound, on the surfaces that the depth buffer has. Each clears the stencil.

    /// What the eye receives, linear RGB, by the radiosity of each patch; what is no patch shows its emission.
    void drawRadiosity(const Frame& frame, const Values& radiosity, bool interpolates, double exposureFactor) const;
    /// The same by the irradiance, interpolated, and reflected by each pixel's own material. `map`: what else arrives, or nullptr.
    void drawReflected(const Frame& frame, const Values& irradiance, const Lattices* map, double exposureFactor) const;
    /// Red: the value's red; green: 1 where there is a patch.
    void drawScalar(const Frame& frame, const Values& values, bool interpolates) const;
    /// Red: the value's red where the side that is seen faces the light; green: 1 where there is a surface.
    void drawVisibility(const Frame& frame, const Values& values, bool interpolates, int light) const;
    void drawVisibility(const Frame& frame, const Values& values, const Lattices& map, int light) const;
    /// The values' colours, and every patch's border.
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
