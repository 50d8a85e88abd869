// SPDX-License-Identifier: MIT
#include "app/report/page/technique_mark.h"

#include <array>
#include <cmath>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/registry.h"

namespace shadowlab::report {

namespace {

/// Okabe and Ito, "Color Universal Design" (2008): distinguishable with any kind of colour vision. Neighbours of one family
/// of techniques are far from each other in lightness, too.
constexpr std::array kColors{"#000000", "#e69f00", "#0072b2", "#56b4e9", "#009e73", "#f0e442", "#d55e00", "#cc79a7"};
constexpr int kShapes = 8;

/// A regular polygon, or a star where `inner` is less than one. `turn`: of its first corner from straight up, in corners.
std::vector<dvec2> polygon(dvec2 place, double radius, int corners, double turn, double inner = 1) {
    const int count = inner < 1 ? 2 * corners : corners;
    std::vector<dvec2> points;
    for (int i = 0; i < count; ++i) {
        const double angle = glm::two_pi<double>() * (static_cast<double>(i) / count + turn / corners);
        const double reach = i % 2 == 1 ? radius * inner : radius;
        points.push_back(place + reach * dvec2(std::sin(angle), -std::cos(angle)));
    }
    return points;
}

std::vector<dvec2> plus(dvec2 place, double radius) {
    constexpr double kHalfArm = 0.36; // of its length: bold enough to show a colour
    const double a = radius, b = kHalfArm * radius;
    std::vector<dvec2> points;
    for (const dvec2 corner : std::array<dvec2, 12>{{{-b, -a},
                                                     {b, -a},
                                                     {b, -b},
                                                     {a, -b},
                                                     {a, b},
                                                     {b, b},
                                                     {b, a},
                                                     {-b, a},
                                                     {-b, b},
                                                     {-a, b},
                                                     {-a, -b},
                                                     {-b, -b}}})
        points.push_back(place + corner);
    return points;
}

} // namespace

std::map<std::string, TechniqueMark> marksOf(const Group& group) {
    std::map<std::string, int> places;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production))
        places.emplace(technique.info->id, static_cast<int>(places.size()));
    std::map<std::string, TechniqueMark> marks;
    for (const Point& point : group.points) {
        const int place = places.emplace(point.key.technique, static_cast<int>(places.size())).first->second;
        const int color = (place + place / kShapes) % static_cast<int>(kColors.size());
        marks[point.key.technique] = {kColors[static_cast<std::size_t>(color)], place % kShapes};
    }
    return marks;
}

void drawMark(drawing::Drawing& drawing, dvec2 place, const TechniqueMark& mark, double radius, bool isOpen) {
    // The rim keeps yellow legible on white; printed in black, the shapes distinguish the marks.
    const drawing::Stroke rim = isOpen ? drawing::Stroke{mark.color, 3, false} : drawing::Stroke{"#1a1a1a", 1.5, false};
    const std::string fill = isOpen ? "#ffffff" : mark.color;
    switch (mark.shape) {
    case 1: drawing.path(polygon(place, radius, 4, 0.5), true, fill, rim); break;
    case 2: drawing.path(polygon(place, radius, 3, 0), true, fill, rim); break;
    case 3: drawing.path(polygon(place, radius, 4, 0), true, fill, rim); break;
    case 4: drawing.path(polygon(place, radius, 3, 0.5), true, fill, rim); break;
    case 5: drawing.path(plus(place, radius), true, fill, rim); break;
    case 6: drawing.path(polygon(place, radius, 5, 0), true, fill, rim); break;
    case 7: drawing.path(polygon(place, radius, 5, 0, 0.45), true, fill, rim); break;
    default: drawing.circle(place, 0.85 * radius, fill, rim); break; // a circle looks larger than what has corners
    }
}

} // namespace shadowlab::report
