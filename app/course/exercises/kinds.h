// One function for each kind of exercise; the list of them is in exercises.cpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/course/exercises/exercise.h"

namespace shadowlab::course {

// planes.cpp
Exercise askForProjection(Chance& chance);
Exercise askForPlaneHeights(Chance& chance);
Exercise askForShadowedPixels(Chance& chance);
// maps.cpp
Exercise askForMapDepths(Chance& chance);
Exercise askForTexel(Chance& chance);
// volumes.cpp
Exercise askForFaceCounts(Chance& chance);
Exercise askForExtrusion(Chance& chance);
// lamps.cpp
Exercise askForPenumbra(Chance& chance);
// rays.cpp
Exercise askForReflection(Chance& chance);
Exercise askForRefraction(Chance& chance);
Exercise askForTreeSize(Chance& chance);
Exercise askForIntensity(Chance& chance);
Exercise askForShades(Chance& chance);
// patches.cpp
Exercise askForFormFactor(Chance& chance);
Exercise askForRowSum(Chance& chance);
Exercise askForTwoPatches(Chance& chance);

/// A number as it is printed: exact where five digits after the point are enough, or else rounded to three.
std::string printed(double value);
/// "(1, 2.5, -3)".
std::string printed(const dvec3& vector);
/// Adds its three numbers: "P.x", "P.y", "P.z".
void addVector(std::vector<NamedNumber>& numbers, const std::string& name, const dvec3& vector);

} // namespace shadowlab::course
