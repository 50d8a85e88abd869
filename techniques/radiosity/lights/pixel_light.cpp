// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/pixel_light.h"

#include <algorithm>

#include "techniques/foundation/trace/blocks.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

constexpr int kBlockSide = trace::SceneTracer::kBlock;
constexpr std::size_t kBlockPixels = static_cast<std::size_t>(kBlockSide) * kBlockSide;

// Blocks that ask for a light together, on a side: neighbours share the search for what stands before a light with an area.
constexpr int kTileBlocks = 2;
constexpr int kTileSide = kTileBlocks * kBlockSide;

} // namespace

void PixelLight::restart(const scene::Snapshot& snapshot, const trace::SeenFrom& seenFrom) {
    seenFrom_ = seenFrom;
    normals_.emplace(tracer_);
    seenBlocks_ = 0;
    // Rows of blocks at the border may be smaller, but each block has room for a whole one.
    points_.resize(trace::Blocks{seenFrom.size, kBlockSide}.count() * kBlockPixels);
    lights_.clear();
    lights_.resize(snapshot->lights.size());
}

bool PixelLight::advance(const scene::Snapshot& snapshot, const View& view, Deadline deadline) {
    return advancePreview(snapshot, view, deadline) && advanceLights(false, deadline);
}

bool PixelLight::advancePreview(const scene::Snapshot& snapshot, const View& view, Deadline deadline) {
    hasPreview_ = false;
    if (!tracer_.advance(snapshot, deadline)) return false;
    if (const trace::SeenFrom seenFrom(*snapshot, view.camera, view.size); !normals_ || seenFrom != seenFrom_) restart(snapshot, seenFrom);
    lights_.resize(snapshot->lights.size());
    if (snapshot != snapshot_)
        for (OfLight& ofLight : lights_)
            ofLight.area.reset(); // it refers to the scene that it was made for
    snapshot_ = snapshot;

    const trace::Blocks blocks{seenFrom_.size, kBlockSide};
    const trace::EyeRays rays = tracer_.eyeRays(view.camera, view.size);
    seenBlocks_ = trace::parallelUntil(deadline, seenBlocks_, blocks.count(), [&](std::size_t block) { seeBlock(rays, block); });
    if (seenBlocks_ < blocks.count()) return false;
    hasPreview_ = advanceLights(true, deadline);
    return hasPreview_;
}

bool PixelLight::advanceLights(bool onlyPreview, Deadline deadline) {
    for (int light = 0; light < static_cast<int>(lights_.size()); ++light)
        if (!advanceLight(light, onlyPreview, deadline)) return false;
    return true;
}

/// True once the light has its shares or, if that is enough, a preview.
bool PixelLight::advanceLight(int light, bool onlyPreview, Deadline deadline) {
    OfLight& ofLight = lights_[static_cast<std::size_t>(light)];
    if (const scene::Light& source = snapshot_->light(light); ofLight.sharesFromBelow.empty() || ofLight.light != source) {
        const auto pixels = static_cast<std::size_t>(size().x) * static_cast<std::size_t>(size().y);
        ofLight = {source, nullptr, std::vector<Share>(pixels), {}, 0, 0, 0};
        if (scene::hasArea(source)) ofLight.previewFromBelow.resize(pixels);
    }
    const bool hasArea = scene::hasArea(ofLight.light), previews = hasArea && onlyPreview;
    std::size_t& next = previews ? ofLight.nextPreviewTile : ofLight.nextTile;
    if (next == tiles().count()) return true;
    if (hasArea && !previews && !ofLight.area) ofLight.area = std::make_unique<trace::AreaVisibility>(tracer_, light);
    std::vector<Share>& shares = previews ? ofLight.previewFromBelow : ofLight.sharesFromBelow;
    next = trace::parallelUntil(deadline, next, tiles().count(), [&](std::size_t tile) { lightTile(ofLight, light, tile, shares); });
    if (next < tiles().count()) return false;
    ofLight.version = ++version_;
    ofLight.area.reset();
    if (!previews) ofLight.previewFromBelow = {};
    return true;
}

trace::Blocks PixelLight::tiles() const { return {seenFrom_.size, kTileSide}; }

