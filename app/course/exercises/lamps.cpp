// Exercises about lamps with an area.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/course/exercises/asked_scene.h"
#include "app/course/exercises/kinds.h"
#include "app/course/exercises/squared_paper.h"
#include "techniques/foundation/trace/area/area_visibility.h"

namespace shadowlab::course {

Exercise askForPenumbra(Chance& chance) {
    struct Heights {
        int lamp, plate;
    };
    const auto [lampHeight, plateHeight] =
        chance.oneOf(std::vector<Heights>{{4, 2}, {6, 3}, {8, 4}, {6, 2}, {6, 4}, {8, 2}, {8, 6}});
    const int lampWidth = chance.oneOf(std::vector<int>{1, 2}), edge = chance.between(0, 3);
    const double ratio = double(plateHeight) / (lampHeight - plateHeight), width = lampWidth * ratio;
    // The penumbra is centred on where the lamp's middle sees the edge. Tenths of its width from either end.
    const double middle = edge * (1 + ratio),
                 share = chance.oneOf(std::vector<double>{0.25, 0.5, 0.75, 0.2, 0.4, 0.6, 0.8});
    const double asked = middle + (share - 0.5) * width;

    // A rect that shines down, and a plate that goes on far to the left and along the lamp.
    const nlohmann::json lamp{
        {"name", "lamp"},     {"type", "rect"}, {"position", {0, lampHeight, 0}}, {"edgeU", {lampWidth, 0, 0}},
        {"edgeV", {0, 0, 1}}, {"intensity", 10}};
    const scene::Snapshot scene =
        sceneFromText(sceneText(lamp.dump(), {asked + 0.25, 0.5 * plateHeight, 0.75}, {asked, 0, 0},
                                plateText("plate", {edge - 500.0, plateHeight, 0.5}, {1000, 1000})));
    const trace::SceneTracer tracer = tracerOf(scene);
    const double seen = trace::AreaVisibility(tracer, 0).share(middlePoint(tracer));

    Exercise exercise;
    exercise.given = "The section shows a square lamp of " + std::to_string(lampWidth) + " m by " +
                     std::to_string(lampWidth) + " m, " + std::to_string(lampHeight) +
                     " m above the floor, with its middle at x = 0. A plate at the height " +
                     std::to_string(plateHeight) + " m ends at x = " + std::to_string(edge) +
                     "; to the left, and at right angles to the paper, it goes on without end.";
    exercise.questions = {"How wide is the penumbra of the plate's edge on the floor, by $w = w_L (d_r - d_b) / d_b$?",
                          "From where to where does it reach?",
                          "Which share of the lamp does the point x = " + printed(asked) + " of the floor see?"};
    exercise.answers = {"w = " + printed(width) + " m",
                        "from x = " + printed(middle - width / 2) + " to x = " + printed(middle + width / 2),
                        printed(seen)};
    exercise.working = "$d_r$ = " + std::to_string(lampHeight) +
                       " m, $d_b$ = " + std::to_string(lampHeight - plateHeight) +
                       " m. The penumbra lies between the lines from the two ends of the lamp through the plate's "
                       "edge. Within it the share grows evenly from 0 to 1.";
    exercise.mistake = "$d_b$ is counted from the lamp, not from the floor.";
    SquaredPaper paper({-4, 0}, {16, 9}, "x", "y");
    paper.line({-4, 0}, {16, 0}, {"#1a1a1a", 4});
    paper.line({-4, plateHeight}, {edge, plateHeight}, {"#1a1a1a", 6});
    paper.line({-0.5 * lampWidth, lampHeight}, {0.5 * lampWidth, lampHeight}, {"#e69f00", 8});
    paper.label({0.5 * lampWidth + 0.3, lampHeight + 0.2}, "lamp", drawing::Anchor::start);
    exercise.figure = {paper.drawing(),
                       "Section on squared paper: a lamp with an area, a plate that ends below it, and the floor"};
    exercise.data = {{"lampHeight", double(lampHeight)},
                     {"plateHeight", double(plateHeight)},
                     {"lampWidth", double(lampWidth)},
                     {"edge", double(edge)},
                     {"asked", asked}};
    exercise.results = {{"width", width}, {"from", middle - width / 2}, {"to", middle + width / 2}, {"share", seen}};
    return exercise;
}

} // namespace shadowlab::course
