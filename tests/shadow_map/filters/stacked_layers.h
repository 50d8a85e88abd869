// Flat layers under a light that shines straight down, seen from straight above: what a kernel of the map holds is known in
// closed form, from how much of it lies on either side of the upper layer's edge.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/fit/scene_maps.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

/// A nearest to the light, where x lies beyond its edge; B a below it, everywhere, or where z lies beyond its own; C b below B.
/// The eye sees one of them alone: its near plane cuts away those above, which only shadow it.
class StackedLayers {
public:
    struct Shape {
        double a = 1, b = 1;      ///< metres from A to B, and from B to C
        bool seesB = false;       ///< the eye; else it sees C
        bool bEndsAtEdge = false; ///< where z is what x is at A's edge
    };
    StackedLayers(const Shape& shape, int resolution, int blurRadius) : shape_(shape), blurRadius_(blurRadius) {
        // The maps do not depend on where A and B end inside, so the edge may be put right between two of their texels.
        const scene::Scene whole = made(0);
        const shadow_map::LightMaps maps = sceneMaps(whole, whole.lights[0], resolution, blurRadius + 1,
                                                     {.fit = shadow_map::ProjectionParams::Fit::scene}, true);
        nearest_ = maps.nearest, farthest_ = maps.farthest;
        originHeight_ = maps.originWorld.y;
        texel_ = 2 / (maps.lightClipFromLightView[0][0][0] * resolution);
        edge_ = 7 * texel_; // the middle of the scene is that of the map: of an even number of texels, a corner
        scene_ = made(edge_);
        const double halfKernel = (blurRadius + 0.5) * texel_;
        scene_.camera =
            PlaneView{.centre = {edge_, edge_}, .pixelsPerMetre = 0.4 * kSize.y / halfKernel, .size = kSize}.camera();
    }
    /// Odd: the pixel in the middle lies on the edge.
    static constexpr ivec2 kSize{101, 101};

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }
    [[nodiscard]] double metresFromEdge(int pixel) const { // toward where A is not
        const double halfKernel = (blurRadius_ + 0.5) * texel_;
        return (pixel + 0.5 - 0.5 * kSize.x) * halfKernel / (0.4 * kSize.y);
    }
    /// The share of a kernel that lies on A's side (for rows: B's): texels are either in A or not, and their averages are
    /// interpolated; together that is linear, over the width of the kernel.
    [[nodiscard]] double share(int pixel) const {
        return std::clamp(0.5 - metresFromEdge(pixel) / ((2 * blurRadius_ + 1) * texel_), 0.0, 1.0);
    }
    /// As moments are taken of it: -1 at the near side of the map, 1 at its far side.
    [[nodiscard]] double momentDepthOf(double heightAboveSeen) const {
        return 2 * (originHeight_ - heightAboveSeen - nearest_) / (farthest_ - nearest_) - 1;
    }

private:
    [[nodiscard]] scene::Scene made(double edge) const {
        constexpr double kHalf = 5;
        scene::Scene scene = floorScene();
        scene.objects.clear();
        scene.lights.push_back(directionalLight({0, -1, 0}));
        const double bHeight = shape_.seesB ? 0 : shape_.b;
        const auto layer = [&](double height, dvec2 upper) {
            const dvec2 middle = 0.5 * (upper - kHalf);
            addObject(scene, scene::makeQuad(upper + kHalf), translation({middle.x, height, middle.y}));
        };
        layer(bHeight + shape_.a, {edge, kHalf});
        layer(bHeight, {kHalf, shape_.bEndsAtEdge ? edge : kHalf});
        layer(bHeight - shape_.b, {kHalf, kHalf});
        return scene;
    }

    Shape shape_;
    int blurRadius_;
    double nearest_ = 0, farthest_ = 1, originHeight_ = 0, texel_ = 1, edge_ = 0;
    scene::Scene scene_;
};

} // namespace shadowlab::testing
