// How often each place of a drawing's plane is in shadow volumes: areas between the light's rays.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "app/drawing/labels.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

/// The light in the plane: a place, or where isDirection the unit direction toward it.
struct PlaneLight {
    dvec2 at{0.0};
    bool isDirection = false;
    /// Unit, from a place toward the light.
    [[nodiscard]] dvec2 toward(dvec2 place) const;
};

/// A quadrilateral in which one count holds.
struct CountedArea {
    int count = 0;
    std::array<dvec2, 4> corners{};
};

/// How many volumes a place is in: top caps less bottom caps between it and the light.
int countAt(dvec2 place, std::span<const VolumeProbe::CapLine> caps, const PlaneLight& light);

/// All areas with a count other than 0 that may lie within the rectangle (metres of the plane).
std::vector<CountedArea> countedAreas(std::span<const VolumeProbe::CapLine> caps, const PlaneLight& light,
                                      const drawing::Box& within);

} // namespace shadowlab::figures
