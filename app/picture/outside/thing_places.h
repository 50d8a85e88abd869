// From shapes in the scene to things in the picture: which of them are seen, where, and at which points a label can name them.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "app/picture/outside/label_layout.h"
#include "techniques/foundation/scene/model/camera.h"
#include "techniques/scene_shape.h"

namespace shadowlab::picture {

/// A single point that has a name, such as the eye.
struct NamedPoint {
    std::string text;
    vec3 colorLinear{0.0f};
    dvec3 placeWorld{0.0};
};

struct ThingPlaces {
    CoverGrid cover;
    std::vector<LabelWish> wishes; ///< of what is seen in the picture, in the order given: points, then shapes
};

/// Shapes of one label are one thing. `em`: the size of the type, pixels.
ThingPlaces thingPlaces(std::span<const NamedPoint> points, std::span<const SceneShape* const> shapes,
                        const scene::Camera& camera, ivec2 pictureSize, double em);

} // namespace shadowlab::picture
