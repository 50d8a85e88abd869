// SPDX-License-Identifier: MIT
#include "techniques/lecture/parts/patch_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/base/look.h"

namespace shadowlab::lecture {

namespace {

/// What shaders/lecture/patch.frag asks of each triangle: the weights b and c of its corners as functions of a place in view space;
/// number of its first patch, and m. Composed in double, so that the world's origin may be far away.
std::vector<vec4> divisionTable(const RayScene& rays, const DividedSurfaces& surfaces, const dmat4& viewFromWorld) {
    std::vector<vec4> table;
    table.reserve(3 * rays.triangles().size());
    for (const Triangle& t : rays.triangles()) {
        const dvec3 aView = transformPoint(viewFromWorld, t.aWorld);
        const dvec3 abView = transformPoint(viewFromWorld, t.bWorld) - aView;
        const dvec3 acView = transformPoint(viewFromWorld, t.cWorld) - aView;
        const dvec3 normalView = glm::cross(abView, acView);
        const double squared =
            std::max(glm::dot(normalView, normalView), 1e-300); // no patch is seen of one without area
        const dvec3 ofB = glm::cross(acView, normalView) / squared, ofC = glm::cross(normalView, abView) / squared;
        table.emplace_back(ofB, -glm::dot(ofB, aView));
        table.emplace_back(ofC, -glm::dot(ofC, aView));
        const Division& division = surfaces.divisions[t.number];
        table.emplace_back(static_cast<float>(division.first), static_cast<float>(division.m), 0, 0);
    }
    return table;
}

} // namespace

void PatchPicture::begin(const Frame& frame, const RayScene& rays, const DividedSurfaces& surfaces) {
    const vec3& background = frame.scene().background;
    glClearColor(background.r, background.g, background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    constexpr vec3 kNoAmbient(0.0f); // it stands for what is computed here
    gl::useLightsOff(lightsOff_, frame.scene(), frame.buffers(), kNoAmbient);
    gl::drawSurfacesWithHoles(lightsOff_, frame.scene(), frame.buffers(), frame.eye());
    divisions_ = gl::TableTexture(divisionTable(rays, surfaces, frame.eye().viewFromWorld), "lecture: divisions");
    sides_ = 2 * surfaces.patches.size();
}

void PatchPicture::draw(const Frame& frame, const gl::Program& program, std::span<const dvec3> values) const {
    std::vector<vec4> texels;
    for (const dvec3& value : values)
        texels.emplace_back(value, 1);
    const gl::TableTexture ofSides(texels, "lecture: values of patches");
    divisions_.bind(gl::kFirstFreeUnit);
    program.set("divisions", gl::kFirstFreeUnit);
    ofSides.bind(gl::kFirstFreeUnit + 1);
    program.set("values", gl::kFirstFreeUnit + 1);
    glClear(GL_STENCIL_BUFFER_BIT);
    gl::setVisibilityState();
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye());
}

void PatchPicture::drawRadiosity(const Frame& frame, std::span<const dvec3> B) const {
    drawValues(frame, B, glm::one_over_pi<float>(), true);
}

void PatchPicture::drawValues(const Frame& frame, std::span<const dvec3> values, float factor, bool showsLights) const {
    values_.use();
    values_.set("factor", factor);
    values_.set("showsLights", showsLights ? 1 : 0);
    draw(frame, values_, values);
}

void PatchPicture::publishPatches(Frame& frame) const {
    if (!frame.wants("patches")) return;
    std::vector<dvec3> colors; // steps of the golden ratio, so that neighbours by number are far apart in the palette
    for (std::size_t i = 0; i < sides_; ++i)
        colors.emplace_back(look::colorAt(look::viridis(), std::fmod(static_cast<double>(i / 2) * 0.618034, 1.0)));
    const Display display{.unit = "", .key = {{look::colorAt(look::viridis(), 0.5), "one colour: one patch"}}};
    frame.drawStage(
        "patches", kNoLight, GL_RGBA16F, [&] { drawValues(frame, colors, 1, false); }, display);
}

void PatchPicture::publishNumbers(Frame& frame, std::string_view stage, std::span<const dvec3> numbers, double least,
                                  std::string unit) const {
    if (!frame.wants(stage)) return;
    double most = least;
    for (const dvec3& number : numbers)
        most = std::max(most, number.x);
    const Display display{.minimum = 0, .maximum = most, .unit = std::move(unit), .key = {}};
    frame.drawStage(
        stage, kNoLight, GL_RG32F, [&] { drawValues(frame, numbers, 1, false); }, display);
}

void PatchPicture::publishVisibility(Frame& frame, int light, std::span<const dvec3> seen) const {
    if (!frame.wants("visibility", light)) return;
    frame.drawStage("visibility", light, GL_RG32F, [&] {
        gl::useForLight(visibility_, frame.scene(), frame.buffers(), frame.eye(), light);
        draw(frame, visibility_, seen);
    });
}

} // namespace shadowlab::lecture
