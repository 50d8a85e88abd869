// Soft shadows by brute force: many maps, each from another point of the light, and the mean of their answers.
// Heckbert and Herf, "Simulating Soft Shadows with Graphics Hardware", CMU-CS-97-104, 1997, with maps instead of projections.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/light_points.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

bool ShadowMap::averagesOver(const scene::Light& light) const {
    return params_.lightPoints.count > 1 && scene::hasArea(light) && !params_.exact && !params_.aliasFree;
}

bool ShadowMap::samplesArea(const scene::Scene& scene, int light) const {
    const scene::Light& source = scene.light(light);
    // exact and alias-free know the light's centre alone, whatever the filter.
    const bool isFiltered = !params_.exact && !params_.aliasFree;
    const bool hasPenumbra = isFiltered && params_.filter.kind == FilterParams::Kind::pcss && scene::hasArea(source);
    return hasPenumbra || averagesOver(source);
}

DrawnMap ShadowMap::drawAnew(const Frame& frame, const AskedLight& asked, const LightMaps& maps, OwnMap& own) {
    if (maps.layers() == 0) return {.maps = maps, .asked = asked};
    const GLenum format = params_.glDepthFormat();
    if (own.depth.side() != params_.resolution || own.depth.layers() != maps.layers() || own.format != format) {
        own.depth = gl::DepthTextureArray(format, params_.resolution, maps.layers(), "shadow map of one point");
        own.format = format;
    }
    own.depth.clampToEdge(params_.border == ShadowMapParams::Border::edge);
    for (int layer = 0; layer < maps.layers(); ++layer) {
        gl::setBaselineState();
        depthPass_.draw(frame, maps, layer, castersOf(frame.scene(), maps, asked, layer), own.depth, format,
                        depthRules(params_, asked.filter));
    }
    if (asked.filter.usesMoments()) {
        own.moments = emptyMoments(asked.filter, params_.resolution, maps.layers());
        momentMaker_.make(own.depth, maps, asked.filter, *own.moments);
    }
    return {.maps = maps,
            .asked = asked,
            .depth = &own.depth,
            .moments = asked.filter.usesMoments() ? &*own.moments : nullptr};
}

const gl::Texture2D& ShadowMap::averageOverLight(Frame& frame, int light) {
    const scene::Scene& scene = frame.scene();
    const scene::Light& whole = scene.light(light);
    const ivec2 size = frame.target().size();
    averaged_ = gl::Texture2D(GL_R32F, size, "visibility, averaged over the light");
    const gl::Framebuffer framebuffer(&averaged_, &frame.target().depthStencil, "visibility, averaged over the light");
    framebuffer.bind();
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    const float share = 1.0f / static_cast<float>(params_.lightPoints.count);
    const std::vector<scene::Bounds> receivers = receiversInView(scene, frame.view());
    OwnMap own;
    // [anchor: average-maps]
    for (const dvec3& pointWorld : scene::pointsOfLight(whole, light, params_.lightPoints)) {
        AskedLight asked = this->asked(scene, light);
        asked.light.type = scene::LightType::point;
        asked.light.positionWorld = pointWorld;
        asked.casters = scene::usefulCasters(scene, asked.light, bounds_);
        const LightMaps maps = fit(scene, frame.view(), asked, receivers, FitRequest::Cover::needed);
        const DrawnMap map = drawAnew(frame, asked, maps, own);
        frame.count("maps-redrawn", maps.layers(), maps.layers(), "maps");
        gl::setBaselineState();
        framebuffer.bind();
        frame.scissorTo(std::nullopt);
        glClear(GL_STENCIL_BUFFER_BIT);
        gl::setVisibilityState();
        glEnable(GL_BLEND);
        glBlendColor(share, share, share, share);
        glBlendFunc(GL_CONSTANT_COLOR, GL_ONE);
        drawAsked(frame, lightProgram(map, true), unshadowedVisibility_, light, map);
    }
    return averaged_;
}

} // namespace shadowlab::shadow_map
