// Exercises about shadow maps: the two depths that are compared, and the place of a point in the map.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "app/course/exercises/asked_scene.h"
#include "app/course/exercises/kinds.h"
#include "app/course/exercises/squared_paper.h"
#include "app/figures/inks.h"

namespace shadowlab::course {

namespace {

/// What the map's camera sees toward a point: clip space from world space, looking straight down from a height, columns along +x
/// and rows along -z. `cotangent`: of half its angle.
dmat4 lightClipFromWorldAt(double height, double cotangent) {
    const dvec3 lamp(0, height, 0);
    const double fovY = 2 * std::atan(1 / cotangent);
    return glm::perspective(fovY, 1.0, 0.1, 2 * height) * glm::lookAt(lamp, dvec3(0), dvec3(0, 0, -1));
}

} // namespace

Exercise askForMapDepths(Chance& chance) {
    const int lampHeight = chance.between(6, 8), plateHeight = chance.between(2, lampHeight - 3);
    const int from = chance.between(-3, -1), to = chance.between(1, 3);
    const double stretch = double(lampHeight) / (lampHeight - plateHeight);
    // Two points of the floor, half a metre from the ends of the shadow or more: one beneath the plate's shadow and one beside it.
    std::vector<double> points;
    const auto isClear = [&](double x) {
        return std::abs(x - from * stretch) >= 0.5 && std::abs(x - to * stretch) >= 0.5;
    };
    const auto isWithin = [&](double x) { return x > from * stretch && x < to * stretch; };
    for (const bool within : {true, false}) {
        double x = 0;
        do
            x = chance.between(-9, 9);
        while (!isClear(x) || isWithin(x) != within);
        points.push_back(x);
    }
    if (chance.coin()) std::swap(points[0], points[1]);

    Exercise exercise;
    exercise.given = "The section shows a lamp, a plate that is long at right angles to the paper, and the floor. The "
                     "camera of the shadow map is at the lamp and "
                     "looks straight down.";
    exercise.questions = {"Which depth $d(u,v)$ does the map hold in the direction of A, and which depth $z(u,v)$ has "
                          "A itself? Is A lit?",
                          "The same for B."};
    exercise.data = {{"lampHeight", double(lampHeight)},
                     {"plateHeight", double(plateHeight)},
                     {"from", double(from)},
                     {"to", double(to)},
                     {"A", points[0]},
                     {"B", points[1]}};
    SquaredPaper paper({-10, 0}, {10, 9}, "x", "y");
    const std::string plate = plateText("plate", {0.5 * (from + to), plateHeight, 0.5}, {to - from, 41});
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string name(1, "AB"[i]);
        const scene::Snapshot scene = sceneFromText(
            sceneText(pointLightText({0, lampHeight, 0}), {points[i] + 0.5, 1, 12}, {points[i], 0, 0}, plate));
        const trace::SceneTracer tracer = tracerOf(scene);
        const trace::SurfacePoint point = middlePoint(tracer);
        const auto blocked = tracer.blockedAtWorld(point, 0);
        const double z = lampHeight - tracer.positionWorld(point).y, d = blocked ? lampHeight - blocked->y : z;
        exercise.answers.push_back("$d(u,v)$ = " + printed(d) + " m, $z(u,v)$ = " + printed(z) +
                                   " m: " + (blocked ? name + " is in shadow" : name + " is lit"));
        exercise.results.insert(exercise.results.end(),
                                {{name + ".d", d}, {name + ".z", z}, {name + ".lit", blocked ? 0.0 : 1.0}});
    }
    exercise.working = "The line from the lamp to a point at x crosses the height of the plate at " +
                       printed(1 / stretch) + " x. Depths are counted along the camera's axis, so the plate is at " +
                       std::to_string(lampHeight - plateHeight) + " m and the floor at " + std::to_string(lampHeight) +
                       " m, wherever the line goes.";
    exercise.mistake = "The length of the ray is not the depth.";
    paper.line({-10, 0}, {10, 0}, {"#1a1a1a", 4});
    paper.line({from, plateHeight}, {to, plateHeight}, {"#1a1a1a", 6});
    paper.point({0, lampHeight}, "lamp", "#e69f00");
    paper.point({points[0], 0}, "A", figures::ink::kAsked, {8, -14});
    paper.point({points[1], 0}, "B", figures::ink::kAsked, {8, -14});
    exercise.figure = {
        paper.drawing(),
        "Section on squared paper: a lamp above a plate above the floor, and two points A and B of the floor"};
    return exercise;
}

