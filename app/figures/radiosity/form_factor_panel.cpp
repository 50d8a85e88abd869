// The lecture's figure of a form factor: surface j and surface k, N_j and N_k, phi_j and phi_k, r, dA_j and dA_k.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "app/drawing/prose.h"
#include "app/figures/panels.h"
#include "app/figures/radiosity/patch_view.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/patch_exchange.h"

namespace shadowlab::figures {

namespace {

constexpr double kFigureWidth = 1080, kGap = 40; ///< pixels; the rest of the width is for numbers
constexpr double kLeastNumbers = 600;            ///< of that width there must be at least so much
constexpr double kLabel = 30;                    ///< em: indices are smaller than their letters
const dvec2 kFigureMargin(130, 58);              ///< pixels around what is drawn, for labels
constexpr double kArcShare = 0.45;               ///< of the shorter of a normal and r, as it is drawn
constexpr int kArcPieces = 24, kAvoided = 6;     ///< pieces of an arc; so many are one line that labels avoid

const drawing::Stroke kThin{"#1a1a1a", 2, false}, kThick{"#1a1a1a", 4, false};

double angleBetween(const dvec3& a, const dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); // the arc cosine of nearly 1 has no digits
}

/// The numbers of a room that has space for no more.
std::string oneLine(const PatchExchange& exchange) {
    return "$r$ = " + fourDigits(glm::length(exchange.k->centreWorld - exchange.j.centreWorld)) +
           " m, $F_{jk}$ = " + fourDigits(exchange.formFactorJk) +
           ", $F_{kj}$ = " + fourDigits(exchange.formFactorKj) +
           ", $A_j F_{jk} = A_k F_{kj}$ = " + fourDigits(exchange.j.area * exchange.formFactorJk) +
           " m\u00b2";
}

/// What is drawn of one of the two surfaces.
struct DrawnSurface {
    const PatchProbe* patch;
    std::string letter, color;
    dvec3 toOtherWorld;               ///< unit, from its centre to that of the other one
    double magnified;
    dvec2 centre; ///< metres of the drawing
    [[nodiscard]] double phi() const { return angleBetween(patch->normalWorld, toOtherWorld); }
};

class FormFactorDrawing {
public:
    FormFactorDrawing(const PatchExchange& exchange, const drawing::Box& area, const image::Font& font)
        : view_(patchView(exchange.j, *exchange.k)), labels_(font, area), area_(area) {
        const dvec3 wayWorld = exchange.k->centreWorld - exchange.j.centreWorld, unit = glm::normalize(wayWorld);
        distance_ = glm::length(wayWorld);
        const dvec2 far = view_.of(view_.distanceShare * wayWorld);
        surfaces_ = {
            DrawnSurface{&exchange.j, "j", drawing::colorText(look::kPatchJ), unit, view_.magnified[0], dvec2(0)},
            DrawnSurface{&*exchange.k, "k", drawing::colorText(look::kPatchK), -unit, view_.magnified[1], far}};
        // Where they point at each other, normals must not meet.
        const double drawn = view_.distanceShare * distance_;
        normalLength_ = (surfaces_[0].phi() < 0.6 && surfaces_[1].phi() < 0.6 ? 0.4 : 0.6) * drawn;
        fit();
    }

    void draw(drawing::Drawing& drawing) {
        for (const DrawnSurface& surface : surfaces_)
            drawSurface(drawing, surface);
        drawLine(drawing);
        for (const DrawnSurface& surface : surfaces_)
            drawAngle(drawing, surface);
        for (const DrawnSurface& surface : surfaces_)
            drawNormal(drawing, surface);
        label(drawing);
    }

    /// What is not as it lies in space; empty: all is.
    [[nodiscard]] std::string liberties() const {
        std::string text;
        if (view_.distanceShare < 1) text = "r is drawn shorter by the part between the strokes";
        for (const DrawnSurface& surface : surfaces_) {
            if (surface.magnified == 1) continue;
            if (!text.empty()) text += "; ";
            text += "surface " + surface.letter + " is drawn " + fourDigits(surface.magnified) + " times as large";
        }
        return text;
    }
    [[nodiscard]] bool showsABack() const {
        return std::ranges::any_of(surfaces_, [&](const DrawnSurface& surface) { return !showsItsFront(surface); });
    }

private:
    [[nodiscard]] dvec2 onSheet(dvec2 metres) const { return offset_ + scale_ * dvec2(metres.x, -metres.y); }
    [[nodiscard]] dvec2 tip(const DrawnSurface& surface) const {
        return surface.centre + normalLength_ * view_.of(surface.patch->normalWorld);
    }
    [[nodiscard]] bool showsItsFront(const DrawnSurface& surface) const {
        return glm::dot(surface.patch->normalWorld, view_.towardViewerWorld) > 0;
    }

    void fit() {
        dvec2 low(1e300), high(-1e300);
        const auto include = [&](dvec2 place) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        };
        for (const DrawnSurface& surface : surfaces_) {
            for (const dvec2& corner : drawnCorners(*surface.patch, view_, surface.magnified, surface.centre))
                include(corner);
            include(tip(surface));
        }
        const dvec2 room = area_.size - 2.0 * kFigureMargin, size = high - low;
        scale_ = std::min(room.x / std::max(size.x, 1e-300), room.y / std::max(size.y, 1e-300));
        offset_ = area_.corner + 0.5 * area_.size - scale_ * dvec2(0.5, -0.5) * (low + high);
    }