bool PixelLight::isPreview(int light) const {
    const OfLight& ofLight = lights_[static_cast<std::size_t>(light)];
    return scene::hasArea(ofLight.light) && ofLight.nextTile < tiles().count();
}

std::span<const trace::SurfacePoint> PixelLight::pointsOf(std::size_t block) const {
    const trace::Blocks blocks{seenFrom_.size, kBlockSide};
    const ivec2 size = blocks.sizeAt(blocks.corner(block));
    return std::span(points_).subspan(block * kBlockPixels, static_cast<std::size_t>(size.x * size.y));
}

const trace::SurfacePoint& PixelLight::pointAt(ivec2 pixel) const {
    const trace::Blocks blocks{seenFrom_.size, kBlockSide};
    const ivec2 place = pixel / kBlockSide, within = pixel % kBlockSide;
    const auto block = static_cast<std::size_t>(place.y * blocks.grid().x + place.x);
    return pointsOf(block)[static_cast<std::size_t>(within.y * blocks.sizeAt(blocks.corner(block)).x + within.x)];
}

dvec3 PixelLight::normalWorld(const trace::SurfacePoint& point) const {
    return normals_->towardWorld(glm::normalize(seenFrom_.camera.positionWorld - tracer_.positionWorld(point)), point);
}

void PixelLight::seeBlock(const trace::EyeRays& rays, std::size_t block) {
    const trace::Blocks blocks{seenFrom_.size, kBlockSide};
    const ivec2 corner = blocks.corner(block), size = blocks.sizeAt(corner);
    tracer_.eyePoints(rays, corner, size, dvec2(0.5), // through the centres of the pixels
                      std::span(points_).subspan(block * kBlockPixels, static_cast<std::size_t>(size.x * size.y)));
}

// [anchor: light-on-a-pixel]
void PixelLight::lightTile(const OfLight& ofLight, int light, std::size_t tile, std::vector<Share>& sharesFromBelow) const {
    const trace::Blocks blocks{seenFrom_.size, kBlockSide};
    const ivec2 first = tiles().corner(tile) / kBlockSide, end = glm::min(first + kTileBlocks, blocks.grid());
    std::vector<std::size_t> ofTile;
    std::vector<trace::SurfacePoint> points;
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) {
            ofTile.push_back(static_cast<std::size_t>(y * blocks.grid().x + x));
            const std::span<const trace::SurfacePoint> ofBlock = pointsOf(ofTile.back());
            points.insert(points.end(), ofBlock.begin(), ofBlock.end());
        }
    const std::vector<Share> shares = ofLight.area ? areaShares(*ofLight.area, points) : sharesWithoutArea(light, points);
    auto row = shares.begin();
    for (const std::size_t block : ofTile) {
        const ivec2 corner = blocks.corner(block), size = blocks.sizeAt(corner);
        for (int y = 0; y < size.y; ++y, row += size.x) {
            const int rowFromBelow = seenFrom_.size.y - 1 - (corner.y + y);
            std::copy_n(row, size.x, sharesFromBelow.begin() + static_cast<std::ptrdiff_t>(rowFromBelow) * seenFrom_.size.x + corner.x);
        }
    }
}

std::vector<PixelLight::Share> PixelLight::sharesWithoutArea(int light, std::span<const trace::SurfacePoint> points) const {
    std::vector<trace::Visibility> answers(points.size());
    tracer_.visibilities(points, light, answers);
    std::vector<Share> shares(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        shares[i].seen = answers[i] == trace::Visibility::lit ? 1.0f : 0.0f;
    return shares;
}

std::vector<PixelLight::Share> PixelLight::areaShares(const trace::AreaVisibility& area,
                                                      std::span<const trace::SurfacePoint> points) const {
    std::vector<trace::SurfacePoint> seen; // without the background
    std::vector<dvec3> normalsWorld;
    for (const trace::SurfacePoint& point : points) {
        if (!point) continue;
        seen.push_back(point);
        normalsWorld.push_back(normalWorld(point));
    }
    std::vector<trace::AreaIrradiance> found(seen.size());
    if (!seen.empty()) area.irradiances(seen, normalsWorld, found);
    std::vector<Share> shares(points.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i]) {
            shares[i] = {static_cast<float>(found[next].visible), static_cast<float>(found[next].irradiance)};
            ++next;
        }
    return shares;
}

} // namespace shadowlab::radiosity
