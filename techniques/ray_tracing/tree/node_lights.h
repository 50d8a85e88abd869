// What one light does at a node of a tree of rays: by a shadow ray to the middle of the light, or to a place on it.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/tree/ray_tree.h"

namespace shadowlab::ray_tracing {

/// `node` has a point, its position and its normal.
LightAtNode lightAt(const RayWorld& world, const TreeSettings& settings, const TreeNode& node, int light);

/// Does a shadow ray from the node's point arrive that goes that far (metres) in that direction? `offset` joins the point and
/// the place on the light; `node.u` tells which side of the triangle is looked at.
trace::Visibility visibilityAlong(const RayWorld& world, const TreeSettings& settings, const TreeNode& node,
                                  const dvec3& offset);

} // namespace shadowlab::ray_tracing
