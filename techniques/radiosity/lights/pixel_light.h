// The direct light of each pixel, exactly: what a patch knows only as one mean, each pixel asks for itself.
//
// An eye ray finds the point that the pixel shows. Of a light without an area, a shadow ray then says whether it arrives (A. Appel,
// "Some Techniques for Shading Machine Renderings of Solids", 1968); of one with an area, its contours say in closed form which share
// of it is seen (foundation/trace/area/area_visibility.h). So shadows have the same edges as those of ray tracing, however large the
// patches are, and in scenes of any size. Unlike all else in radiosity this depends on the eye.
// Shares of lights with an area take seconds in crowded scenes. So before the first of them, all pixels ask for the centres of these
// lights: a preview with hard shadows.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/blocks.h"
#include "techniques/foundation/trace/shading_normals.h"
#include "techniques/technique.h"

namespace shadowlab::radiosity {

class PixelLight {
public:
    /// Recomputes what has changed (the scene, the eye, a light) until all is done (true) or the deadline has passed, but always does
    /// some work.
    bool advance(const scene::Snapshot& snapshot, const View& view, Deadline deadline);
    /// The same until there is a preview.
    bool advancePreview(const scene::Snapshot& snapshot, const View& view, Deadline deadline);
    /// Are the shares of all lights there, of those with an area at least the preview?
    [[nodiscard]] bool hasPreview() const { return hasPreview_; }
    /// Changes whenever the light's shares have become exact, or a preview.
    [[nodiscard]] std::uint64_t version(int light) const { return lights_[static_cast<std::size_t>(light)].version; }
    /// Changes whenever that of some light does.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    [[nodiscard]] std::size_t lights() const { return lights_.size(); }
    /// Of a light with an area: does only its centre count, as a point?
    [[nodiscard]] bool isPreview(int light) const;

    /// What a pixel gets of a light.
    struct Share {
        float seen = 0; ///< 0..1: the share of the light that is seen; of one with an area, of its area
        /// Of a light with an area its irradiance, in units of pi times its radiance (trace::AreaIrradiance), by the shading normal.
        float irradiance = 0;
    };
    // Once there is a preview, with shares that are 1 or 0, and exactly once advance() has returned true:

    [[nodiscard]] ivec2 size() const { return seenFrom_.size; }
    /// What the pixels show, and the rays that found it: for others who ask on from there (pixel_gather.h).
    [[nodiscard]] const trace::SceneTracer& tracer() const { return tracer_; }
    [[nodiscard]] const trace::SeenFrom& seenFrom() const { return seenFrom_; }
    /// Of a block of pixels (foundation/trace/blocks.h, kBlock on a side), row by row from its top.
    [[nodiscard]] std::span<const trace::SurfacePoint> pointsOf(std::size_t block) const;
    /// Rows count from the top.
    [[nodiscard]] const trace::SurfacePoint& pointAt(ivec2 pixel) const;
    /// The shading normal there, on the eye's side.
    [[nodiscard]] dvec3 normalWorld(const trace::SurfacePoint& point) const;
    /// Of all pixels; row 0 is at the bottom, as GL wants it.
    [[nodiscard]] const std::vector<Share>& sharesFromBelow(int light) const {
        const OfLight& ofLight = lights_[static_cast<std::size_t>(light)];
        return isPreview(light) ? ofLight.previewFromBelow : ofLight.sharesFromBelow;
    }

private:
    struct OfLight {
        scene::Light light;
        std::unique_ptr<trace::AreaVisibility> area; ///< while it is being computed
        std::vector<Share> sharesFromBelow, previewFromBelow;
        std::size_t nextPreviewTile = 0, nextTile = 0;
        std::uint64_t version = 0;
    };
    [[nodiscard]] trace::Blocks tiles() const;
    bool advanceLights(bool onlyPreview, Deadline deadline);
    bool advanceLight(int light, bool onlyPreview, Deadline deadline);
    void restart(const scene::Snapshot& snapshot, const trace::SeenFrom& seenFrom);
    void seeBlock(const trace::EyeRays& rays, std::size_t block);
    void lightTile(const OfLight& ofLight, int light, std::size_t tile, std::vector<Share>& sharesFromBelow) const;
    [[nodiscard]] std::vector<Share> sharesWithoutArea(int light, std::span<const trace::SurfacePoint> points) const;
    [[nodiscard]] std::vector<Share> areaShares(const trace::AreaVisibility& area, std::span<const trace::SurfacePoint> points) const;

    trace::SceneTracer tracer_;
    scene::Snapshot snapshot_;
    std::optional<trace::ShadingNormals> normals_;
    trace::SeenFrom seenFrom_;
    std::vector<trace::SurfacePoint> points_; ///< that the pixels show, block by block (foundation/trace/blocks.h)
    std::size_t seenBlocks_ = 0;
    bool hasPreview_ = false;
    std::vector<OfLight> lights_;
    std::uint64_t version_ = 0;
};

} // namespace shadowlab::radiosity
