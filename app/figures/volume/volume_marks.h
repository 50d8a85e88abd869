// What the drawings of a line through shadow volumes have in common: areas by their counts, and the signs of faces.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/figures/section_sheet.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

/// Colour of a place that is in so many volumes.
std::string countFill(int count);
/// Colour of a face that counts +1 or -1.
std::string signColor(int sign);
/// "+1", "0", with a true minus sign.
std::string signedText(int number);

/// How often each place of the plane is in a volume, as greys.
void drawCountedAreas(drawing::Drawing& drawing, const SectionSheet& sheet, const VolumeProbe& volume);

/// Where a face crosses the eye's line, in metres of the plane.
dvec2 placeOf(const SectionSheet& sheet, const VolumeProbe::Crossing& crossing);

/// Where the eye's line comes from on the sheet, and where it leaves it beyond the point.
dvec2 lineStart(const SectionSheet& sheet);
dvec2 lineEnd(const SectionSheet& sheet);

} // namespace shadowlab::figures
