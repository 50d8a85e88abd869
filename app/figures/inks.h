// The inks of drawings on paper: as the colours of pictures (techniques/foundation/base/look.h), each has one meaning, but they are dark enough
// for thin lines and letters on white.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::figures::ink {

constexpr const char* kEye = "#1a1a1a";    ///< the eye, its rays and what is drawn from it
constexpr const char* kLight = "#a06000";  ///< the light, its rays and axes, and what its map holds
constexpr const char* kNormal = "#0072b2"; ///< normals of surfaces
constexpr const char* kAsked = "#0072b2";  ///< the depth of the point itself, which a map is asked about: no drawing of a map has normals

} // namespace shadowlab::figures::ink
