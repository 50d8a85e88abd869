// What a report is made of: points, each a technique with its settings on one scene under one light, with cost beside error.
//
// What is the same on every machine (errors, counters, bytes of OpenGL objects) is kept apart from what was measured of time and
// memory: reports of one sweep made by several machines agree in the former in every digit.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/judge/truth.h"

namespace shadowlab::report {

/// A technique with its settings, and which of its sweeps that is a part of.
struct PointKey {
    std::string technique;             ///< id
    std::vector<std::string> settings; ///< "filter=hard", without the technique's id; empty: its defaults
    std::string sweep;                 ///< of its sweeps the one it belongs to, by title ("Hard map"); empty: none
    std::string varies;                ///< the parameter that changes along the sweep; empty: none
    double value = 0;                  ///< of that parameter; choices and booleans: their number
    /// "shadow-map filter=hard resolution=512": unique within a group, for file names and tables.
    [[nodiscard]] std::string name() const;
    friend bool operator==(const PointKey&, const PointKey&) = default;
};

/// How wrong it is. The same on every machine with the same driver.
struct Errors {
    judge::TruthOf truth = judge::TruthOf::centre; ///< what it was judged by
    int pixels = 0, lit = 0, shadowed = 0, turnedAway = 0, ties = 0;
    int falseLit = 0, falseShadow = 0, core = 0;
    double served = 1; ///< share of the pixels with a surface that the technique serves at all
    double rmse = 0;
    std::optional<double> edgeErrorPx;
    bool converged = true;
    struct Counter {
        std::string id, unit;
        double built = 0, of = 0;
    };
    std::vector<Counter> counters;
    double glMegabytes = 0; ///< of textures and buffers that the technique holds, target apart

    [[nodiscard]] int wrong() const { return falseLit + falseShadow; }
    /// No pixel is wrong, and none is left unserved.
    [[nodiscard]] bool isExact() const { return wrong() == 0 && served >= 1 && rmse < kLeastRmse; }
    /// What the charts show: pixels of boundary where the centre is judged, RMSE where the area is.
    [[nodiscard]] double shown() const;
    /// Visibility pictures have 255 steps: a share rounded to the nearest is off by up to half of one.
    static constexpr double kLeastRmse = 0.5 / 255;
};

/// The middle of many, where it may lie, and what all but a few stay below. Milliseconds.
struct Spread {
    double median = 0;
    double lower = 0, upper = 0; ///< 95 % confidence interval of the median
    double p95 = 0;              ///< 95 of 100 are no longer
};

/// What it costs, light moving by one degree a frame. Measured.
struct Costs {
    int frames = 0;                      ///< that were counted
    Spread frame, prepare, draw, encode; ///< frame: all three
    Spread shadow;                       ///< frame less the one of `unshadowed` in the same round
    Spread atRest;                       ///< frame in which nothing has moved
    double firstMs = 0;                  ///< the first frame: preparing from nothing, shaders compiled
    struct Pass {
        std::string id;
        double ms = 0; ///< median; timed one by one, which takes longer than all together
    };
    std::vector<Pass> passes;
    double residentMegabytes = 0; ///< by which the process has grown
};

struct Point {
    PointKey key;
    Errors errors;
    std::optional<Costs> costs;                     ///< none: not measured yet
    std::string command;                            ///< that measures this point again
    std::vector<std::uint8_t> picturePng, errorPng; ///< what it draws, and where that is wrong; 320 pixels wide
    bool onFront = false;     ///< no other point of its group and truth is both cheaper and less wrong
    bool isYardstick = false; ///< `unshadowed`: what shadows cost is counted from it
};

/// How something grows along a sweep: cost ~ value ^ costPower, error ~ value ^ errorPower. Least squares of logarithms.
struct Growth {
    std::string technique, sweep, varies;
    double from = 0, to = 0; ///< first and last value
    double costPower = 0;
    std::optional<double> errorPower; ///< none: fewer than two points of it have an error at all
};

/// The cheapest exact point beside the cheapest that is wrong.
struct ExactAgainstInexact {
    std::optional<std::size_t> exact, inexact; ///< of Group::points; none: there is none of that kind
    double frameRatio = 0, shadowRatio = 0;    ///< exact / inexact
    std::string why;                           ///< where frameRatio > 2: what takes the time
};

/// All points of one scene under one light that are compared with the same truth.
struct Group {
    std::string scene, light;
    judge::TruthOf truth = judge::TruthOf::centre;
    std::vector<Point> points;
    std::vector<Growth> growth;
    ExactAgainstInexact exactness;
    /// "still-life@key", with "-area" after it where the area is judged: for file names.
    [[nodiscard]] std::string name() const;
};

/// What exact shadows may cost, beside wrong ones, before a report has to state the reason.
inline constexpr double kMostRatio = 2;

struct Machine {
    std::string processor, renderer, glVersion, backend, compiler, program;
    int cores = 0, threads = 0, rasterThreads = 0;
    double memoryGigabytes = 0;
};

struct Report {
    ivec2 size{0};
    bool isQuick = false;
    int rounds = 0;                ///< of the interleaved runs
    std::vector<Machine> machines; ///< one for each shard that was merged
    std::vector<Group> groups;
};

} // namespace shadowlab::report
