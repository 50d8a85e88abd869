// Exercises about shadow volumes: faces counted along the eye's line, and how far corners have to be pushed.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/course/exercises/asked_scene.h"
#include "app/course/exercises/kinds.h"
#include "app/course/exercises/squared_paper.h"
#include "app/figures/inks.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::course {

namespace {

/// A box of the section: it is long at right angles to the paper.
struct SectionBox {
    dvec2 lower, upper;
};

constexpr dvec2 kPaperLower{-10, -5}, kPaperUpper{10, 10};
constexpr double kApart = 0.35; ///< metres between places on the eye's line: some two millimetres on paper

/// Does the line cross all faces on the paper, but for those at infinity, and so far from one another, from the point and from the eye
/// that a drawing by hand tells them apart?
bool isClear(const VolumeProbe& volumes, dvec2 eye, dvec2 way, double toPoint) {
    double before = 0;
    for (const VolumeProbe::Crossing& crossing : volumes.crossings) {
        if (std::isinf(crossing.distance)) { // a side there is one that the line is parallel to
            if (crossing.part != VolumeProbe::Part::bottomCap || crossing.sign > 0) return false;
            continue;
        }
        const dvec2 place = eye + crossing.distance * way;
        if (glm::any(glm::lessThan(place, kPaperLower + 0.2)) || glm::any(glm::greaterThan(place, kPaperUpper - 0.2)))
            return false;
        if (crossing.distance - before < kApart || std::abs(crossing.distance - toPoint) < kApart) return false;
        before = crossing.distance;
    }
    return true;
}

struct CountScene {
    dvec2 lamp, eye;
    double point; ///< x of a place of the floor
    std::vector<SectionBox> boxes;
};

/// Boxes beside each other in the air, the lamp above them, the eye to one side. Nothing touches.
std::optional<CountScene> randomSection(Chance& chance) {
    CountScene scene{
        {chance.between(-4, 4), 9}, {chance.between(-9, 9), chance.between(2, 6)}, double(chance.between(-8, 8)), {}};
    const int count = chance.between(2, 3);
    int x = chance.between(-7, -4);
    for (int i = 0; i < count; ++i) {
        const dvec2 lower(x, chance.between(1, 5)), size(chance.between(1, 2), chance.between(1, 2));
        scene.boxes.push_back({lower, lower + size});
        x += static_cast<int>(size.x) + chance.between(2, 3);
    }
    if (std::abs(scene.eye.x - scene.point) < 3) return std::nullopt;
    for (const SectionBox& box : scene.boxes) {
        const dvec2 margin(0.5);
        const auto isIn = [&](dvec2 p) {
            return glm::all(glm::greaterThan(p, box.lower - margin)) && glm::all(glm::lessThan(p, box.upper + margin));
        };
        if (isIn(scene.eye)) return std::nullopt;
        // The lamp is not in line with a side of the box: it would see such a face edge-on.
        for (const double side : {box.lower.x, box.upper.x})
            if (std::abs(scene.lamp.x - side) < 0.5) return std::nullopt;
    }
    return scene;
}

/// Does a box stand between two places?
bool isBetween(const SectionBox& box, dvec2 from, dvec2 to) {
    const dvec2 a = (box.lower - from) / (to - from), b = (box.upper - from) / (to - from);
    const dvec2 enters = glm::min(a, b), leaves = glm::max(a, b);
    return std::max({enters.x, enters.y, 0.0}) <= std::min({leaves.x, leaves.y, 1.0});
}
bool isAnyBetween(const CountScene& section, dvec2 from, dvec2 to) {
    return std::ranges::any_of(section.boxes, [&](const SectionBox& box) { return isBetween(box, from, to); });
}

/// Is all around a place in the box's volume, or nothing? Else a pencil cannot tell whether the place is.
bool isSteady(const SectionBox& box, dvec2 lamp, dvec2 place) {
    const bool isIn = isBetween(box, lamp, place);
    const std::array<dvec2, 4> around{dvec2(kApart, 0), dvec2(-kApart, 0), dvec2(0, kApart), dvec2(0, -kApart)};
    return std::ranges::all_of(around, [&](dvec2 offset) { return isBetween(box, lamp, place + offset) == isIn; });
}

enum class Wanted { lit, shadowed, eyeInShadow };

/// A quick look along the eye's line, in steps of five centimetres, which spares the technique the sections that are not worth
/// being looked at. What is asked for is counted by the technique.
bool isPromising(const CountScene& section, Wanted wanted) {
    const dvec2 point(section.point, 0), way = glm::normalize(point - section.eye);
    const double toPoint = glm::distance(point, section.eye);
    if (isAnyBetween(section, section.eye, point)) return false;
    if (isAnyBetween(section, section.lamp, section.eye) != (wanted == Wanted::eyeInShadow)) return false;
    if (wanted != Wanted::eyeInShadow && isAnyBetween(section, section.lamp, point) != (wanted == Wanted::shadowed))
        return false;
    constexpr double kStep = 0.05, kFarthest = 60;
    std::vector<double> crossed{0.0, toPoint};
    for (const SectionBox& box : section.boxes) {
        if (!isSteady(box, section.lamp, section.eye) || !isSteady(box, section.lamp, point)) return false;
        bool isIn = isBetween(box, section.lamp, section.eye);
        for (double t = kStep; t < kFarthest; t += kStep) {
            const bool now = isBetween(box, section.lamp, section.eye + t * way);
            if (now != isIn) crossed.push_back(t);
            isIn = now;
        }
    }
    std::ranges::sort(crossed);
    for (std::size_t i = 1; i < crossed.size(); ++i)
        if (crossed[i] - crossed[i - 1] < kApart + kStep) return false;
    return wanted != Wanted::lit || (crossed.size() > 2 && crossed[1] < toPoint);
}

/// What the program counts; none where the asked point is hidden, or something is too close to call by hand.
std::optional<VolumeProbe> countedIn(const CountScene& section) {
    std::string objects;
    for (std::size_t i = 0; i < section.boxes.size();
         ++i) // not symmetrical, so that no diagonal of a face crosses the section
        objects += (i ? ",\n    " : "") + boxText("box " + std::to_string(i + 1), dvec3(section.boxes[i].lower, -17),
                                                  dvec3(section.boxes[i].upper, 23));
    const dvec3 eye(section.eye, 0), target(section.point, 0, 0);
    const scene::Snapshot scene = sceneFromText(sceneText(pointLightText({section.lamp, 0}), eye, target, objects));
    const trace::SceneTracer tracer = tracerOf(scene);
    if (const trace::SurfacePoint seen = middlePoint(tracer);
        !seen || glm::distance(tracer.positionWorld(seen), target) > 1e-6)
        return std::nullopt;
    const Probe probe = middleProbe(scene, "shadow-volume-zfail", {{"cull", "false"}, {"volume-end", "infinity"}});
    const VolumeProbe* const volumes = probe.find<VolumeProbe>();
    if (!volumes || !isClear(*volumes, section.eye, glm::normalize(dvec2(target - eye)), glm::distance(eye, target)))
        return std::nullopt;
    return *volumes;
}

} // namespace

