// Exercises about projecting points onto a plane, and about what of it lies in shadow then.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/course/exercises/asked_scene.h"
#include "app/course/exercises/kinds.h"
#include "app/course/exercises/squared_paper.h"
#include "app/drawing/labels.h"
#include "app/judge/truth.h"

namespace shadowlab::course {

namespace {

/// Blinn's formula: v' = (p.l) v - (p.v) l, with the plane p = (N, D), and point and lamp homogeneous.
dvec3 flattened(const dvec4& plane, const dvec3& lamp, const dvec3& point) {
    const dvec4 v(point, 1), l(lamp, 1), image = glm::dot(plane, l) * v - glm::dot(plane, v) * l;
    return dvec3(image) / image.w;
}

/// In pixels, where the name of a point stands beside it: clear of the plate's outline and of the word "plate", in a figure whose y goes
/// down. The last of six places where none is.
dvec2 clearOffset(dvec2 place, const drawing::Box& plate, dvec2 plateLabel) {
    // A capital letter of the label's size, and five small ones around the middle of their baseline.
    constexpr double kLetter = SquaredPaper::kLabel / SquaredPaper::kSquare, kMargin = 0.08;
    const drawing::Box word{plateLabel - dvec2(1.6, 0.8) * kLetter, dvec2(3.2, 1.1) * kLetter};
    dvec2 offset;
    for (const dvec2 tried :
         {dvec2(12, -12), dvec2(-12, -12), dvec2(12, 31), dvec2(-12, 31), dvec2(16, 10), dvec2(-16, 10)}) {
        offset = tried;
        const dvec2 start = place + offset / SquaredPaper::kSquare - dvec2(offset.x < 0 ? 0.7 * kLetter : 0, 0);
        const drawing::Box letter{start - dvec2(kMargin, 0.75 * kLetter + kMargin),
                                  dvec2(0.7, 0.75) * kLetter + 2 * kMargin};
        const bool isInside = glm::all(glm::greaterThan(letter.corner, plate.corner)) &&
                              glm::all(glm::lessThan(letter.corner + letter.size, plate.corner + plate.size));
        if ((isInside || !letter.overlaps(plate)) && !letter.overlaps(word)) break;
    }
    return offset;
}

} // namespace

Exercise askForProjection(Chance& chance) {
    // The shadow of a point at the height h_P is h_L / (h_L - h_P) times as far from the lamp as the point; for these it is a short number.
    struct Heights {
        int lamp, point;
    };
    const auto [lampHeight, pointHeight] = chance.oneOf(std::vector<Heights>{{4, 2},
                                                                             {6, 2},
                                                                             {6, 3},
                                                                             {6, 4},
                                                                             {8, 4},
                                                                             {8, 6},
                                                                             {5, 1},
                                                                             {5, 4},
                                                                             {10, 5},
                                                                             {10, 6},
                                                                             {10, 8},
                                                                             {9, 3},
                                                                             {9, 6},
                                                                             {12, 4}});
    const dvec3 lamp(chance.between(-5, 5), lampHeight, chance.between(-5, 5));
    const dvec3 offset(chance.sign() * chance.between(1, 4), 0, chance.sign() * chance.between(1, 4));
    const dvec3 point = dvec3(lamp.x, pointHeight, lamp.z) + offset;
    const dvec3 shadow = flattened({0, 1, 0, 0}, lamp, point);
    const double factor = double(lampHeight) / (lampHeight - pointHeight);
    const int side = chance.between(1, 4);

    Exercise exercise;
    exercise.given = "A lamp stands at $P_L$ = " + printed(lamp) +
                     ". The floor is the plane y = 0. The point P = " + printed(point) +
                     " is a corner of a square plate of " + std::to_string(side) + " m by " + std::to_string(side) +
                     " m that hangs parallel to the floor.";
    exercise.questions = {"Where does the shadow $P'$ of P fall on the floor?",
                          "What is the area of the shadow of the whole plate?"};
    exercise.answers = {"$P'$ = " + printed(shadow), printed(side * side * factor * factor) + " m²"};
    exercise.working = "The height above the floor is y. From the lamp to P the line sinks by " +
                       std::to_string(lampHeight - pointHeight) + " m of " + std::to_string(lampHeight) +
                       " m, so $P'$ = $P_L$ + " + printed(factor) + " (P - $P_L$). The plate's shadow is " +
                       printed(factor) + " times as wide and as long as the plate.";
    exercise.mistake = "The factor belongs to the way from the lamp: " + printed(factor) +
                       " P is not the shadow. And an area grows with the square.";
    addVector(exercise.data, "lamp", lamp);
    addVector(exercise.data, "P", point);
    exercise.data.push_back({"side", double(side)});
    addVector(exercise.results, "shadow", shadow);
    exercise.results.push_back({"area", side * side * factor * factor});
    return exercise;
}

Exercise askForPlaneHeights(Chance& chance) {
    // Unit normals with three short numbers; heights are then multiples of the last digit.
    const dvec3 normal = chance.oneOf(std::vector<dvec3>{
        {0.6, 0.8, 0}, {-0.6, 0.8, 0}, {0, 0.8, 0.6}, {0, 0.6, -0.8}, {0.8, 0.6, 0}, {-0.8, 0.6, 0}});
    const int level = chance.between(-3, 3);
    const auto height = [&](const dvec3& p) { return glm::dot(normal, p) + level; };
    const auto place = [&] { return dvec3(chance.between(-6, 6), chance.between(-6, 8), chance.between(-6, 6)); };
    dvec3 lamp, between, beyond, below;
    do // a lamp well above the plane, and three points of three kinds, none of them near a limit
        lamp = place();
    while (height(lamp) < 3 || height(lamp) > 5); // some place is higher than that, for every plane
    do
        between = place();
    while (height(between) < 0.5 || height(between) > height(lamp) - 0.5);
    do
        beyond = place();
    while (height(beyond) < height(lamp) + 0.5);
    do
        below = place();
    while (height(below) > -0.5);
    std::vector<dvec3> points{between, beyond, below};
    chance.shuffle(points);
    const char* const names = "ABC";

    Exercise exercise;
    exercise.given = "A plane is $\\mathbf{N} \\cdot P + D = 0$ with $\\mathbf{N}$ = " + printed(normal) +
                     " and D = " + std::to_string(level) + ". A lamp stands at $P_L$ = " + printed(lamp) +
                     ". Three points are A = " + printed(points[0]) + ", B = " + printed(points[1]) +
                     " and C = " + printed(points[2]) + ".";
    exercise.questions = {"How high above the plane are the lamp and the three points?",
                          "Which of the three can throw a shadow on the plane, and why not the others?"};
    std::string heights = "lamp " + printed(height(lamp)) + " m", caster, others;
    addVector(exercise.data, "N", normal);
    exercise.data.push_back({"D", double(level)});
    addVector(exercise.data, "lamp", lamp);
    exercise.results = {{"lamp", height(lamp)}};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string name(1, names[i]);
        const double above = height(points[i]);
        heights += ", " + name + " " + printed(above) + " m";
        if (above > 0 && above < height(lamp))
            caster = "Only " + name + ", which lies between the plane and the lamp: 0 < " + printed(above) + " < " +
                     printed(height(lamp)) + ".";
        else
            others += " " + name +
                      (above < 0 ? " lies below the plane."
                                 : " is higher than the lamp: its image would be a false shadow (an anti-shadow).");
        addVector(exercise.data, name, points[i]);
        exercise.results.push_back({name, above});
    }
    exercise.answers = {heights, caster + others};
    exercise.working = "$\\mathbf{N}$ is a unit vector, so $\\mathbf{N} \\cdot P + D$ is the distance from the plane, "
                       "positive on the lamp's side. A point throws a "
                       "shadow if its height is between 0 and that of the lamp.";
    exercise.mistake =
        "The matrix gives an image of every point. That of a point higher than the lamp has a negative w.";
    return exercise;
}

