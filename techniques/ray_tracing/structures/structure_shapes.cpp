// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/structures/structure_shapes.h"

#include <array>
#include <cmath>
#include <string>

#include "techniques/foundation/base/look.h"

namespace shadowlab::ray_tracing {

namespace {

/// The most parts of one level that are drawn, so that they can still be distinguished: spheres overlap, so there must be fewer,
/// and cells lie in rows, so there may be more.
std::size_t mostOf(trace::Structure structure) {
    switch (structure) {
    case trace::Structure::sphereTree: return 16;
    case trace::Structure::grid: return 1500;
    default: return 70;
    }
}

constexpr int kCircleSegments = 48;

void addBox(std::vector<dvec3>& pointsWorld, const dvec3& lower, const dvec3& upper) {
    const auto corner = [&](int i) {
        return dvec3((i & 1) ? upper.x : lower.x, (i & 2) ? upper.y : lower.y, (i & 4) ? upper.z : lower.z);
    };
    for (int from = 0; from < 8; ++from)
        for (const int bit : {1, 2, 4})
            if (!(from & bit)) pointsWorld.insert(pointsWorld.end(), {corner(from), corner(from | bit)});
}

void addCircle(std::vector<dvec3>& pointsWorld, const dvec3& centre, const dvec3& normal, double radius) {
    const dvec3 aside = glm::normalize(
        glm::cross(normal, std::abs(normal.y) < 0.9 * glm::length(normal) ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    const dvec3 up = glm::normalize(glm::cross(aside, normal));
    const auto at = [&](int i) {
        const double angle = 2 * M_PI * i / kCircleSegments;
        return centre + radius * (std::cos(angle) * aside + std::sin(angle) * up);
    };
    for (int i = 0; i < kCircleSegments; ++i)
        pointsWorld.insert(pointsWorld.end(), {at(i), at(i + 1)});
}

/// The outline of a ball, seen from the eye: a circle nearer to the eye than the ball's centre. From inside there is none.
void addOutline(std::vector<dvec3>& pointsWorld, const dvec3& centre, double radius, const dvec3& eyeWorld) {
    const dvec3 toEye = eyeWorld - centre;
    const double away = glm::length(toEye);
    if (away <= radius) return;
    const double share = radius / away; // sine of the ball's half angle
    addCircle(pointsWorld, centre + share * share * toEye, toEye, radius * std::sqrt(1 - share * share));
}

/// `eyeWorld`: as in structureShapes().
void addPart(std::vector<dvec3>& pointsWorld, const trace::StructurePart& part, const dvec3& originWorld,
             const std::optional<dvec3>& eyeWorld) {
    const dvec3 centreWorld = originWorld + part.centreCentred;
    if (!part.isBall)
        addBox(pointsWorld, originWorld + part.lowerCentred, originWorld + part.upperCentred);
    else if (eyeWorld)
        addOutline(pointsWorld, centreWorld, part.radius, *eyeWorld);
    else
        for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)})
            addCircle(pointsWorld, centreWorld, axis, part.radius);
}

std::string labelOf(trace::Structure structure, int level) {
    using enum trace::Structure;
    switch (structure) {
    case objectSpheres: return "spheres of the objects";
    case objectBoxes: return "boxes of the objects";
    case groups: return level == 0 ? "boxes of the groups" : "boxes of the objects";
    case grid: return "cells of three triangles or more";
    default: return "level " + std::to_string(level + 1);
    }
}

} // namespace

std::vector<SceneShape> structureShapes(const trace::Engine& engine, trace::Structure structure,
                                        const dvec3& originWorld, const std::optional<dvec3>& eyeWorld) {
    // From the outermost level inward. Not the colours of the eye, of lights or of shadow rays, which are seen beside them.
    static const std::array<vec3, 5> colors = {look::linearFromSrgb8(0xE6, 0x9F, 0x00), look::linearFromSrgb8(0x56, 0xB4, 0xE9),
                                               look::linearFromSrgb8(0xCC, 0x79, 0xA7), look::linearFromSrgb8(0x00, 0x72, 0xB2),
                                               look::linearFromSrgb8(0x88, 0x22, 0x55)};
    std::vector<SceneShape> shapes;
    for (const trace::StructurePart& part : engine.parts(mostOf(structure))) {
        const auto level = static_cast<std::size_t>(part.level);
        while (shapes.size() <= level) {
            const vec3 color = colors[shapes.size() % colors.size()];
            shapes.push_back({labelOf(structure, static_cast<int>(shapes.size())), color, SceneShape::Kind::lines, {}});
        }
        addPart(shapes[level].pointsWorld, part, originWorld, eyeWorld);
    }
    return shapes;
}

std::string passedWord(trace::Structure structure) { return structure == trace::Structure::grid ? "cells" : "volumes"; }

SceneShape passedShape(const std::vector<trace::StructurePart>& passed, trace::Structure structure,
                       const dvec3& originWorld) {
    SceneShape shape{passedWord(structure) + " that the eye ray passes: " + std::to_string(passed.size()),
                     look::kVisited,
                     SceneShape::Kind::lines,
                     {}};
    for (const trace::StructurePart& part : passed)
        addPart(shape.pointsWorld, part, originWorld, std::nullopt);
    return shape;
}

} // namespace shadowlab::ray_tracing
