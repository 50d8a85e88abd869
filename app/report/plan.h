// What a report is going to draw: the sweeps that the techniques declare, for each scene's light, and how they are dealt out.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/report/results.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/technique.h"

namespace shadowlab::report {

/// What all are compared with. It is part of every group and of every shard.
inline constexpr std::string_view kYardstick = "unshadowed";

/// The points of a technique under a light: those of its sweeps, or its defaults where it declares none.
std::vector<PointKey> pointsOf(const TechniqueInfo& technique, const scene::Light& light, bool quick);

/// One light of one scene.
struct PlannedGroup {
    std::string scene; ///< as it was asked for: a built-in name or a file
    std::string title; ///< the scene's own name
    std::string light;
    std::string digest;           ///< of the scene's files: a report goes on only with the same
    std::vector<PointKey> points; ///< the yardstick first
    friend bool operator==(const PlannedGroup&, const PlannedGroup&) = default;
};

/// One of `count` equal parts of the work, counted from 1.
struct Shard {
    int number = 1, count = 1;
    friend bool operator==(const Shard&, const Shard&) = default;
};
/// "2/5". Throws Error (usage).
Shard shardFrom(const std::string& text);

/// All of it; what the shards of one report have in common.
struct Plan {
    std::string program; ///< version
    std::string build;   ///< digest of the program with its shaders, plug-ins and fonts (student/program_digest.h)
    ivec2 size{0};
    bool isQuick = false;
    std::string renderer; ///< another one draws other pixels
    /// What else was said and belongs to the command that repeats a point: the backend, folders allowed, plug-ins.
    std::vector<std::string> furtherWords;
    std::vector<PlannedGroup> groups;
    friend bool operator==(const Plan&, const Plan&) = default;
};

/// What is said of a plan that is not the other one: "of pictures of 640x360, not 1280x720".
std::string difference(const Plan& plan, const Plan& other);

/// The points that a shard draws, dealt out in turns over all groups so that each has as many cheap and dear ones; with the
/// yardstick wherever there is anything to hold against it. Groups without any are left out.
std::vector<PlannedGroup> shardOf(const Plan& plan, const Shard& shard);

} // namespace shadowlab::report
