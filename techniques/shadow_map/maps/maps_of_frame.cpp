// The maps that a frame needs: fitted to what the eye sees, and drawn where they are not what they should be.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"
#include "techniques/foundation/scene/query/view/visible_receivers.h"
#include "techniques/lights_in_view.h"
#include "techniques/shadow_map/filters/filter_uniforms.h"
#include "techniques/shadow_map/fit/seen_depth.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

namespace {

// Boxes around what is in view: more would make a fit slow, and hardly closer.
constexpr std::size_t kMostReceivers = 64;

} // namespace

std::vector<scene::Bounds> ShadowMap::receiversInView(const scene::Scene& scene, const View& view) const {
    if (params_.projection.fit == ProjectionParams::Fit::scene) return bounds_;
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    return scene::visibleReceivers(scene, bounds_, eye.clipFromView * eye.viewFromWorld, scene::PicturePart{},
                                   kMostReceivers);
}

AskedLight ShadowMap::asked(const scene::Scene& scene, int light) const {
    const auto index = static_cast<std::size_t>(light);
    AskedLight result{scene.lights[index], usefulCasters_[index], params_.filter};
    if (params_.exact) result.filter.kind = FilterParams::Kind::hard; // what is decided is not filtered
    return result;
}

LightMaps ShadowMap::fit(const scene::Scene& scene, const View& view, const AskedLight& asked,
                         std::span<const scene::Bounds> receivers, FitRequest::Cover cover) const {
    // The fit always uses the casters that matter, also when all are drawn: another map would be another picture. Without
    // any there is no map, unless nothing is to be left out.
    std::vector<scene::Bounds> casters;
    for (const std::size_t caster : asked.casters.empty() && !params_.cull ? scene::allCasters(scene) : asked.casters)
        casters.push_back(bounds_[caster]);
    const double aspect = static_cast<double>(view.size.x) / view.size.y;
    FitEye eye{scene::withTightNear(view.camera, scene, bounds_, aspect), aspect, std::nullopt};
    if (seen_ && seen_->camera == view.camera && seen_->size == view.size) eye.visibleDepth = seen_->range;
    ProjectionParams projection = params_.projection;
    if (params_.exact) { // teaching faults have no place there
        projection.depthRange = ProjectionParams::DepthRange::fitted;
        projection.cubeSeams = ProjectionParams::CubeSeams::guarded;
    }
    const FilterParams& filter = asked.filter;
    const bool hasPenumbra = filter.kind == FilterParams::Kind::pcss;
    return fitLightMaps({.light = asked.light,
                         .all = bounds_,
                         .casters = casters,
                         .receivers = receivers,
                         .eye = eye,
                         .params = projection,
                         .resolution = params_.resolution,
                         .guardTexels = filter.kernelRadius(),
                         .lightReach = hasPenumbra ? lightReach(asked.light, filter) : 0.0,
                         .widestShare = filter.widest,
                         .castersInDepth = filter.usesDistances(),
                         .cover = cover});
}

/// Fits the maps of all lights to what the eye sees.
void ShadowMap::lookAt(const Frame& frame) {
    const View& view = frame.view();
    const bool cascades =
        params_.projection.cascades > 1 && params_.projection.depthBounds == ProjectionParams::DepthBounds::picture;
    seen_.reset();
    if (cascades)
        if (const std::optional<dvec2> range = visibleDepthRange(frame)) seen_ = {view.camera, view.size, *range};
    FittedFor now{frame.snapshot(), view.camera, view.size, params_, {}, {}};
    if (seen_) now.visibleDepth = seen_->range;
    const int lights = static_cast<int>(frame.scene().lights.size());
    for (int light = 0; light < lights; ++light)
        now.mayLight.push_back(!params_.cull || mayLight(frame, light));
    if (now == fittedFor_) return;
    const std::vector<scene::Bounds> receivers = receiversInView(frame.scene(), view);
    fitted_.clear();
    askings_.clear();
    for (int light = 0; light < lights; ++light)
        fitted_.push_back(
            now.mayLight[static_cast<std::size_t>(light)]
                ? fit(frame.scene(), view, asked(frame.scene(), light), receivers, FitRequest::Cover::needed)
                : LightMaps{});
    fittedFor_ = std::move(now);
}

