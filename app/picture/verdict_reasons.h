// Why a technique calls a pixel lit or in shadow: the words of a pixel's verdict for each way to decide.
//
// A reason fits behind "IN SHADOW: "; the sums are lines of what a student works out by hand.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab {
struct MapProbe;
struct PlaneProbe;
struct VolumeProbe;
} // namespace shadowlab

namespace shadowlab::picture {

/// With that many digits after the point.
std::string fixed(double number, int decimals);
/// "33 %"; 0 % and 100 % are said of nothing else than 0 and 1.
std::string percentOf(double share);

/// "entered 1, left 0", of the faces that the technique counts.
std::string volumeReason(const VolumeProbe& volume);
/// `isTurnedAway`: the surface gets no light whatever is counted.
void addVolumeSums(const VolumeProbe& volume, bool isTurnedAway, std::vector<std::string>& sums);

/// "d 3.21 m < z - bias 3.95 m", or how many comparisons of the filter say lit. `visibility`: what the filter made of them, 0..1.
std::string mapReason(const MapProbe& map, double visibility);
void addMapSums(const MapProbe& map, std::vector<std::string>& sums);

/// "knot is between, 0.21 m above the plane"
std::string planeReason(const PlaneProbe& plane, bool isLit);
void addPlaneSums(const PlaneProbe& plane, std::vector<std::string>& sums);

} // namespace shadowlab::picture
