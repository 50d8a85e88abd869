// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/stages/stages.h"

#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/maps/sheet.h"
#include "techniques/shadow_map/stages/projected.h"

namespace shadowlab::shadow_map {

namespace {

// Modes of shaders/shadow_map/penumbra.frag.
constexpr int kBlockerDistance = 0, kPenumbraWidth = 1;

/// What all but a fiftieth of the values stay below: single ones, at edges, may be very large.
double usualMaximum(const gl::Texture2D& texture) {
    std::vector<float> values;
    for (const vec4& texel : gl::readTexels(texture))
        if (texel.g > 0.5f) values.push_back(texel.r);
    if (values.empty()) return 1;
    std::ranges::sort(values);
    return std::max(1e-6, static_cast<double>(values[values.size() - 1 - values.size() / 50]));
}

} // namespace

void FilterStages::publish(Frame& frame, int light, const LightShadowMap& map) {
    if (frame.wants("moments", light)) publishMoments(frame, light, map);
    if (frame.wants("blocker-search", light)) publishPenumbra(frame, light, map, "blocker-search", kBlockerDistance);
    if (frame.wants("penumbra-width", light)) publishPenumbra(frame, light, map, "penumbra-width", kPenumbraWidth);
}

// Of the mean and the mean square: as filter=vsm has them, with the same blur.
void FilterStages::publishMoments(Frame& frame, int light, const LightShadowMap& map) {
    MapQuery query = map.query;
    query.filter.kind = filterNamed("vsm");
    const LightMaps maps = tools_.fitter.fitToView(frame.scene(), frame.view(), query);
    shown_.keep(light, maps, frame.view());
    MapDrawer::OwnMap own;
    const LightShadowMap drawn = tools_.drawer.drawAnew(frame, query, maps, own);
    const Sheet sheet(maps, frame.view().size);
    gl::Texture2D picture(GL_RG32F, sheet.size(), "moments");
    const gl::Framebuffer framebuffer(&picture, nullptr, "moments");
    gl::setBaselineState();
    glDisable(GL_DEPTH_TEST);
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    for (int layer = 0; layer < maps.layers(); ++layer) {
        sheet.setViewport(layer);
        showMoments_.use();
        drawn.moments->bind(kMomentsUnit);
        showMoments_.set("moments", kMomentsUnit);
        showMoments_.set("layer", layer);
        showMoments_.set("cellSize", sheet.cellSize);
        showMoments_.set("depthRange", momentDepthRange(maps));
        gl::drawFullscreenTriangle();
    }
    Display display{
        .minimum = 0, .maximum = usualMaximum(picture), .unit = "m: standard deviation of depth", .key = {}};
    if (maps.layout == Layout::cube) display.unit += "; above +x +y +z, below -x -y -z";
    if (maps.layout == Layout::cascades) display.unit += "; cascades, the nearest first";
    frame.publish("moments", light, std::move(picture), display);
}

// As filter=pcss finds it, whatever filter is chosen.
gl::Texture2D FilterStages::drawPenumbra(const Frame& frame, int light, const LightShadowMap& map, int mode) {
    gl::Texture2D texture(GL_RG32F, frame.target().size(), "penumbra");
    MapQuery query = map.query;
    query.filter.kind = filterNamed("pcss");
    MapDrawer::OwnMap own;
    const LightMaps maps = tools_.fitter.fitToView(frame.scene(), frame.view(), query);
    const LightShadowMap drawn = tools_.drawer.drawAnew(frame, query, maps, own);
    const gl::Framebuffer framebuffer(&texture, &frame.target().depthStencil, "penumbra");
    gl::setBaselineState();
    framebuffer.bind();
    frame.scissorTo(std::nullopt);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!drawn.depth || !(lightReach(query.light, query.filter) > 0)) return texture;
    drawn.depth->sample(gl::DepthSampling::depths);
    glDepthFunc(GL_EQUAL);
    const gl::Program& program = tools_.receivers.programsFor(drawn).penumbra;
    tools_.receivers.draw(frame, program, light, drawn,
                          {.once = [&](const gl::Program&) { program.set("mode", mode); }});
    return texture;
}

void FilterStages::publishPenumbra(Frame& frame, int light, const LightShadowMap& map, std::string_view stage,
                                   int mode) {
    gl::Texture2D texture = drawPenumbra(frame, light, map, mode);
    const char* unit = mode == kBlockerDistance ? "m before the point, on average" : "m: width of the penumbra";
    Display display{.minimum = 0, .maximum = usualMaximum(texture), .unit = unit, .key = {}};
    frame.publish(stage, light, std::move(texture), display);
}

