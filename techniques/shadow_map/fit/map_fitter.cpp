// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/map_fitter.h"

#include <algorithm>

#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"
#include "techniques/foundation/scene/query/view/visible_receivers.h"
#include "techniques/lights_in_view.h"
#include "techniques/shadow_map/filters/filters.h"

namespace shadowlab::shadow_map {

namespace {

// Boxes around what is in view: with more of them a fit takes longer and is hardly tighter.
constexpr std::size_t kMostReceivers = 64;

/// Metres along the eye's axis to the nearest and the farthest visible point, of a picture whose depths have been drawn;
/// none where there is only background. Read back, which takes about as long as filling the picture once (Lauritzen, Salvi
/// and Lefohn 2011 do it on the graphics card, with compute shaders, which OpenGL 3.3 does not have).
std::optional<dvec2> visibleDepthRange(const Frame& frame) {
    const ivec2 size = frame.target().size();
    std::vector<float> depths(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.target().framebuffer.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    float least = 1, most = 0;
    for (const float depth : depths) {
        if (depth >= 1) continue; // the background
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    if (least > most) return std::nullopt;
    // z_clip = a z + b and w = -z, so ndc = -a - b / z. Depths are rounded to 24 bits: one step to either side.
    const double a = frame.eye().clipFromView[2][2], b = frame.eye().clipFromView[3][2];
    constexpr double kStep = 1.0 / (1 << 24);
    const auto distance = [&](double depth) { return b / ((2 * depth - 1) + a); };
    return dvec2(distance(least - kStep), distance(std::min(most + kStep, 1 - 0.5 * kStep)));
}

} // namespace

void MapFitter::prepare(const scene::Snapshot& snapshot) {
    if (preparedFor_ == snapshot) return;
    bounds_ = scene::objectBounds(*snapshot);
    usefulCasters_.clear();
    for (const scene::Light& light : snapshot->lights)
        usefulCasters_.push_back(scene::usefulCasters(*snapshot, light, bounds_));
    preparedFor_ = snapshot;
    seen_.reset();
}

std::vector<scene::Bounds> MapFitter::receiversInView(const scene::Scene& scene, const View& view) const {
    if (params_.projection.fit == ProjectionParams::Fit::scene) return bounds_;
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    return scene::visibleReceivers(scene, bounds_, eye.clipFromView * eye.viewFromWorld, scene::PicturePart{},
                                   kMostReceivers);
}

MapQuery MapFitter::query(const scene::Scene& scene, int light) const {
    return {scene.light(light), usefulCasters(light), params_.filter};
}

LightMaps MapFitter::fit(const scene::Scene& scene, const View& view, const MapQuery& query,
                         std::span<const scene::Bounds> receivers, FitRequest::Cover cover) const {
    // The fit always uses the casters that matter, also when all are drawn: another map would be another picture. Without
    // any there is no map, unless nothing is to be left out.
    std::vector<scene::Bounds> casters;
    for (const std::size_t caster : query.casters.empty() && !params_.cull ? scene::allCasters(scene) : query.casters)
        casters.push_back(bounds_[caster]);
    const double aspect = static_cast<double>(view.size.x) / view.size.y;
    FitEye eye{scene::withTightNear(view.camera, scene, bounds_, aspect), aspect, std::nullopt};
    if (seen_ && seen_->camera == view.camera && seen_->size == view.size) eye.visibleDepth = seen_->range;
    const FilterParams& filter = query.filter;
    const bool hasPenumbra = filterInfo(filter.kind).searchesBlockers;
    return fitLightMaps({.light = query.light,
                         .all = bounds_,
                         .casters = casters,
                         .receivers = receivers,
                         .eye = eye,
                         .params = params_.projection,
                         .resolution = params_.resolution,
                         .guardTexels = filter.kernelRadius(),
                         .lightReach = hasPenumbra ? lightReach(query.light, filter) : 0.0,
                         .widestShare = filter.widest,
                         .castersInDepth = filter.usesDistances(),
                         .cover = cover});
}

void MapFitter::fitMaps(const Frame& frame) {
    const View& view = frame.view();
    const bool cascades =
        params_.projection.cascades > 1 && params_.projection.depthBounds == ProjectionParams::DepthBounds::picture;
    seen_.reset();
    if (cascades)
        if (const std::optional<dvec2> range = visibleDepthRange(frame)) seen_ = {view.camera, view.size, *range};
    FitCacheKey now{frame.snapshot(), view.camera, view.size, params_, {}, {}};
    if (seen_) now.visibleDepth = seen_->range;
    const int lights = static_cast<int>(frame.scene().lights.size());
    for (int light = 0; light < lights; ++light)
        now.mayLight.push_back(!params_.cull || mayLight(frame, light));
    if (now == fittedFor_) return;
    const std::vector<scene::Bounds> receivers = receiversInView(frame.scene(), view);
    fitted_.clear();
    lookups_.clear();
    for (int light = 0; light < lights; ++light)
        fitted_.push_back(now.mayLight[static_cast<std::size_t>(light)]
                              ? fit(frame.scene(), view, query(frame.scene(), light), receivers)
                              : LightMaps{});
    fittedFor_ = std::move(now);
}

std::vector<std::size_t> MapFitter::castersOf(const scene::Scene& scene, const LightMaps& maps, const MapQuery& query,
                                              int layer) const {
    if (!params_.cull) return scene::allCasters(scene);
    // Beside the edge of a shadow moments are of the caster and of what it shadows: that has to be in the map, even if
    // it shadows nothing itself.
    std::vector<std::size_t> casters;
    for (const std::size_t caster : query.filter.usesMoments() ? scene::allCasters(scene) : query.casters)
        if (mayDrawInto(maps, layer, bounds_[caster])) casters.push_back(caster);
    return casters;
}

const std::vector<ReceiverLookup>& MapFitter::lookups(const Frame& frame, int light, const LightMaps& maps) {
    // The fitted maps may be looked up again in the next frame; those of single points of a light are looked up once.
    const bool isFitted = maps == fitted(light);
    std::vector<ReceiverLookup>& found = isFitted ? lookups_[light] : otherLookups_;
    if (isFitted && !found.empty()) return found;
    found.clear();
    const dmat4 clipFromWorld = frame.eye().clipFromView * frame.eye().viewFromWorld;
    for (const scene::Bounds& box : bounds_)
        found.push_back(receiverLookup(maps, box, clipFromWorld));
    return found;
}

} // namespace shadowlab::shadow_map