Exercise askForFaceCounts(Chance& chance) {
    // Lit, in shadow, and seen by an eye that is itself in shadow, which most random sections are not.
    const auto wanted = static_cast<Wanted>(chance.between(0, 2));
    const auto isWanted = [&](const VolumeProbe& volumes) {
        const int inVolumes = volumes.backsBeyond - volumes.frontsBeyond,
                  crossed = volumes.frontsBefore + volumes.backsBefore;
        if (wanted == Wanted::eyeInShadow) return volumes.eyeCount > 0;
        return volumes.eyeCount == 0 && crossed > 0 && (inVolumes > 0) == (wanted == Wanted::shadowed);
    };
    std::optional<CountScene> section;
    std::optional<VolumeProbe> counted;
    while (!counted) {
        section = randomSection(chance);
        if (!section || !isPromising(*section, wanted)) continue;
        counted = countedIn(*section);
        if (counted && !isWanted(*counted)) counted.reset();
    }
    const int zPass = counted->frontsBefore - counted->backsBefore,
              zFail = counted->backsBeyond - counted->frontsBeyond;

    Exercise exercise;
    exercise.given = "The section shows a lamp, boxes that are long at right angles to the paper, the floor, and the "
                     "eye, which sees the point P of the floor. Only the boxes "
                     "throw shadows. Their volumes go on below the floor, without end; no face is crossed beyond the "
                     "paper but at infinity.";
    exercise.questions = {"Draw the shadow volumes and the eye's line, also beyond P. Find $n_f$ and $n_b$ between the "
                          "eye and P, and what z-pass counts.",
                          "Find $n_f$ and $n_b$ on the line beyond P, and what z-fail counts.",
                          "Is P in shadow? In how many volumes is the eye? What does a stencil of 8 bits hold after "
                          "z-pass, if it begins with 0?"};
    const auto counts = [](int fronts, int backs) {
        return "$n_f$ = " + std::to_string(fronts) + ", $n_b$ = " + std::to_string(backs);
    };
    exercise.answers = {
        counts(counted->frontsBefore, counted->backsBefore) + ": z-pass counts " + std::to_string(zPass),
        counts(counted->frontsBeyond, counted->backsBeyond) + ": z-fail counts " + std::to_string(zFail),
        std::string(zFail > 0 ? "P is in shadow" : "P is lit") + "; the eye is in " +
            std::to_string(counted->eyeCount) + (counted->eyeCount == 1 ? " volume" : " volumes") +
            "; the stencil holds " + std::to_string((zPass + 256) % 256)};
    exercise.working = "z-pass is $n_f - n_b$ before the point, z-fail $n_b - n_f$ beyond it. z-pass lacks the volumes "
                       "that the eye is in: " +
                       std::to_string(zPass) + " + " + std::to_string(counted->eyeCount) + " = " +
                       std::to_string(zFail) + ".";
    exercise.mistake =
        "The faces turned toward the lamp, its top caps, bound a volume as well: the line may enter through one.";
    SquaredPaper paper(kPaperLower, kPaperUpper, "x", "y");
    paper.line({-10, 0}, {10, 0}, {"#1a1a1a", 4});
    for (const SectionBox& box : section->boxes)
        paper.box(box.lower, box.upper, "#d9d9d9");
    paper.point(section->lamp, "lamp", "#e69f00");
    paper.point(section->eye, "eye", figures::ink::kEye, section->eye.x > 7 ? dvec2(-12, -12) : dvec2(12, -12));
    paper.point({section->point, 0}, "P", figures::ink::kAsked, {8, -14});
    exercise.figure = {paper.drawing(),
                       "Section on squared paper: a lamp, boxes in the air, the floor, the eye, and the point P"};
    exercise.data = {{"lamp.x", section->lamp.x},
                     {"lamp.y", section->lamp.y},
                     {"eye.x", section->eye.x},
                     {"eye.y", section->eye.y},
                     {"P", section->point}};
    for (std::size_t i = 0; i < section->boxes.size(); ++i) {
        const SectionBox& box = section->boxes[i];
        const std::string name = "box" + std::to_string(i);
        exercise.data.insert(exercise.data.end(), {{name + ".x0", box.lower.x},
                                                   {name + ".y0", box.lower.y},
                                                   {name + ".x1", box.upper.x},
                                                   {name + ".y1", box.upper.y}});
    }
    exercise.results = {{"frontsBefore", double(counted->frontsBefore)},
                        {"backsBefore", double(counted->backsBefore)},
                        {"frontsBeyond", double(counted->frontsBeyond)},
                        {"backsBeyond", double(counted->backsBeyond)},
                        {"eyeCount", double(counted->eyeCount)}};
    return exercise;
}