std::optional<FilterStages::KernelShape> FilterStages::kernelShape(const Frame& frame, int light,
                                                                   const LightShadowMap& map, ivec2 pixel) {
    const auto at = [&](const std::vector<vec4>& texels) {
        return texels[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(frame.view().size.x) +
                      static_cast<std::size_t>(pixel.x)];
    };
    const vec4 seen = at(projectedTexels(tools_, frame, light, map, Projected::position));
    if (seen.a < 0.5f || !map.depth) return std::nullopt;
    const dvec3 point(seen);
    const double eyeDepth = -transformPoint(frame.eye().viewFromWorld, map.maps.originWorld + point).z;
    KernelShape kernel;
    kernel.layer = layerOf(map.maps, point, eyeDepth).value_or(0);
    const auto uvOf = [&](const dvec3& lightRelative) {
        const dvec4 clip = map.maps.lightClipFromLightRelative(kernel.layer) * dvec4(lightRelative, 1.0);
        return dvec2(clip) / clip.w * 0.5 + 0.5;
    };
    const dvec2 uv = uvOf(point);
    const FilterParams& filter = map.query.filter;
    const double texel = 1.0 / tools_.params.resolution;
    const auto square = [&](const dvec2& middle, double halfTexels) {
        return KernelShape{kernel.layer, middle, {halfTexels * texel, 0}, {0, halfTexels * texel}, false};
    };
    const dvec2 nearest = (glm::floor(uv / texel) + 0.5) * texel;
    const FilterInfo& info = filterInfo(filter.kind);
    const double radius = info.radiusTexels(filter);
    switch (info.kernel) {
    case KernelForm::texels: return square(nearest, radius + 0.5);
    case KernelForm::fourTexels: return square((glm::floor(uv / texel - 0.5) + 1.0) * texel, 1);
    case KernelForm::square: return square(uv, radius);
    case KernelForm::disc: {
        KernelShape disc = square(uv, radius);
        disc.isRound = true;
        return disc;
    }
    case KernelForm::penumbra: break;
    }
    const vec4 width = at(gl::readTexels(drawPenumbra(frame, light, map, kPenumbraWidth)));
    if (width.g < 0.5f) return std::nullopt;
    const scene::Light& source = map.query.light;
    kernel.isRound = source.type != scene::LightType::rect;
    const dvec3 toward = map.maps.parallel ? map.maps.towardLight : -glm::normalize(point);
    const dvec3 aside = glm::normalize(glm::cross(toward, std::abs(toward.x) < 0.8 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const double half = 0.5 * width.r;
    const double longerEdge = std::max(glm::length(source.edgeUWorld), glm::length(source.edgeVWorld));
    const dvec3 halfU = kernel.isRound ? half * aside : half / longerEdge * source.edgeUWorld;
    const dvec3 halfV = kernel.isRound ? half * glm::cross(toward, aside) : half / longerEdge * source.edgeVWorld;
    kernel.middleUv = uv;
    kernel.halfU = uvOf(point + halfU) - uv;
    kernel.halfV = uvOf(point + halfV) - uv;
    return kernel;
}

void FilterStages::publishKernel(Frame& frame, int light, const LightShadowMap& map) {
    const ivec2 size = frame.view().size;
    const ivec2 pixel = glm::min(ivec2(tools_.params.kernelAt * dvec2(size)), size - 1);
    std::optional<KernelShape> kernel = kernelShape(frame, light, map, pixel);
    if (kernel)
        kernel->plane = vec3(projectedTexels(tools_, frame, light, map,
                                             Projected::plane)[static_cast<std::size_t>(pixel.y * size.x + pixel.x)]);
    const vec3 white(1.0f);
    Display display;
    display.key = {{look::kEqualDepth, "asked: nothing is nearer than the pixel's surface"},
                   {look::kOccluded, "asked: something is nearer"},
                   {white, "the pixel"}};
    if (!kernel)
        display.key = {{look::kNotAsked, "no kernel: no map is asked there, or nothing blocks the light (pcss)"}};
    frame.drawOverTarget(
        "kernel", light, true,
        [&] {
            if (!kernel) return;
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setVisibilityState();
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            map.depth->sample(gl::DepthSampling::depths);
            const gl::Program& program = tools_.receivers.programsFor(map).kernel;
            const glm::dmat2 kernelFromUv = glm::inverse(glm::dmat2(kernel->halfU, kernel->halfV));
            const auto setUniforms = [&](const gl::Program&) {
                program.set("kernelLayer", kernel->layer);
                program.set("kernelUv", vec2(kernel->middleUv));
                program.set("kernelX", vec2(kernelFromUv[0][0], kernelFromUv[1][0]));
                program.set("kernelY", vec2(kernelFromUv[0][1], kernelFromUv[1][1]));
                program.set("kernelPlane", kernel->plane);
                program.set("kernelIsRound", kernel->isRound ? 1 : 0);
                program.set("kernelPixel", vec2(pixel.x, size.y - 1 - pixel.y) + 0.5f); // GL counts rows from below
                program.set("litColor", look::kEqualDepth);
                program.set("occludedColor", look::kOccluded);
                program.set("pixelColor", white);
            };
            tools_.receivers.draw(frame, program, light, map, {.once = setUniforms});
        },
        display);
}

} // namespace shadowlab::shadow_map
