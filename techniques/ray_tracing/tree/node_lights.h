// The contribution of one light at a node of a ray tree, by a shadow ray to its centre, or to a point on it.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/tree/ray_tree.h"

namespace shadowlab::ray_tracing {

/// `node` must have its point, position and normal.
LightAtNode lightAt(const RayWorld& world, const TreeSettings& settings, const TreeNode& node, int light);

/// Is the segment from the node's point by `offset` (metres), to a point on that light, unblocked? `node.u` tells which side of
/// the triangle is seen.
trace::Visibility visibilityAlong(const RayWorld& world, const TreeSettings& settings, const TreeNode& node, int light,
                                  const dvec3& offset);

} // namespace shadowlab::ray_tracing
