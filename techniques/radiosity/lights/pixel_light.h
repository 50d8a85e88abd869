// The direct light of each pixel, exactly: what a patch knows only as one mean, each pixel asks for itself.
//
// An eye ray finds the point that the pixel shows. Of a light without an area, a shadow ray then says whether it arrives (A. Appel,
// "Some Techniques for Shading Machine Renderings of Solids", 1968); of one with an area, its contours say in closed form which share
// of it is seen (foundation/trace/area/area_visibility.h). So shadows have the same edges as those of ray tracing, however large the
// patches are, and in scenes of any size. Unlike all else in radiosity this depends on the eye.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/shading_normals.h"
#include "techniques/technique.h"

namespace shadowlab::radiosity {

class PixelLight {
public:
    /// Recomputes what has changed (the scene, the eye, a light) until all is done (true) or the deadline has passed, but always does
    /// some work.
    bool advance(const scene::Snapshot& snapshot, const View& view, Deadline deadline);
    /// 0..1 of all pixels of all lights.
    [[nodiscard]] double done() const;
    /// Changes whenever a light has been recomputed.
    [[nodiscard]] std::uint64_t version() const { return version_; }

    /// What a pixel gets of a light.
    struct Share {
        float seen = 0; ///< 0..1: the share of the light that is seen; of one with an area, of its area
        /// Of a light with an area its irradiance, in units of pi times its radiance (trace::AreaIrradiance), by the shading normal.
        float irradiance = 0;
    };
    // Once advance() has returned true:

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
        return lights_[static_cast<std::size_t>(light)].sharesFromBelow;
    }

private:
    struct OfLight {
        scene::Light light;
        std::unique_ptr<trace::AreaVisibility> area; ///< while it is being computed
        std::vector<Share> sharesFromBelow;
        std::size_t nextTile = 0;
    };
    void restart(const scene::Snapshot& snapshot, const trace::SeenFrom& seenFrom);
    void seeBlock(const trace::EyeRays& rays, std::size_t block);
    void lightTile(OfLight& ofLight, int light, std::size_t tile) const;
    [[nodiscard]] std::vector<Share> sharesWithoutArea(int light, std::span<const trace::SurfacePoint> points) const;
    [[nodiscard]] std::vector<Share> areaShares(const trace::AreaVisibility& area, std::span<const trace::SurfacePoint> points) const;

    trace::SceneTracer tracer_;
    scene::Snapshot snapshot_;
    std::optional<trace::ShadingNormals> normals_;
    trace::SeenFrom seenFrom_;
    std::vector<trace::SurfacePoint> points_; ///< that the pixels show, block by block (foundation/trace/blocks.h)
    std::size_t seenBlocks_ = 0;
    std::vector<OfLight> lights_;
    std::uint64_t version_ = 0;
};

} // namespace shadowlab::radiosity
