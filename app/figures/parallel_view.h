// A parallel projection of the scene onto a sheet: what is parallel in the scene is parallel in the drawing, and nothing
// shrinks with its distance.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "app/drawing/labels.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::figures {

class ParallelView {
public:
    /// `upWorld` is upward on the sheet, as far as that is possible; it must not be parallel to the other. Neither need be unit.
    ParallelView(const dvec3& towardViewerWorld, const dvec3& upWorld);

    /// All of these places as large as the room allows, in its middle.
    void fit(std::span<const dvec3> placesWorld, const drawing::Box& room);
    /// Pixels of the sheet.
    [[nodiscard]] dvec2 operator()(const dvec3& positionWorld) const;
    [[nodiscard]] dvec2 direction(const dvec3& directionWorld) const; ///< the same of a direction: y is downward
    [[nodiscard]] double scale() const { return scale_; }             ///< pixels for a metre
    [[nodiscard]] const dvec3& towardViewerWorld() const { return toward_; }

private:
    dvec3 toward_, right_, up_;
    double scale_ = 1;
    dvec2 offset_{0.0};
};

/// The edges of an object that are drawn: its outline, its borders, and the creases on the sides that are seen. Two places for
/// each. `viewerWorld` is homogeneous: a place, or with w = 0 the direction toward a viewer far away.
std::vector<dvec3> drawnEdgesWorld(const scene::Object& object, const dvec4& viewerWorld);

/// An object as lines, which labels keep away from. What reaches beyond the area is cut off.
void drawObject(drawing::Drawing& drawing, const drawing::Box& area, const ParallelView& view, const scene::Object& object,
                const drawing::Stroke& stroke, drawing::Labels* labels = nullptr);

} // namespace shadowlab::figures