Exercise askForExtrusion(Chance& chance) {
    // Half sides of the plate and its distance below the lamp: the way from the lamp to a corner is a whole number.
    const dvec3 half = chance.oneOf(std::vector<dvec3>{{1, 2, 2},
                                                       {2, 1, 2},
                                                       {2, 2, 1},
                                                       {2, 3, 6},
                                                       {3, 2, 6},
                                                       {3, 6, 2},
                                                       {1, 4, 8},
                                                       {4, 1, 8},
                                                       {4, 4, 7},
                                                       {2, 4, 4},
                                                       {4, 2, 4}});
    const double down = half.z;
    const int multiple = chance.between(2, 4); // the floor is as many times as far below the lamp as the plate
    const double lampHeight = multiple * down, plateHeight = lampHeight - down;
    const dvec3 lamp(chance.between(-3, 3), lampHeight, chance.between(-3, 3)),
        corner = lamp + dvec3(half.x, -down, half.y);
    const dvec3 direction = glm::normalize(corner - lamp);
    const double least = corner.y / -direction.y, middle = plateHeight;

    Exercise exercise;
    exercise.given = "A lamp stands at $P_L$ = " + printed(lamp) + ", the floor is y = 0. A plate of " +
                     printed(2 * half.x) + " m (along x) by " + printed(2 * half.y) +
                     " m (along z) hangs level at the height " + printed(plateHeight) +
                     " m, its middle right below the lamp. Its shadow volume is made by pushing its corners "
                     "away from the lamp by a distance d.";
    exercise.questions = {"Which d is the least for which the volume reaches the floor?",
                          "Where is the pushed corner of the side of greatest x and z then?",
                          "The middle of the plate would need less. How much, and why does that not help?"};
    const dvec3 pushed = corner + least * direction;
    exercise.answers = {"d = " + printed(least) + " m", printed(pushed),
                        printed(middle) + " m. Only corners are pushed; the bottom cap is spanned between them."};
    exercise.working = "From the lamp to a corner it is " + printed(glm::distance(corner, lamp)) + " m, for " +
                       printed(down) + " m of height. " + printed(plateHeight) + " m more of height take " +
                       printed(multiple - 1) + " times as much.";
    exercise.mistake = printed(plateHeight) + " m, the way straight down.";
    addVector(exercise.data, "lamp", lamp);
    exercise.data.insert(exercise.data.end(),
                         {{"width", 2 * half.x}, {"depth", 2 * half.y}, {"plateHeight", plateHeight}});
    exercise.results = {{"least", least}, {"middle", middle}};
    addVector(exercise.results, "pushed", pushed);
    return exercise;
}

} // namespace shadowlab::course