Exercise askForTexel(Chance& chance) {
    const int resolution = chance.oneOf(std::vector<int>{8, 10}), height = chance.oneOf(std::vector<int>{4, 8}),
              cotangent = chance.oneOf(std::vector<int>{1, 2});
    const double reach = double(height) / cotangent, texel = 2 * reach / resolution; // metres on the floor
    const ivec2 chosen(chance.between(0, resolution - 1), chance.between(0, resolution - 1));
    // A fifth of a texel from its border or more.
    const dvec2 within(chance.oneOf(std::vector<double>{0.25, 0.5, 0.75}),
                       chance.oneOf(std::vector<double>{0.25, 0.75}));
    const dvec2 place = (dvec2(chosen) + within) * texel - reach; // x, and -z
    const dvec3 point(place.x, 0, -place.y);
    const dvec4 clip = lightClipFromWorldAt(height, cotangent) * dvec4(point, 1);
    const dvec2 uv = 0.5 * (dvec2(clip) / clip.w + 1.0);
    const ivec2 found = ivec2(glm::floor(uv * double(resolution)));
    const int plateHeight = height / 2;

    Exercise exercise;
    exercise.given = "The camera of a shadow map is at (0, " + std::to_string(height) +
                     ", 0) and looks straight down on the floor y = 0. The first number of its projection "
                     "matrix, the cotangent of half its angle, is " +
                     std::to_string(cotangent) + ". The map has " + std::to_string(resolution) + " x " +
                     std::to_string(resolution) +
                     " texels. u grows with x, and v with -z, both from 0 to 1; texel (0, 0) is at u = v = 0. A point "
                     "of the floor is P = " +
                     printed(point) + ".";
    exercise.questions = {"How wide is the part of the floor that the map covers, and how wide is a texel there?",
                          "Find (u, v) of P, and its texel.",
                          "How wide is a texel on a plate at the height y = " + std::to_string(plateHeight) + "?"};
    exercise.answers = {printed(2 * reach) + " m, and " + printed(texel) + " m",
                        "(u, v) = (" + printed(uv.x) + ", " + printed(uv.y) + "), texel (" + std::to_string(found.x) +
                            ", " + std::to_string(found.y) + ")",
                        printed(texel * (height - plateHeight) / height) + " m"};
    exercise.working = "At the depth z the map is 2 z / " + std::to_string(cotangent) + " wide. u = (x + " +
                       printed(reach) + ") / " + printed(2 * reach) + ", v = (-z + " + printed(reach) + ") / " +
                       printed(2 * reach) + "; the texel is the whole part of " + std::to_string(resolution) +
                       " u and of " + std::to_string(resolution) + " v.";
    exercise.mistake =
        "Rounding to the nearest number in place of taking the whole part: texel i reaches from i to i + 1.";
    SquaredPaper map({0, 0}, dvec2(resolution), "column", "row");
    exercise.figure = {map.drawing(), "The texels of the map, numbered by columns and rows"};
    exercise.data = {{"height", double(height)},
                     {"cotangent", double(cotangent)},
                     {"resolution", double(resolution)},
                     {"P.x", point.x},
                     {"P.z", point.z},
                     {"plateHeight", double(plateHeight)}};
    exercise.results = {{"covered", 2 * reach},
                        {"texel", texel},
                        {"u", uv.x},
                        {"v", uv.y},
                        {"column", double(found.x)},
                        {"row", double(found.y)},
                        {"onPlate", texel * (height - plateHeight) / height}};
    return exercise;
}

} // namespace shadowlab::course
