// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/surface_picture.h"

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/scene/surfaces.h"

namespace shadowlab::radiosity {

namespace {

/// A shader may not read from an empty buffer: one unused texel stands in.
template <typename Texel>
std::vector<Texel> atLeastOne(std::vector<Texel> texels) {
    if (texels.empty()) texels.emplace_back(0);
    return texels;
}

} // namespace

void SurfacePicture::setCells(const SurfaceCells& cells) {
    places_ = gl::TableTexture(atLeastOne(cells.places), "radiosity: places of triangles");
    roots_ = gl::TableTexture(atLeastOne(cells.roots), "radiosity: roots of triangles");
    lines_ = gl::TableTexture(atLeastOne(cells.lines), "radiosity: lines between patches");
    branches_ = gl::TableTexture(atLeastOne(cells.branches), "radiosity: branches of trees");
    table_ = gl::TableTexture(atLeastOne(cells.cells), "radiosity: cells");
    borders_ = gl::TableTexture(atLeastOne(cells.borders), "radiosity: borders of cells");
}

SurfacePicture::Values SurfacePicture::upload(const CellValues& values) {
    return {gl::TableTexture(atLeastOne(values.ofPatches), "radiosity: values of patches"),
            gl::TableTexture(atLeastOne(values.ofBorders), "radiosity: values of borders")};
}

SurfacePicture::Lattices SurfacePicture::upload(const std::vector<vec4>& lattices, const std::vector<vec4>& atPoints) {
    return {gl::TableTexture(atLeastOne(lattices), "radiosity: lattices"),
            gl::TableTexture(atLeastOne(atPoints), "radiosity: light map")};
}

void SurfacePicture::draw(const Frame& frame, const gl::Program& program, const Values& values, bool interpolates,
                          const std::function<void()>& setUniforms) const {
    gl::useForMaterials(program, frame.scene(), frame.buffers());
    if (setUniforms) setUniforms(); // first, because uploads may replace bound textures
    int unit = gl::kFirstFreeUnit;
    const auto bind = [&](const gl::TableTexture& texture, std::string_view name) {
        texture.bind(unit);
        program.set(name, unit++);
    };
    bind(places_, "cellPlaces");
    bind(roots_, "cellRoots");
    bind(lines_, "cellLines");
    bind(branches_, "cellBranches");
    bind(table_, "cellTable");
    bind(borders_, "cellBorders");
    bind(values.ofPatches, "patchValues");
    bind(values.ofBorders, "borderValues");
    program.set("interpolates", interpolates ? 1 : 0);
    glClear(GL_STENCIL_BUFFER_BIT);
    gl::setVisibilityState();
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye());
}

void SurfacePicture::drawRadiosity(const Frame& frame, const Values& radiosity, bool interpolates,
                                   double exposureFactor) const {
    draw(frame, radiosity_, radiosity, interpolates,
         [&] { radiosity_.set("exposureFactor", static_cast<float>(exposureFactor)); });
}

void SurfacePicture::bind(const Lattices& map, const gl::Program& program) {
    constexpr int kFirst = gl::kFirstFreeUnit + 8; // after the units that draw() uses
    map.table.bind(kFirst);
    map.values.bind(kFirst + 1);
    program.set("lattices", kFirst);
    program.set("latticeValues", kFirst + 1);
}

void SurfacePicture::drawReflected(const Frame& frame, const Values& irradiance, const Lattices* map,
                                   double exposureFactor) const {
    const gl::Program& program = map ? reflectedWithMap_ : reflected_;
    draw(frame, program, irradiance, true, [&] {
        program.set("exposureFactor", static_cast<float>(exposureFactor));
        if (map) bind(*map, program);
    });
}

void SurfacePicture::drawScalar(const Frame& frame, const Values& values, bool interpolates) const {
    draw(frame, scalar_, values, interpolates);
}

void SurfacePicture::drawVisibility(const Frame& frame, const Values& values, bool interpolates, int light) const {
    draw(frame, visibility_, values, interpolates,
         [&] { gl::useForLight(visibility_, frame.scene(), frame.buffers(), frame.eye(), light); });
}

void SurfacePicture::drawVisibility(const Frame& frame, const Values& values, const Lattices& map, int light) const {
    draw(frame, visibilityMap_, values, true, [&] {
        gl::useForLight(visibilityMap_, frame.scene(), frame.buffers(), frame.eye(), light);
        bind(map, visibilityMap_);
    });
}

void SurfacePicture::drawOutlines(const Frame& frame, const Values& values, const vec3& lineColor) const {
    draw(frame, outlines_, values, false, [&] {
        outlines_.set("lineColor", lineColor);
        outlines_.set("lineWidthPx", static_cast<float>(look::lineRadius(frame.view().size.y)));
    });
}

} // namespace shadowlab::radiosity