    void drawSurface(drawing::Drawing& drawing, const DrawnSurface& surface) {
        std::vector<dvec2> corners;
        for (const dvec2& corner : drawnCorners(*surface.patch, view_, surface.magnified, surface.centre))
            corners.push_back(onSheet(corner));
        const bool front = showsItsFront(surface);
        drawing.path(corners, true, front ? surface.color : "#ffffff",
                     {front ? "#1a1a1a" : surface.color, front ? 2.5 : 4, !front});
        for (std::size_t i = 0; i < corners.size(); ++i)
            labels_.avoid(corners[i], corners[(i + 1) % corners.size()]);
    }

    void drawLine(drawing::Drawing& drawing) {
        const dvec2 from = onSheet(surfaces_[0].centre), to = onSheet(surfaces_[1].centre);
        drawing.line(from, to, kThick);
        labels_.avoid(from, to);
        if (view_.distanceShare == 1) return;
        drawing.breakMark(glm::mix(from, to, 0.5), to - from, kThick);
        labels_.avoid({glm::mix(from, to, 0.5) - 16.0, dvec2(32)});
    }

    /// The arc from the normal to r, in the plane of both, as that plane is seen.
    void drawAngle(drawing::Drawing& drawing, const DrawnSurface& surface) {
        const dvec3 &n = surface.patch->normalWorld, &r = surface.toOtherWorld;
        const double phi = surface.phi();
        const double radius = kArcShare * std::min(normalLength_, 0.5 * view_.distanceShare * distance_);
        std::vector<dvec2> arc;
        if (std::sin(phi) < 1e-3) return; // the normal lies on r
        for (int i = 0; i <= kArcPieces; ++i) {
            const double t = phi * i / kArcPieces;
            const dvec3 way = (std::sin(phi - t) * n + std::sin(t) * r) / std::sin(phi); // turned from n by t
            arc.push_back(onSheet(surface.centre + radius * view_.of(way)));
            if (i > 0 && i % kAvoided == 0) labels_.avoid(arc[arc.size() - 1 - kAvoided], arc.back());
        }
        drawing.path(arc, false, "", kThin);
    }

    void drawNormal(drawing::Drawing& drawing, const DrawnSurface& surface) {
        const dvec2 from = onSheet(surface.centre), to = onSheet(tip(surface));
        drawing.arrow(from, to, kThick);
        drawing.circle(from, 6, "#1a1a1a", {"#ffffff", 1.5, false});
        labels_.avoid(from, to);
    }

    void label(drawing::Drawing& drawing) {
        const drawing::TextStyle letter{.size = kLabel};
        for (const DrawnSurface& surface : surfaces_) {
            labels_.place(drawing, onSheet(tip(surface)), "$\\mathbf{N}_" + surface.letter + "$", letter, 8);
            const double radius = kArcShare * std::min(normalLength_, 0.5 * view_.distanceShare * distance_);
            const dvec3 middle = glm::normalize(surface.patch->normalWorld + (1 + 1e-9) * surface.toOtherWorld);
            labels_.place(drawing, onSheet(surface.centre + radius * view_.of(middle)),
                          "$\\phi_" + surface.letter + "$ = " + degreesText(surface.phi()), letter, 10);
        }
        labels_.place(drawing, onSheet(0.5 * (surfaces_[0].centre + surfaces_[1].centre)),
                      "$r$ = " + fourDigits(distance_) + " m", letter, view_.distanceShare < 1 ? 18 : 8);
        for (const DrawnSurface& surface : surfaces_) {
            // At the corner that lies farthest from the other surface.
            const DrawnSurface& other = surfaces_[&surface == surfaces_.data() ? 1 : 0];
            const std::vector<dvec2> corners = drawnCorners(*surface.patch, view_, surface.magnified, surface.centre);
            const dvec2 corner = std::ranges::max(
                corners, {}, [&](dvec2 place) { return glm::dot(place, surface.centre - other.centre); });
            labels_.place(drawing, onSheet(corner),
                          "Surface $" + surface.letter + "$, $dA_" + surface.letter + "$ = " +
                              fourDigits(surface.patch->area) + " m\u00b2",
                          letter, 8);
        }
    }

    PatchView view_;
    drawing::Labels labels_;
    drawing::Box area_;
    std::array<DrawnSurface, 2> surfaces_;
    double distance_ = 0, normalLength_ = 0, scale_ = 1; ///< metres; pixels for each
    dvec2 offset_{0.0};
};

} // namespace

void drawFormFactor(drawing::Drawing& drawing, const drawing::Box& area, const PatchExchange& exchange, const image::Font& font) {
    drawing.text(area.corner + dvec2(0, kHeading), "Form factor: the share of the light of j that reaches k",
                 {.size = kHeading, .isBold = true});
    const double below = 1.4 * kText;
    const bool hasNumbers = area.size.x > kFigureWidth + kGap + kLeastNumbers;
    FormFactorDrawing figure(exchange,
                             {area.corner + dvec2(0, 1.5 * kHeading),
                              {hasNumbers ? kFigureWidth : area.size.x, area.size.y - 1.5 * kHeading - 2 * below}},
                             font);
    figure.draw(drawing);
    const dvec2 foot = area.corner + dvec2(0, area.size.y - 8);
    const drawing::TextStyle small{.size = kText, .color = "#4d4d4d"};
    if (!figure.liberties().empty()) drawing.text(foot - dvec2(0, below), figure.liberties(), small);
    if (figure.showsABack() && hasNumbers) drawing.text(foot, "white with a dashed rim: seen from behind", small);
    if (!hasNumbers) {
        drawing::drawProse(drawing, foot, oneLine(exchange), {.size = kText}, {font, font});
        return;
    }
    writeFormFactor(drawing,
                    {area.corner + dvec2(kFigureWidth + kGap, 0), {area.size.x - kFigureWidth - kGap, area.size.y}},
                    exchange, font);
}

} // namespace shadowlab::figures
