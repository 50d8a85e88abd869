// What random scenes are built of: polygons, closed bodies, an eye that looks at them.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/student/search/dice.h"
#include "app/student/search/search_scene.h"

namespace shadowlab::student {

/// Turned about the world's y axis. Corners of all bodies are counter-clockwise seen from outside.
SearchObject box(const std::string& name, const dvec3& center, const dvec3& size, double turnDegrees = 0);
SearchObject pyramid(const std::string& name, const dvec3& center, const dvec3& size, double turnDegrees = 0);
/// A star of `tips` tips, extruded upward.
SearchObject star(const std::string& name, const dvec3& center, const dvec3& size, int tips, double turnDegrees = 0);
/// An icosahedron, each of its triangles cut into four: 80.
SearchObject ball(const std::string& name, const dvec3& center, double radius);
/// A parallelogram around its centre that faces cross(edgeU, edgeV).
SearchObject sheet(const std::string& name, const dvec3& center, const dvec3& edgeU, const dvec3& edgeV);
/// A square in the plane y = height that faces up.
SearchObject floorOf(double side, double height = 0);

SearchObject ofMaterial(SearchObject object, const std::string& material);

/// A box, a pyramid or a star.
SearchObject anyBody(Dice& dice, const std::string& name, const dvec3& center, double size);

/// One to three of them, each at most `reach` from the middle along x and z, and with its middle at most `highest` above the floor, which none
/// touches.
void addBodies(SearchScene& scene, Dice& dice, double reach, double highest);

/// Looks at `target` from a place around it, above the floor.
void lookFromAround(SearchScene& scene, Dice& dice, const dvec3& target, double distance);

SearchLight lamp(const dvec3& place, double intensity);
SearchLight sun(const dvec3& travels);
/// From anywhere above.
SearchLight anySun(Dice& dice);
/// The scene with such a sun in place of its lights, and beside them.
SearchScene inTheSun(SearchScene scene, Dice& dice);
SearchScene withTheSun(SearchScene scene, Dice& dice);

} // namespace shadowlab::student
