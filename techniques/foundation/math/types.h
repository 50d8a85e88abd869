// Vector and matrix types, and the three ways to send something through a matrix.
//
// Conventions (docs/conventions.md): right-handed, +y up, column vectors, a matrix is named <to>From<from> and touching
// names match in a product: clipFromObject = clipFromView * viewFromWorld * worldFromObject.
// Everything is composed in double and cast to float last.
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>

namespace shadowlab {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::mat3;
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

/// bFromA applied to a point (affine matrices only: no division by w).
inline dvec3 transformPoint(const dmat4& bFromA, const dvec3& positionA) {
    return dvec3(bFromA * dvec4(positionA, 1.0));
}

/// bFromA applied to a direction: the translation does not act.
inline dvec3 transformDirection(const dmat4& bFromA, const dvec3& directionA) {
    return dvec3(bFromA * dvec4(directionA, 0.0));
}

/// bFromA applied to a surface normal (inverse transpose), normalised.
inline dvec3 transformNormal(const dmat4& bFromA, const dvec3& normalA) {
    return glm::normalize(glm::transpose(glm::inverse(dmat3(bFromA))) * normalA);
}

/// |x| + |y| + |z|.
inline double sumOfMagnitudes(const dvec3& v) { return glm::abs(v.x) + glm::abs(v.y) + glm::abs(v.z); }

/// How bright a linear colour looks (Rec. 709, whose primaries sRGB has).
inline double luminance(const dvec3& colorLinear) { return glm::dot(colorLinear, dvec3(0.2126, 0.7152, 0.0722)); }

} // namespace shadowlab
