// The placement of an object: scale, then rotate about world x, then y, then z, then translate.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/json/scene_json.h"

namespace shadowlab::scene {

namespace {

/// Rotation about a coordinate axis, counter-clockwise seen from the axis' tip. Quarter turns hold only 0, 1 and -1, so
/// that a wall turned by 90 degrees is exactly upright.
dmat3 rotation(int axis, double degrees) {
    const double turn = std::remainder(degrees, 360.0);                       // exact; -180..180
    const double quarters = std::round(turn / 90.0);                          // -2..2
    const double rest = (turn - 90.0 * quarters) * glm::pi<double>() / 180.0; // at most 45 degrees
    double c = std::cos(rest), s = std::sin(rest);
    for (int i = 0; i < static_cast<int>(quarters + 4.0) % 4; ++i) {
        const double previousC = c;
        c = -s;
        s = previousC;
    }
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    dmat3 result(1.0);
    result[u][u] = c;
    result[u][v] = s;
    result[v][u] = -s;
    result[v][v] = c;
    return result;
}

} // namespace

dmat4 worldFromObjectOf(const dvec3& scale, const dvec3& rotateDegrees, const dvec3& translate) {
    const dmat3 turn = rotation(2, rotateDegrees.z) * rotation(1, rotateDegrees.y) * rotation(0, rotateDegrees.x);
    dmat4 result(1.0);
    for (int column = 0; column < 3; ++column)
        result[column] = dvec4(turn[column] * scale[column] + 0.0, 0.0); // + 0.0 turns -0 into +0
    result[3] = dvec4(translate, 1.0);
    return result;
}

dmat4 worldFromObjectOf(const ObjectSource& source) {
    const dmat4 placement = worldFromObjectOf(source.scale, source.rotateDegrees, source.translateWorld);
    return source.objectFromNode == dmat4(1.0) ? placement : placement * source.objectFromNode;
}

} // namespace shadowlab::scene
