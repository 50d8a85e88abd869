// How much of an extended light source a place sees, in a plane through the light: areas of umbra and penumbra.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "app/drawing/labels.h"
#include "app/figures/drawing_plane.h"

namespace shadowlab::figures {

class SectionOfLight {
public:
    /// The plane must hold the light's centre. `occluders`: two places of the plane for each segment.
    SectionOfLight(const scene::Light& light, const DrawingPlane& plane, std::vector<dvec2> occluders);

    /// What of the light lies in the plane: of a sphere the diameter square to the line to that place.
    [[nodiscard]] std::array<dvec2, 2> seenFrom(dvec2 place) const;
    /// The share of that segment that nothing stands before, 0..1; of a rect seen from behind 0. 1 where the light is in line.
    [[nodiscard]] double share(dvec2 place) const;
    [[nodiscard]] bool shinesTo(dvec2 place) const;

private:
    bool isSphere_;
    dvec2 centre_;
    double radius_ = 0;
    std::array<dvec2, 2> ends_{};
    dvec2 front_{0.0}; ///< of a rect: unit, the side that it shines to
    std::vector<dvec2> occluders_;
};

/// A piece of the plane in which all, a part, or nothing of the light is seen.
struct LitArea {
    enum class Kind { all, part, none } kind = Kind::all;
    std::vector<dvec2> outline; ///< metres of the plane
};

/// The areas that are not fully lit within a rectangle of the plane, above its lower side. `step`: metres between the lines along which
/// their borders are found; corners are as coarse as that, the borders themselves 1/64 of it.
std::vector<LitArea> shadowAreas(const SectionOfLight& light, const drawing::Box& within, double step);

/// All, a part, or nothing; what is less than a thousandth from all or nothing counts as that.
LitArea::Kind kindAt(const SectionOfLight& light, dvec2 place);

} // namespace shadowlab::figures
