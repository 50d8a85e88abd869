// Polygons among their neighbours, each in the colour of the side that it turns to the light, with N and L.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/figures/volume/caster_solid.h"

namespace shadowlab::figures {

class FacingPanel {
public:
    /// One polygon; or the two that share an edge (vertices), which P then lies on.
    FacingPanel(const CasterSolid& solid, std::size_t polygon, const drawing::Box& area);
    FacingPanel(const CasterSolid& solid, std::array<std::size_t, 2> polygons, std::array<std::uint32_t, 2> edge,
                bool isOutline, const drawing::Box& area);
    void draw(drawing::Drawing& drawing, const image::Font& font) const;
    /// Two panels side by side are drawn at one scale: pixels for a metre, and what there are at most.
    [[nodiscard]] double pixelsPerMetre() const { return view_->pixelsPerMetre(); }
    void limitScale(double mostPixelsPerMetre);

    /// N.L of each of the polygons: positive where it faces the light.
    [[nodiscard]] std::vector<double> products() const;

private:
    void findNeighbours();
    void chooseView();
    [[nodiscard]] double worth(const dvec3& towardViewerWorld) const;
    [[nodiscard]] SpaceView viewFrom(const dvec3& towardViewerWorld, double mostPixelsPerMetre) const;
    void drawPolygons(drawing::Drawing& drawing, drawing::Labels& labels) const;
    void drawVectors(drawing::Drawing& drawing, drawing::Labels& labels) const;

    const CasterSolid& solid_;
    std::vector<std::size_t> polygons_, around_; ///< around_ without polygons_
    std::optional<std::array<std::uint32_t, 2>> edge_;
    bool isOutline_ = false;
    drawing::Box area_;
    dvec3 pWorld_{0.0};
    double reach_ = 1; ///< metres around P that are drawn
    dvec3 lightTipWorld_{0.0};
    bool lightIsNear_ = false; ///< L is drawn in its whole length
    dvec3 towardViewerWorld_{0, 0, 1};
    std::optional<SpaceView> view_;
};

/// "N · L = 0.412 m > 0" with formulas between $ (drawing/prose.h), and a number to N where there are several: 0 for none.
std::string productText(double product, int index, const char* unit);

} // namespace shadowlab::figures
