// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "app/drawing/prose.h"
#include "app/figures/drawing_plane.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

constexpr double kMostUnit = 320;    ///< pixels of a vector of length one
constexpr double kArrives = 0.55;    ///< of a vector's length: u ends there, V is a little shorter
constexpr double kWide = 800;        ///< pixels
constexpr double kOutOfPlane = 0.05; ///< from which on a vector is said to leave the plane

drawing::Stroke strokeOf(const std::string& letter) {
    if (letter == "R") return figures::strokeOf(Probe::Role::reflection);
    if (letter == "T") return figures::strokeOf(Probe::Role::refraction);
    if (letter == "L") return {drawing::colorText(look::kEqualDepth), 4, false};
    if (letter == "H") return {drawing::colorText(look::kDepthFail), 4, false};
    if (letter == "N") return {"#4d4d4d", 4, false};
    return figures::strokeOf(Probe::Role::eye);
}

std::string meaning(const std::string& letter) {
    if (letter == "u") return "way of the incoming ray";
    if (letter == "V") return "to the viewer";
    if (letter == "N") return "normal";
    if (letter == "R") return "reflected ray";
    if (letter == "T") return "refracted ray";
    if (letter == "L") return "to the light";
    return letter == "H" ? "between L and V" : "";
}

std::string fixed(double value) {
    const double rounded = std::round(value * 1000) / 1000 + 0.0; // no "-0"
    std::string text = std::to_string(rounded);
    text.resize(text.find('.') + 4);
    return (value < 0 && rounded != 0 ? "\u2212" : "") + text.substr(text.starts_with('-') ? 1 : 0);
}

std::string degreesOfCosine(double cosine) {
    return std::to_string(std::lround(glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))))) + "\u00b0";
}

const Probe::Vector* find(const Probe& probe, const char* letter) {
    const auto found = std::ranges::find(probe.vectors, letter, &Probe::Vector::label);
    return found == probe.vectors.end() ? nullptr : &*found;
}

bool isOutOf(const DrawingPlane& plane, const dvec3& directionWorld) {
    return std::abs(glm::dot(directionWorld, plane.normalWorld())) > kOutOfPlane;
}

/// What the ray of that kind brings back to the first surface.
std::string brought(const Probe& probe, Probe::Role role, const char* name) {
    for (const Probe::Node& node : probe.tree)
        if (node.parent == 0 && node.role == role && node.segment >= 0)
            return std::string(", ") + name + " = " + colorNumbers(node.intensity);
    return "";
}

void drawPlaneOfVectors(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const DrawingPlane& plane,
                        const image::Font& font) {
    // Below an opaque surface there is nothing to see.
    const double above = find(probe, "T") ? 0.5 * area.size.y : area.size.y - 2 * kHeading;
    const dvec2 at = area.corner + dvec2(0.5 * area.size.x, above);
    const double unit = std::min(kMostUnit, above - kHeading);
    drawing::Labels labels(font, area);
    drawing.line(at - dvec2(area.size.x / 2 - 10, 0), at + dvec2(area.size.x / 2 - 10, 0), {"#8c8c8c", 4, false});
    labels.avoid(at - dvec2(area.size.x / 2, 0), at + dvec2(area.size.x / 2, 0));
    struct Tip {
        std::string letter;
        dvec2 at;
    };
    std::vector<Tip> tips;
    for (const Probe::Vector& vector : probe.vectors) {
        const dvec2 flat = plane.ofDirection(vector.directionWorld);
        const dvec2 onSheet = unit * dvec2(flat.x, -flat.y);
        drawing::Stroke stroke = strokeOf(vector.label);
        stroke.isDashed = isOutOf(plane, vector.directionWorld);
        // u arrives on the line that V leaves on: each has a half of it to be seen on.
        dvec2 from = at, to = at + onSheet, tip = to;
        if (vector.label == "u") {
            from = at - onSheet;
            to = at - kArrives * onSheet;
            tip = glm::mix(from, to, 0.4);
        } else if (vector.label == "V") {
            to = at + 0.9 * kArrives * onSheet;
            tip = glm::mix(from, to, 0.8);
        }
        drawing.arrow(from, to, stroke);
        labels.avoid(at, vector.label == "u" ? from : to);
        tips.push_back({vector.label, tip});
    }
    drawing.circle(at, 7, "#1a1a1a", {"#ffffff", 1.5, false});
    labels.avoid({at - 8.0, dvec2(16)});
    for (const Tip& tip : tips)
        labels.place(drawing, tip.at, tip.letter, {.size = area.size.x >= kWide ? drawing::kLetter : kHeading, .isBold = true}, 8);
    labels.place(drawing, at + dvec2(0, 6), "S1", {.size = kText, .isBold = true}, 12);
}

} // namespace

void drawVectors(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const image::Font& font) {
    const Probe::Node& root = probe.tree.front();
    drawing.text(area.corner + dvec2(0, kHeading), "Vectors at S1, " + root.object, {.size = kHeading, .isBold = true});
    const DrawingPlane plane = planeWithNormalUp(probe);
    // Beside the tree of a whole slide there is less room.
    const double em = area.size.x >= kWide ? kText : 0.92 * kText;
    const double row = kText * 1.25, tableHeight = row * static_cast<double>(probe.vectors.size()) + 2 * row + 8;
    const drawing::Box figure{area.corner + dvec2(0, kHeading + 8), {area.size.x, area.size.y - kHeading - 8 - tableHeight - 4}};
    drawPlaneOfVectors(drawing, figure, probe, plane, font);
    double y = area.corner.y + area.size.y - tableHeight + row;
    bool leaves = false;
    for (const Probe::Vector& vector : probe.vectors) {
        const double x = area.corner.x;
        drawing.line({x, y - 8}, {x + 34, y - 8}, strokeOf(vector.label));
        drawing.text({x + 46, y}, vector.label, {.size = kText, .isBold = true});
        std::string words = meaning(vector.label);
        if (vector.label == "R") words += brought(probe, Probe::Role::reflection, "$I_R$");
        if (vector.label == "T") words += brought(probe, Probe::Role::refraction, "$I_T$");
        drawing::drawProse(drawing, {x + 80, y}, words, {.size = em}, {font, font});
        for (int axis = 0; axis < 3; ++axis)
            drawing.text({area.corner.x + area.size.x - 210 + 105 * axis, y}, fixed(vector.directionWorld[axis]),
                         {.size = em, .anchor = drawing::Anchor::end});
        leaves = leaves || isOutOf(plane, vector.directionWorld);
        y += row;
    }
    const Probe::Vector *v = find(probe, "V"), *n = find(probe, "N"), *t = find(probe, "T");
    std::string angles;
    if (v && n) angles = "angle of incidence " + degreesOfCosine(glm::dot(v->directionWorld, n->directionWorld));
    if (t && n) angles += ", of refraction " + degreesOfCosine(-glm::dot(t->directionWorld, n->directionWorld));
    drawing.text({area.corner.x, y + 4}, angles, {.size = em});
    if (leaves)
        drawing.text({area.corner.x, y + 4 + row}, "dashed: not in the plane of the others",
                     {.size = em, .color = "#4d4d4d"});
}

} // namespace shadowlab::figures
