// Random exercises: every answer of two hundred sheets found again by closed forms of this file and by the techniques' own functions.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "app/course/exercises/kinds.h"
#include "techniques/planar/projection.h"
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "techniques/radiosity/form_factors/rectangle_exchange.h"
#include "techniques/radiosity/solvers/solvers.h"
#include "techniques/ray_tracing/tree/fresnel.h"
#include "tests/course/exercise_sheets.h"

namespace shadowlab::course {
namespace {

using Results = std::map<std::string, double>;

/// What a sheet says, by name.
struct Data {
    const Exercise& exercise;
    double operator()(const std::string& name) const { return in(exercise.data, name); }
    [[nodiscard]] dvec3 vector(const std::string& name) const {
        return {(*this)(name + ".x"), (*this)(name + ".y"), (*this)(name + ".z")};
    }
};

void addVector(Results& results, const std::string& name, const dvec3& v) {
    results[name + ".x"] = v.x, results[name + ".y"] = v.y, results[name + ".z"] = v.z;
}

Results projection(const Data& data) {
    const dvec3 lamp = data.vector("lamp"), p = data.vector("P");
    // Similar triangles: x and z go on at the rate at which the height falls.
    const double perMetre = 1 / (lamp.y - p.y);
    Results results;
    addVector(results, "shadow", {p.x + (p.x - lamp.x) * perMetre * p.y, 0, p.z + (p.z - lamp.z) * perMetre * p.y});
    const auto own = planar::projectOnto({0, 1, 0, 0}, dvec4(lamp, 1));
    EXPECT_TRUE(own.has_value());
    if (own) {
        const dvec4 image = own->flattenedFromView * dvec4(p, 1);
        EXPECT_NEAR(image.x / image.w, results["shadow.x"], 1e-9);
        EXPECT_NEAR(image.z / image.w, results["shadow.z"], 1e-9);
    }
    results["area"] = std::pow(data("side") * lamp.y * perMetre, 2);
    return results;
}

Results plane(const Data& data) {
    const auto height = [&](const std::string& name) {
        const dvec3 p = data.vector(name), n = data.vector("N");
        return (n.x * p.x + n.y * p.y + n.z * p.z + data("D")) / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    };
    return {{"lamp", height("lamp")}, {"A", height("A")}, {"B", height("B")}, {"C", height("C")}};
}

Results pixels(const Data& data) {
    const double factor = data("lampHeight") / (data("lampHeight") - data("plateHeight"));
    Results results;
    for (const char* axis : {"x", "y"}) {
        const std::string name = axis;
        results["from." + name] = data("L." + name) + factor * (data("lower." + name) - data("L." + name));
        results["to." + name] = data("L." + name) + factor * (data("upper." + name) - data("L." + name));
    }
    const auto isDark = [&](double x, double y) {
        return x > results["from.x"] && x < results["to.x"] && y > results["from.y"] && y < results["to.y"];
    };
    for (int i = 0; i < 60; ++i)
        results["dark"] += isDark(i % 10 + 0.5, i / 10 + 0.5);
    results["asked"] = isDark(data("asked.x") + 0.5, data("asked.y") + 0.5);
    return results;
}

Results depths(const Data& data) {
    Results results;
    for (const std::string name : {"A", "B"}) {
        const double atPlate = data(name) * (data("lampHeight") - data("plateHeight")) / data("lampHeight");
        const bool blocked = atPlate > data("from") && atPlate < data("to");
        results[name + ".z"] = data("lampHeight");
        results[name + ".d"] = data("lampHeight") - (blocked ? data("plateHeight") : 0);
        results[name + ".lit"] = !blocked;
    }
    return results;
}

Results texel(const Data& data) {
    const double covered = 2 * data("height") / data("cotangent"), texel = covered / data("resolution");
    const double u = data("P.x") / covered + 0.5, v = -data("P.z") / covered + 0.5;
    return {{"covered", covered},
            {"texel", texel},
            {"u", u},
            {"v", v},
            {"column", std::floor(u * data("resolution"))},
            {"row", std::floor(v * data("resolution"))},
            {"onPlate", 2 * (data("height") - data("plateHeight")) / data("cotangent") / data("resolution")}};
}

/// A place of the section is in a box's volume if the box stands between it and the lamp, or holds it (Liang and Barsky's clipping).
bool isInVolume(dvec2 lower, dvec2 upper, dvec2 place, dvec2 lamp) {
    double begin = 0, end = 1;
    const dvec2 way = lamp - place;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0) {
            if (place[axis] < lower[axis] || place[axis] > upper[axis]) return false;
            continue;
        }
        const double a = (lower[axis] - place[axis]) / way[axis], b = (upper[axis] - place[axis]) / way[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    return begin < end;
}

/// Walks along the eye's line in steps of a hundredth of the distance that crossings have at least.
Results counts(const Data& data) {
    const dvec2 lamp(data("lamp.x"), data("lamp.y")), eye(data("eye.x"), data("eye.y")), point(data("P"), 0);
    const double toPoint = glm::distance(eye, point);
    Results results{{"frontsBefore", 0}, {"backsBefore", 0}, {"frontsBeyond", 0}, {"backsBeyond", 0}, {"eyeCount", 0}};
    for (int box = 0; box < 4; ++box) {
        const std::string name = "box" + std::to_string(box);
        if (std::ranges::find(data.exercise.data, name + ".x0", &NamedNumber::name) == data.exercise.data.end()) break;
        const dvec2 lower(data(name + ".x0"), data(name + ".y0")), upper(data(name + ".x1"), data(name + ".y1"));
        bool isIn = isInVolume(lower, upper, eye, lamp);
        results["eyeCount"] += isIn;
        // A line that stays in a volume for good meets its end at infinity, which z-fail counts: far away is enough to tell.
        for (double t = 0; t < 2000; t += t < 100 ? 0.0035 : 1) {
            const bool now = isInVolume(lower, upper, eye + t / toPoint * (point - eye), lamp);
            if (now != isIn) ++results[std::string(now ? "fronts" : "backs") + (t < toPoint ? "Before" : "Beyond")];
            isIn = now;
        }
        if (isIn) ++results["backsBeyond"];
    }
    return results;
}

Results extrusion(const Data& data) {
    const double down = data("lamp.y") - data("plateHeight");
    const double toCorner = std::sqrt(std::pow(data("width") / 2, 2) + std::pow(data("depth") / 2, 2) + down * down);
    const double factor = data("lamp.y") / down;
    Results results{{"least", toCorner * (factor - 1)}, {"middle", data("plateHeight")}};
    addVector(results, "pushed",
              {data("lamp.x") + factor * data("width") / 2, 0, data("lamp.z") + factor * data("depth") / 2});
    return results;
}

Results penumbra(const Data& data) {
    const double above = data("lampHeight") - data("plateHeight"), ratio = data("plateHeight") / above;
    const auto onFloor = [&](double lampX) { return data("edge") + (data("edge") - lampX) * ratio; };
    const double from = onFloor(data("lampWidth") / 2), to = onFloor(-data("lampWidth") / 2);
    return {{"width", data("lampWidth") * ratio},
            {"from", from},
            {"to", to},
            {"share", (data("asked") - from) / (to - from)}};
}

Results reflection(const Data& data) {
    const dvec3 u = data.vector("u"), n = data.vector("N");
    const dvec3 across = u - glm::dot(u, n) * n; // this part stays, the part along the normal turns round
    Results results{{"cosine", glm::length(u - across)}};
    EXPECT_NEAR(glm::distance(ray_tracing::reflected(u, n), across + glm::length(u - across) * n), 0, 1e-12);
    addVector(results, "R", across + glm::length(u - across) * n);
    return results;
}

Results refraction(const Data& data) {
    const dvec3 u = data.vector("u");
    const dvec2 across(u.x / data("index"),
                       u.z / data("index")); // Snell: the part along the surface shrinks by the index
    Results results{{"limit", std::atan(1 / std::sqrt(data("index") * data("index") - 1)) * 180 / std::numbers::pi}};
    const auto own = ray_tracing::refracted(u, {0, 1, 0}, 1 / data("index"));
    EXPECT_TRUE(own && std::abs(own->x - across.x) < 1e-12 && std::abs(own->z - across.y) < 1e-12);
    addVector(results, "T", {across.x, -std::sqrt(1 - glm::dot(across, across)), across.y});
    return results;
}

Results tree(const Data& data) {
    const double rays = std::ldexp(2.0, static_cast<int>(data("levels"))) - 1;
    return {{"rays", rays},
            {"shadowRays", rays * data("lights")},
            {"all", (rays + rays * data("lights")) * data("side") * data("side")}};
}

Results intensity(const Data& data) {
    const double second = data("own2") + data("kr2") * data("reflected2") + data("kt2") * data("refracted2");
    return {{"second", second}, {"pixel", data("own1") + data("kr1") * second + data("kt1") * data("refracted1")}};
}

Results shades(const Data& data) {
    const int side = static_cast<int>(data("side"));
    int black = 0;
    for (int i = 0; i < side * side; ++i) {
        const dvec2 sample((i % side + 0.5) / side, (i / side + 0.5) / side);
        const dvec2 top(data("above"), 0), along = dvec2(data("below"), 1) - top, there = sample - top;
        black += along.x * there.y - along.y * there.x > 0; // on the left of the line that goes down
    }
    const double area = 0.5 * (data("above") + data("below"));
    return {{"black", double(black)},
            {"value", 1 - double(black) / (side * side)},
            {"one", area < 0.5},
            {"exact", 1 - area},
            {"shades", side * side + 1.0}};
}

Results rowSum(const Data& data) {
    const double wall = (1 - data("FFC")) / 4, back = wall * data("side") / data("height");
    const double s = data("side"), h = data("height"); // to the three digits that are given
    const auto exchange = radiosity::rectangleExchange({{0, 0, 0}, {0, 0, s}, {s, 0, s}, {s, 0, 0}},
                                                       {{0, h, 0}, {s, h, 0}, {s, h, s}, {0, h, s}});
    EXPECT_TRUE(exchange.has_value());
    EXPECT_NEAR(data("FFC"), exchange.value_or(0) / (s * s), 0.00051);
    return {{"FFW", wall}, {"FWF", back}, {"toWalls", 1 - 2 * back}};
}

Results twoPatches(const Data& data) {
    const double f21 = data("F12") * data("A1") / data("A2");
    double b1 = data("E1"), b2 = 0;
    for (int bounce = 0; bounce < 200; ++bounce) // light goes back and forth until nothing is left
        b2 = data("rho2") * f21 * b1, b1 = data("E1") + data("rho1") * data("F12") * b2;
    radiosity::ExchangeMatrix exchange(2);
    exchange.set(0, 1, data("A1") * data("F12"));
    const auto solver =
        radiosity::makeSolver(radiosity::SolverKind::direct, {exchange,
                                                              {data("A1"), data("A2")},
                                                              {dvec3(data("E1")), dvec3(0)},
                                                              {dvec3(data("rho1")), dvec3(data("rho2"))}});
    radiosity::solve(*solver, 1e-12, 8);
    EXPECT_NEAR(solver->radiosity()[0].x, b1, 1e-9 * b1);
    EXPECT_NEAR(solver->radiosity()[1].x, b2, 1e-9 * b1);
    return {{"F21", f21}, {"B1", b1}, {"B2", b2}, {"once", data("rho2") * f21 * data("E1")}};
}

/// A square of the area around a place, its front to the other patch.
radiosity::Polygon squareAt(const dvec3& place, bool upright, double area) {
    const double h = std::sqrt(area) / 2;
    if (upright)
        return {place + dvec3(0, -h, -h), place + dvec3(0, -h, h), place + dvec3(0, h, h), place + dvec3(0, h, -h)};
    return {place + dvec3(-h, 0, -h), place + dvec3(h, 0, -h), place + dvec3(h, 0, h), place + dvec3(-h, 0, h)};
}

Results formFactor(const Data& data) {
    const dvec3 between = data.vector("second") - data.vector("first");
    const double r = std::hypot(between.x, between.y, between.z), cos1 = between.y / r,
                 cos2 = (data("upright") > 0 ? between.x : between.y) / r;
    const double there = cos1 * cos2 / std::numbers::pi / (r * r) * data("area2");
    // Lambert's polygon formula knows no small patches; at 3 m one of 25 cm differs by (0.25 / 3)^2 = 0.7 % at most.
    const double lambert = radiosity::pointFormFactor(
        data.vector("first"), {0, 1, 0}, squareAt(data.vector("second"), data("upright") > 0, data("area2")));
    EXPECT_NEAR(std::abs(lambert) / there, 1, 0.007);
    return {{"r", r}, {"cos1", cos1}, {"cos2", cos2}, {"F12", there}, {"F21", there * data("area1") / data("area2")}};
}

const std::map<std::string, Results (*)(const Data&)> kAgain{{"projection", projection},
                                                             {"plane", plane},
                                                             {"pixels", pixels},
                                                             {"depths", depths},
                                                             {"texel", texel},
                                                             {"counts", counts},
                                                             {"extrusion", extrusion},
                                                             {"penumbra", penumbra},
                                                             {"reflection", reflection},
                                                             {"refraction", refraction},
                                                             {"tree", tree},
                                                             {"intensity", intensity},
                                                             {"shades", shades},
                                                             {"form-factor", formFactor},
                                                             {"row-sum", rowSum},
                                                             {"two-patches", twoPatches}};

/// Its data, for messages.
std::string shown(const Exercise& exercise) {
    std::string text;
    for (const NamedNumber& number : exercise.data)
        text += ", " + number.name + " = " + printed(number.value);
    return text;
}

TEST(Exercises, AnswersAreFoundAgain) {
    std::map<std::string, int> compared;
    for (const std::vector<Exercise>& sheet : sheets())
        for (const Exercise& exercise : sheet) {
            ASSERT_TRUE(kAgain.contains(exercise.kind)) << exercise.kind;
            const Results again = kAgain.at(exercise.kind)({exercise});
            ASSERT_EQ(again.size(), exercise.results.size()) << exercise.kind;
            for (const auto& [name, value] : again) {
                // Vertices of scenes are floats: 1e-6 of some ten metres.
                ASSERT_NEAR(in(exercise.results, name), value, 1e-5)
                    << exercise.kind << ", " << name << ": " << exercise.given << shown(exercise);
                ++compared[exercise.kind];
            }
        }
    EXPECT_EQ(compared.size(), exerciseKinds().size());
    for (const auto& [kind, count] : compared)
        EXPECT_GE(count, 2 * kSeeds) << kind;
}

} // namespace
} // namespace shadowlab::course