Exercise askForShadowedPixels(Chance& chance) {
    constexpr ivec2 kPicture{10, 6}; // pixels of one metre
    // Edges of the shadow lie on borders of pixels: half a pixel from all centres.
    const int factor = chance.oneOf(std::vector<int>{2, 4});
    const int lampHeight = 8, plateHeight = lampHeight - lampHeight / factor;
    dvec2 lamp, from, to, lower, upper;
    do {
        lamp = {chance.between(2, 8), chance.between(1, 5)};
        from = {chance.between(-1, 5), chance.between(-1, 2)};
        to = from + dvec2(chance.between(3, 5), chance.between(2, 4));
        lower = lamp + (from - lamp) / double(factor), upper = lamp + (to - lamp) / double(factor);
    } while (to.x > 11 || to.y > 7);
    // Seen from straight above, from so far that the picture is the floor. The near plane cuts the plate away: it only throws its shadow.
    const dvec3 middle(kPicture.x / 2.0, 0, kPicture.y / 2.0);
    const dvec2 centre = 0.5 * (lower + upper), size = upper - lower;
    scene::Scene seen =
        *sceneFromText(sceneText(pointLightText({lamp.x, lampHeight, lamp.y}), middle + dvec3(0, 100, 1e-3), middle,
                                 plateText("plate", {centre.x, plateHeight, centre.y}, size)));
    seen.camera.positionWorld = middle + dvec3(0, 100, 0);
    seen.camera.upWorld = {0, 0, -1};
    seen.camera.near = 99.9;
    seen.camera.fovYDegrees = glm::degrees(2 * std::atan(0.5 * kPicture.y / 100.0));
    const auto snapshot = std::make_shared<const scene::Scene>(seen);
    const judge::Truth truth = judge::truthAtCentres(tracerOf(snapshot), seen.camera, kPicture, 0);
    const auto isDark = [&](int x, int y) {
        return truth.visibility[truth.index(x, y)] == trace::Visibility::shadowed;
    };
    int dark = 0;
    ivec2 first(kPicture), last(-1);
    for (int y = 0; y < kPicture.y; ++y)
        for (int x = 0; x < kPicture.x; ++x)
            if (isDark(x, y)) ++dark, first = glm::min(first, ivec2(x, y)), last = glm::max(last, ivec2(x, y));
    const int askedX = chance.between(0, kPicture.x - 1), askedY = chance.between(0, kPicture.y - 1);

    Exercise exercise;
    exercise.given = "The picture of " + std::to_string(kPicture.x) + " x " + std::to_string(kPicture.y) +
                     " pixels, the thick frame on the squared paper, shows a floor from straight above, one metre to a "
                     "pixel. Pixel (x, y) has its centre at "
                     "(x + 0.5, y + 0.5). A lamp stands " +
                     std::to_string(lampHeight) + " m above the point L. A plate hangs level, " +
                     std::to_string(plateHeight) + " m above the floor, over the rectangle from (" + printed(lower.x) +
                     ", " + printed(lower.y) + ") to (" + printed(upper.x) + ", " + printed(upper.y) +
                     "). Its outline is drawn in; the camera sees the floor alone.";
    exercise.questions = {"Draw the border of the plate's shadow. From where to where does it reach?",
                          "How many pixels of the picture are in shadow, by their centres?",
                          "Is pixel (" + std::to_string(askedX) + ", " + std::to_string(askedY) + ") in shadow?"};
    const bool asked = isDark(askedX, askedY);
    exercise.answers = {
        "from (" + printed(from.x) + ", " + printed(from.y) + ") to (" + printed(to.x) + ", " + printed(to.y) + ")",
        std::to_string(dark) + " pixels: x from " + std::to_string(first.x) + " to " + std::to_string(last.x) +
            ", y from " + std::to_string(first.y) + " to " + std::to_string(last.y),
        asked ? "It is in shadow." : "It is lit."};
    exercise.working = "The floor is " + std::to_string(factor) +
                       " times as far below the lamp as the plate, so each corner moves away from L to " +
                       std::to_string(factor) + " times its distance.";
    exercise.mistake = "A pixel is in shadow if its centre is, not if the shadow touches it. What lies outside of the "
                       "picture is not counted.";
    // The shadow may reach beyond the picture by a metre, and is drawn whole.
    SquaredPaper paper({-1, -1}, kPicture + 1, "x", "y", true);
    paper.drawing().rectangle(paper.at({0, 0}), SquaredPaper::kSquare * dvec2(kPicture), "", {"#1a1a1a", 5});
    paper.box(glm::max(lower, dvec2(0)), glm::min(upper, dvec2(kPicture)), "");
    // Beside the plate on the side where L is not; small plates have no room for it.
    const double labelY = lamp.y > centre.y ? lower.y - 0.15 : std::min(upper.y + 0.5, kPicture.y - 0.15);
    const dvec2 plateLabel(glm::clamp(centre.x, 0.8, kPicture.x - 0.8), labelY);
    paper.label(plateLabel, "plate");
    paper.point(lamp, "L", "#e69f00", clearOffset(lamp, {lower, size}, plateLabel));
    exercise.figure = {paper.drawing(),
                       "A grid of pixels, a rectangle that is a plate seen from above, and the point L below the lamp"};
    exercise.data = {{"L.x", lamp.x},
                     {"L.y", lamp.y},
                     {"lampHeight", double(lampHeight)},
                     {"plateHeight", double(plateHeight)},
                     {"lower.x", lower.x},
                     {"lower.y", lower.y},
                     {"upper.x", upper.x},
                     {"upper.y", upper.y},
                     {"asked.x", double(askedX)},
                     {"asked.y", double(askedY)}};
    exercise.results = {{"dark", double(dark)}, {"asked", asked ? 1.0 : 0.0},
                        {"from.x", from.x},     {"from.y", from.y},
                        {"to.x", to.x},         {"to.y", to.y}};
    return exercise;
}

} // namespace shadowlab::course
