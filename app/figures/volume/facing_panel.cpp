// SPDX-License-Identifier: MIT
#include "app/figures/volume/facing_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/figures/inks.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

constexpr double kEdgesAround = 4.5;     ///< lengths of the longest edge, around P, that are drawn
constexpr std::size_t kMostAround = 600; ///< polygons; more could not be distinguished
constexpr double kNormal = 0.5;          ///< length of N as it is drawn, of what is drawn around P
constexpr double kToLight = 1.05;        ///< likewise of L, where the light is farther away than kNear
constexpr double kNear = 2.2;            ///< likewise
constexpr double kNeighbours = 0.62;     ///< paleness
constexpr dvec2 kFacingMargin{52, 52};   ///< pixels for labels

} // namespace

FacingPanel::FacingPanel(const CasterSolid& solid, std::size_t polygon, const drawing::Box& area)
    : solid_(solid), polygons_{polygon}, area_(area), pWorld_(solid.centre(polygon)) {
    findNeighbours();
    chooseView();
}

FacingPanel::FacingPanel(const CasterSolid& solid, std::array<std::size_t, 2> polygons,
                         std::array<std::uint32_t, 2> edge, bool isOutline, const drawing::Box& area)
    : solid_(solid), polygons_(polygons.begin(), polygons.end()), edge_(edge), isOutline_(isOutline), area_(area),
      pWorld_(0.5 * (solid.verticesWorld[edge[0]] + solid.verticesWorld[edge[1]])) {
    findNeighbours();
    chooseView();
}

void FacingPanel::findNeighbours() {
    double longest = 0;
    for (const std::size_t polygon : polygons_) {
        const CasterSolid::Corners c = solid_.corners(polygon);
        for (std::size_t i = 0; i < 3; ++i)
            longest = std::max(longest, glm::length(c[(i + 1) % 3] - c[i]));
    }
    std::vector<std::pair<double, std::size_t>> byDistance;
    for (std::size_t t = 0; t < solid_.triangles(); ++t) {
        double away = 0; // of its farthest corner: so no spike reaches out of what is drawn
        for (const dvec3& corner : solid_.corners(t))
            away = std::max(away, glm::length(corner - pWorld_));
        if (away <= kEdgesAround * longest) byDistance.emplace_back(away, t);
    }
    std::ranges::sort(byDistance);
    if (byDistance.size() > kMostAround) byDistance.resize(kMostAround);
    reach_ = longest;
    for (const auto& [away, triangle] : byDistance) {
        reach_ = std::max(reach_, away);
        if (std::ranges::find(polygons_, triangle) == polygons_.end()) around_.push_back(triangle);
    }
    const dvec3 toLight = solid_.toLight(pWorld_);
    lightIsNear_ = solid_.lightWorld.w != 0 && glm::length(toLight) < kNear * reach_;
    lightTipWorld_ = pWorld_ + (lightIsNear_ ? toLight : kToLight * reach_ * glm::normalize(toLight));
}

/// Polygons from their fronts but not flat, N and L from the side.
double FacingPanel::worth(const dvec3& d) const {
    double least = 1, sides = 0;
    for (const std::size_t polygon : polygons_) {
        const dvec3 normal = solid_.normal(polygon);
        least = std::min(least, glm::dot(normal, d));
        sides += glm::length(glm::cross(normal, d)) / static_cast<double>(polygons_.size());
    }
    const double light = glm::length(glm::cross(glm::normalize(lightTipWorld_ - pWorld_), d));
    // Before the surface, L would cover what it starts from.
    const double usual = d.y > -0.1 && d.y < 0.6 ? 0.25 : 0;
    // Where N and L lead upward rather than aside, all of it is drawn larger.
    const double size = viewFrom(d, std::numeric_limits<double>::infinity()).pixelsPerMetre() * reach_ / area_.size.x;
    return 1.4 * std::min(least, 0.55) + 0.6 * sides + 0.9 * light + usual + 3 * size;
}

void FacingPanel::chooseView() {
    double most = -std::numeric_limits<double>::infinity();
    towardViewerWorld_ = bestDirection([&](const dvec3& direction) {
        const double value = worth(direction);
        if (value <= most) return value;
        for (const std::size_t polygon : polygons_)
            if (isHidden(solid_, solid_.centre(polygon), direction)) return most - 1;
        return most = value;
    });
    limitScale(std::numeric_limits<double>::infinity());
}

void FacingPanel::limitScale(double mostPixelsPerMetre) { view_.emplace(viewFrom(towardViewerWorld_, mostPixelsPerMetre)); }

