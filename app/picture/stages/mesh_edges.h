// The stage `mesh-edges`: where meshes are open, and where they are no surface at all. They are those that `inspect` counts.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/picture/figure.h"
#include "techniques/foundation/gl/scene/scene_buffers.h"

namespace shadowlab::picture {

/// `picture` is the finished picture of the view, which becomes the ground: grey and darkened. On it every edge that is
/// not that of a closed surface, as a line; what lies behind something is thin and faint. The legend counts the edges of
/// all objects, seen or not. Needs a current GL context; `buffers` hold the scene.
Panel meshEdgesPanel(image::Image picture, const scene::Scene& scene, const gl::SceneBuffers& buffers,
                     const View& view);

} // namespace shadowlab::picture