std::vector<std::size_t> ShadowMap::castersOf(const scene::Scene& scene, const LightMaps& maps, const AskedLight& asked,
                                              int layer) const {
    if (!params_.cull) return scene::allCasters(scene);
    // Beside the edge of a shadow moments are of the caster and of what it shadows: that has to be in the map, even if
    // it shadows nothing itself.
    std::vector<std::size_t> casters;
    for (const std::size_t caster : asked.filter.usesMoments() ? scene::allCasters(scene) : asked.casters)
        if (mayDrawInto(maps, layer, bounds_[caster])) casters.push_back(caster);
    return casters;
}

/// Draws those of the light's layers that are not what they should be.
DrawnMap ShadowMap::updateMap(Frame& frame, int light) {
    const scene::Scene& scene = frame.scene();
    const LightMaps& maps = fitted_[static_cast<std::size_t>(light)];
    const AskedLight asked = this->asked(scene, light);
    frame.count("lights-with-map", maps.layers() > 0 ? 1 : 0, 1, "lights");
    const double allCasters = static_cast<double>(scene::allCasters(scene).size());
    if (maps.layers() == 0) {
        frame.count("casters", 0, allCasters, "objects");
        return {.maps = maps, .asked = asked};
    }
    const double layerTexels = static_cast<double>(params_.resolution) * params_.resolution;
    double allTexels = 0;
    for (const LightMaps& fitted : fitted_)
        allTexels += layerTexels * fitted.layers();
    const GLenum format = params_.glDepthFormat();
    KeptMap& kept = kept_.of(light, fitted_.size(), allTexels, maps, params_.resolution, format, params_.exact);
    kept.depth.clampToEdge(params_.border == ShadowMapParams::Border::edge);

    std::vector<bool> drawn(scene.objects.size(), false); // in any layer
    for (int layer = 0; layer < maps.layers(); ++layer) {
        const LayerOrigin origin{scene.revisions.geometry,
                                 scene.revisions.transforms,
                                 scene.revisions.materials,
                                 maps.originWorld,
                                 maps.lightClipFromLightRelative(layer),
                                 castersOf(scene, maps, asked, layer),
                                 depthRules(params_, asked.filter),
                                 gl::shaderReloads()};
        std::optional<LayerOrigin>& drawnFrom = kept.drawnFrom[static_cast<std::size_t>(layer)];
        const bool redraw = drawnFrom != origin;
        if (redraw && params_.exact) {
            drawExact(frame, light, maps, layer, origin.casters, kept.depth, *kept.exact);
        } else if (redraw) {
            depthPass_.draw(frame, maps, layer, origin.casters, kept.depth, format, origin.rules);
        }
        if (redraw) kept.momentsAreCurrent = false;
        drawnFrom = origin;
        for (const std::size_t caster : origin.casters)
            drawn[caster] = true;
        frame.count("maps-redrawn", redraw ? 1 : 0, 1, "maps");
        frame.count("caster-draws", static_cast<double>(origin.casters.size()), allCasters, "objects, each per map");
    }
    frame.count("casters", static_cast<double>(std::ranges::count(drawn, true)), allCasters, "objects");
    frame.count("map-texels", layerTexels * maps.layers(), 0, "texels");
    if (!asked.filter.usesMoments()) kept.moments.reset();
    return {.maps = maps,
            .asked = asked,
            .depth = &kept.depth,
            .exact = params_.exact ? &*kept.exact : nullptr,
            .kept = &kept};
}

/// Makes the moments of a light's maps if these, or what is asked of them, changed.
const gl::ColorTextureArray& ShadowMap::updateMoments(Frame& frame, KeptMap& kept, const LightMaps& maps) {
    const FilterParams wanted = momentParams(params_.filter);
    const bool other = !kept.moments || kept.momentsFor != wanted, make = other || !kept.momentsAreCurrent;
    frame.count("moments-made", make ? maps.layers() : 0, maps.layers(), "maps");
    if (!make) return *kept.moments;
    if (other) {
        kept.moments.reset(); // first, so that both are never there at once
        kept.moments = emptyMoments(params_.filter, params_.resolution, maps.layers());
    }
    momentMaker_.make(kept.depth, maps, params_.filter, *kept.moments);
    kept.momentsFor = wanted;
    kept.momentsAreCurrent = true;
    return *kept.moments;
}

} // namespace shadowlab::shadow_map
