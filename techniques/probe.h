// What a technique knows about one pixel: facts to print, rays and vectors to draw in the scene; where it follows rays that split,
// their tree; what it decided about the light. What only some techniques know, for a figure of their own, are the structs of
// techniques/probed/, one for each idea.
// SPDX-License-Identifier: MIT
#pragma once
#include <any>
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/light_section.h"
#include "techniques/scene_shape.h"

namespace shadowlab {

/// What was decided about the pixel, and what is true.
struct Decision {
    double visibility = 0; ///< by the technique, 0..1
    bool isTurnedAway = false;
    std::string why{}; ///< it differs from the truth, or that it does not
    /// The face that it was found to be blocked by, of a technique that looks for one.
    struct Face {
        std::string object;
        std::uint32_t triangle = 0;
        std::array<dvec3, 3> cornersWorld{};
    };
    std::optional<Face> blocker{};
};

struct Probe {
    /// One line of what is known. Numbers are in `numbers` as well, with all their digits.
    struct Fact {
        std::string label, value, unit;
        std::vector<double> numbers{};
    };
    /// What a ray is sent for, and of a shadow ray what came of it.
    enum class Role { eye, reflection, refraction, arriving, blocked };
    /// A piece of a ray that is drawn as a line.
    struct Segment {
        std::string label;
        dvec3 fromWorld, toWorld;
        Role role = Role::arriving;
        bool isEndless = false; ///< it goes on where the line ends: it meets nothing, or the sun is nowhere
    };
    /// A unit vector at the first surface, such as the normal.
    struct Vector {
        std::string label; ///< one letter, as in the lecture
        dvec3 directionWorld;
    };
    /// A ray of a tree; parent is an index into `tree`, -1 at the root.
    struct Node {
        int parent;
        std::string label;
        std::vector<Fact> facts;
        // The rest is for drawings of the tree.
        Role role = Role::eye;
        std::string sign{};    ///< "R1": the reflection ray of surface S1
        std::string surface{}; ///< "S2": what it meets; empty: nothing
        std::string object{};  ///< of which that is the surface
        std::string end{};     ///< why it goes no farther; empty: it does
        int segment = -1;      ///< in `geometry`; -1: it was not sent
        int light = -1;        ///< of a shadow ray
        double share = 0;      ///< of the pixel that it carries where it begins
        dvec3 intensity{0.0};
        dvec3 normalWorld{0.0}; ///< N where it ends, on the side that it came from
    };
    std::vector<Fact> facts;
    std::vector<Segment> geometry;
    std::vector<Node> tree;
    std::vector<Vector> vectors;           ///< at the end of the eye ray
    std::optional<LightSection> section{}; ///< that figures of the shadow are drawn in; none without a light
    std::optional<Decision> decision{};    ///< of a technique that decides on the spot whether a light reaches the pixel
    /// A pass of a frame, as often as it is drawn: with which light, and how many triangles it draws.
    struct DrawnPass {
        std::string id;
        int light = -1; ///< index; -1: of no light
        std::uint64_t triangles = 0;
        std::string what; ///< which, in a few words
    };
    std::vector<DrawnPass> passes;   ///< of the frame that the pixel is in, in order, of a technique that tells
    std::vector<SceneShape> visited; ///< what of the technique's own structures the eye ray passes through

    /// Puts in, or replaces, what a figure is drawn from: a struct of techniques/probed/, or of a folder of its own.
    template <typename Part>
    Part& add(Part part) {
        if (Part* const before = find<Part>()) return *before = std::move(part);
        return *std::any_cast<Part>(&parts_.emplace_back(std::move(part)));
    }
    /// Null where the technique does not know such a thing about the pixel.
    template <typename Part>
    [[nodiscard]] const Part* find() const {
        for (const std::any& part : parts_)
            if (const auto* found = std::any_cast<Part>(&part)) return found;
        return nullptr;
    }
    template <typename Part>
    [[nodiscard]] Part* find() {
        for (std::any& part : parts_)
            if (auto* found = std::any_cast<Part>(&part)) return found;
        return nullptr;
    }

private:
    std::deque<std::any> parts_; ///< of each type one; a deque, so that references to them stay valid
};

/// Six digits, without regard to the locale, and without a sign where there is nothing.
std::string probeText(double number);
Probe::Fact probeFact(std::string label, double number, std::string unit = "");
Probe::Fact probeFact(std::string label, const dvec3& vector, std::string unit = "");
Probe::Fact probeCount(std::string label, std::uint64_t count, std::string unit = "");

} // namespace shadowlab