SpaceView FacingPanel::viewFrom(const dvec3& towardViewerWorld, double mostPixelsPerMetre) const {
    std::vector<dvec3> shown{lightTipWorld_};
    for (const std::size_t polygon : polygons_)
        shown.push_back((edge_ ? solid_.centre(polygon) : pWorld_) + kNormal * reach_ * solid_.normal(polygon));
    for (const std::vector<std::size_t>* list : {&polygons_, &around_})
        for (const std::size_t t : *list)
            for (const dvec3& corner : solid_.corners(t))
                shown.push_back(corner);
    return {shown, towardViewerWorld, area_, kFacingMargin, mostPixelsPerMetre};
}

void FacingPanel::drawPolygons(drawing::Drawing& drawing, drawing::Labels& labels) const {
    drawTriangles(drawing, *view_, solid_, around_, facingColors(kNeighbours));
    for (const std::size_t polygon : polygons_) {
        std::vector<dvec2> corners;
        for (const dvec3& corner : solid_.corners(polygon))
            corners.push_back((*view_)(corner));
        drawing.path(corners, true, drawing::colorText(solid_.facesLight(polygon) ? look::kTowardLight : look::kAwayFromLight),
                     {"#1a1a1a", 3.5, false});
        for (std::size_t i = 0; i < 3; ++i)
            labels.avoid(corners[i], corners[(i + 1) % 3]);
    }
    if (!edge_) return;
    const dvec2 a = (*view_)(solid_.verticesWorld[(*edge_)[0]]), b = (*view_)(solid_.verticesWorld[(*edge_)[1]]);
    drawing.line(a, b, {isOutline_ ? drawing::colorText(look::kSilhouette) : "#1a1a1a", 9, false});
    labels.avoid(a, b);
}

void FacingPanel::drawVectors(drawing::Drawing& drawing, drawing::Labels& labels) const {
    const dvec2 p = (*view_)(pWorld_), light = (*view_)(lightTipWorld_);
    drawing.arrow(p, light, {ink::kLight, 4, false}, lightIsNear_ ? 0.6 : 0.55);
    labels.avoid(p, light);
    if (!lightIsNear_) drawing.breakMark(glm::mix(p, light, 0.8), light - p, {ink::kLight, 3, false});
    const drawing::TextStyle letter{.size = drawing::kLetter, .isBold = true};
    std::vector<std::pair<dvec2, std::string>> tips;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
        const dvec3 foot = edge_ ? solid_.centre(polygons_[i]) : pWorld_;
        const dvec2 from = (*view_)(foot), to = (*view_)(foot + kNormal * reach_ * solid_.normal(polygons_[i]));
        drawing.arrow(from, to, {ink::kNormal, 4, false});
        labels.avoid(from, to);
        tips.emplace_back(to, edge_ ? std::to_string(i + 1) : "");
    }
    drawing.circle(p, 8, "#1a1a1a", {"#ffffff", 2, false}, "point");
    labels.avoid({p - 9.0, dvec2(18)});
    drawLightSign(drawing, labels, *view_, lightTipWorld_, "");
    for (const auto& [tip, index] : tips) {
        drawing::TextStyle style = letter;
        style.color = ink::kNormal;
        labels.place(drawing, tip, drawing::LabelText{"N", index, ""}, style, 8);
    }
    drawing::TextStyle style = letter;
    style.color = ink::kLight;
    labels.place(drawing, glm::mix(p, light, lightIsNear_ ? 0.5 : 0.42), "L", style, 10);
    labels.place(drawing, p, "P", letter, 12);
}

void FacingPanel::draw(drawing::Drawing& drawing, const image::Font& font) const {
    drawing::Labels labels(font, area_);
    drawPolygons(drawing, labels);
    drawVectors(drawing, labels);
}

std::vector<double> FacingPanel::products() const {
    std::vector<double> all;
    for (const std::size_t polygon : polygons_)
        all.push_back(glm::dot(solid_.normal(polygon), solid_.toLight(pWorld_)));
    return all;
}

std::string productText(double product, int index, const char* unit) {
    static constexpr std::array kIndices{"", "_1", "_2"};
    return std::string("$\\mathbf{N}") + kIndices[static_cast<std::size_t>(index)] + " \\cdot \\mathbf{L} = $" + fourDigits(product) +
           unit + (product > 0 ? " > 0" : " \u2264 0");
}

} // namespace shadowlab::figures
