// Causes of errors, each with the physics that it follows from. A function for each kind adds those that explain anything.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <vector>

#include "app/foreign/evidence.h"

namespace shadowlab::foreign {

/// Below this share of the wrong pixels a cause is not worth naming.
constexpr double kLeastExplained = 0.1;

/// Of all of it: without shadows, all dark, inverted.
void addWholeCauses(const Evidence& evidence, std::vector<Cause>& causes);
/// Of the whole picture: flipped, shifted by parts of a pixel, another angle of view, of another light.
void addPictureCauses(const Evidence& evidence, std::vector<Cause>& causes);
/// A light in the wrong place.
void addMovedLightCauses(const Evidence& evidence, std::vector<Cause>& causes);
/// Of distances along the light's rays: depth bias, the limits of a shadow map, and of a spot its cone.
void addLightCauses(const Evidence& evidence, std::vector<Cause>& causes);
/// Of a shadow map that covers a part only.
void addMapCauses(const Evidence& evidence, std::vector<Cause>& causes);
/// Of sides: triangles that cast no shadow, or are not seen, because of the side that they turn; winding; missing casters.
void addWindingCauses(const Evidence& evidence, std::vector<Cause>& causes);
/// Of counting: caps or faces of shadow volumes that are missing, and an eye in shadow.
void addVolumeCauses(const Evidence& evidence, std::vector<Cause>& causes);
/// Of patterns: acne, holes, texels, soft edges.
void addPatternCauses(const Evidence& evidence, std::vector<Cause>& causes);

/// "33 %" of a share, in whole percents.
std::string percentText(double share);
/// "0.36 m", "1.2 cm".
std::string metresText(double metres);

/// Adds the cause if it explains enough.
void addIfExplains(const Evidence& evidence, Cause cause, std::vector<Cause>& causes);

/// The minimum of a function near a place, by steps along each axis and each two of them, which are halved until they are below `leastStep`. No derivative:
/// what is counted in pixels has none.
std::vector<double> patternSearch(std::vector<double> place, double step, double leastStep,
                                  const std::function<double(const std::vector<double>&)>& costOf);

/// Where casters are left out by a distance: the sample is lit if its value is below the threshold.
struct Threshold {
    double value = 0, explained = 0;
    Predictions predictions;
};
/// The threshold that explains most. Samples that the truth has lit stay lit; a value that is not finite stays dark.
Threshold bestThreshold(const Evidence& evidence, const std::vector<double>& values);

} // namespace shadowlab::foreign
