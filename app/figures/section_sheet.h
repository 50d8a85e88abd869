// The plane through eye, light and point on a sheet of paper: how large it is drawn, and what all drawings of it share.
// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <span>

#include "app/drawing/labels.h"
#include "app/figures/drawing_plane.h"
#include "app/figures/panels.h"
#include "app/figures/volume/volume_areas.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::figures {

/// Has the probe what such a drawing needs: a plane, and what a technique knows of the shadow?
bool hasSection(const Probe& probe);

class SectionSheet {
public:
    /// All of eye, light, point and `places` (metres of the plane) as large as fits into `area`; what would make everything else
    /// tiny is left out, and an arrow at the border points to it.
    /// `mostScale`: pixels for a metre, at most; with such a limit what is shown begins at the upper left corner, so that two
    /// sheets of one plane have eye and light in the same places. `hasEye`: false for what is drawn without the eye and its line.
    SectionSheet(const Probe& probe, const scene::Scene& scene, const drawing::Box& area, std::span<const dvec2> places,
                 double mostScale = std::numeric_limits<double>::infinity(), bool hasEye = true);
    /// Only what lies within `reach` metres of the point.
    SectionSheet(const Probe& probe, const scene::Scene& scene, const drawing::Box& area, double reach);

    [[nodiscard]] dvec2 operator()(dvec2 place) const {
        return centre_ + scale_ * dvec2(place.x - middle_.x, middle_.y - place.y);
    }
    [[nodiscard]] const drawing::Box& area() const { return area_; }
    [[nodiscard]] drawing::Box metres() const; ///< of the area
    [[nodiscard]] const LightSection& section() const { return section_; }
    [[nodiscard]] const PlaneLight& light() const { return light_; }
    [[nodiscard]] dvec2 eye() const { return eye_; }
    [[nodiscard]] double scale() const { return scale_; } ///< pixels for a metre
    /// Where the line from a place (metres) leaves the area, in pixels.
    [[nodiscard]] dvec2 border(dvec2 from, dvec2 direction) const;
    [[nodiscard]] bool shows(dvec2 place) const; ///< is it in the area?

    /// Where the scene's surfaces are cut: casters dark, all others light.
    void drawScene(drawing::Drawing& drawing, drawing::Labels& labels) const;
    void drawEye(drawing::Drawing& drawing, drawing::Labels& labels) const;
    void drawLight(drawing::Drawing& drawing, drawing::Labels& labels) const;
    void drawPoint(drawing::Drawing& drawing, drawing::Labels& labels, const std::string& name = "point") const;
    /// All three, with the light's line of that colour and the eye's line to the point. `arrowAt`: the share of the light's line at
    /// which its head is.
    void drawLines(drawing::Drawing& drawing, drawing::Labels& labels, const std::string& lightColor, double arrowAt) const;

private:
    void findPlaces(const Probe& probe);
    void fit(const std::vector<dvec2>& places, double mostScale = std::numeric_limits<double>::infinity());
    void drawAway(drawing::Drawing& drawing, drawing::Labels& labels, dvec2 direction, const std::string& text,
                  const std::string& color) const;

    const scene::Scene& scene_;
    drawing::Box area_;
    LightSection section_;
    PlaneLight light_;
    std::string lightName_;
    dvec2 eye_{0.0}, middle_{0.0}, centre_{0.0};
    double scale_ = 1;
};

/// A row of coloured signs with what they mean.
struct LegendEntry {
    enum class Kind { filled, line, dashed, dot } kind = Kind::line;
    std::string color, text;
};
void drawLegend(drawing::Drawing& drawing, const drawing::Box& area, std::span<const LegendEntry> entries, const image::Font& font);

/// Lines of text below one another, each broken where it is too long.
class TextColumn {
public:
    /// `em`: of the type.
    TextColumn(drawing::Drawing& drawing, const drawing::Box& area, const image::Font& font, double em = kText)
        : svg_(drawing), area_(area), font_(font), em_(em) {}
    void heading(const std::string& text);
    /// False where there is no room any more.
    bool row(const std::string& text, const std::string& color = "#1a1a1a");
    [[nodiscard]] bool hasRoom(int lines) const;

private:
    [[nodiscard]] double lineHeight() const;
    drawing::Drawing& svg_;
    drawing::Box area_;
    const image::Font& font_;
    double em_, y_ = 0;
};

} // namespace shadowlab::figures
