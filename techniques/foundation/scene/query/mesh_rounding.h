// How far two things that were given at one place may be apart in a scene.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::scene {

// A number of a mesh file is wrong by 2^-25 of itself when it has become a float. Twice that, so that the numbers may also have been
// written with the seven digits that a float has.
constexpr double kFloatRounding = 0x1p-24;

// Some roundings of double: of a matrix, of a position and of a normal.
constexpr double kDoubleRounding = 1e-14;

} // namespace shadowlab::scene
