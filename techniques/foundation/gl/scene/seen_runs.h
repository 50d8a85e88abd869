// How an object is drawn where some of its triangles coincide with others: which sides are left out, and which are drawn a layer nearer
// to the eye (scene/query/coincident/seen_sides.h). Every pass that writes or compares the depth of surfaces draws through these
// functions, so that all of them give a triangle the same depth.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "techniques/foundation/gl/scene/mesh_buffers.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/coincident/seen_sides.h"

namespace shadowlab::gl {

/// A run of triangles whose sides are seen alike.
struct SeenRun {
    std::uint32_t first = 0, count = 0;
    scene::SeenSide front, back;
};

struct SeenRuns {
    std::vector<std::uint32_t> order;                  ///< of the mesh's triangles
    std::vector<std::vector<SeenRun>> ofPart;          ///< of each part first those that are drawn as others are, then those whose front is
    std::vector<scene::SeenSides> sides;               ///< of the triangles that are not drawn as others are, counted in the mesh
    double gap = 0;                                    ///< the greatest of theirs, metres
    std::shared_ptr<const OrderedTriangles> triangles; ///< in that order, shared by objects of one mesh and one order
};

/// For an object whose sides these are, counted in its mesh; `triangles` is left to the caller.
SeenRuns seenRuns(const scene::Mesh& mesh, std::vector<scene::SeenSides> sides);

/// How much nearer a layer is (glPolygonOffset).
struct LayerStep {
    float slopes = 0; ///< times the depth's slope per pixel
    float units = 0;  ///< of the depth buffer
};
/// For planes that rounding has moved apart by `gap` metres, no nearer to the eye than `nearest` metres, in the viewport as it is; at most
/// 1.42 times as much as they need.
LayerStep layerStep(double gap, double nearest, const dmat4& clipFromView);

/// An object as the eye sees it.
struct SeenObject {
    LayerStep step;
    bool mirrored = false;     ///< scene::isMirrored
    bool eyeIsOutside = false; ///< of its box
};

/// `draw(first, count)` for the runs of one part. Where back faces are culled, by the state, no back is drawn.
void drawInLayers(std::span<const SeenRun> runs, const SeenObject& object,
                  const std::function<void(std::uint32_t, std::uint32_t)>& draw);

/// The same for a run of triangles in the mesh's own order.
void drawInLayers(const SeenRuns& runs, std::uint32_t first, std::uint32_t count, const SeenObject& object,
                  const std::function<void(std::uint32_t, std::uint32_t)>& draw);

} // namespace shadowlab::gl
