// The figures of bounding volumes, of grids, of trees of rays, and of the radiosity equations, against arithmetic of the test's own.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>

#include "techniques/probed/radiosity_equations.h"
#include "techniques/probed/structure_probe.h"
#include "tests/figures/figure_of.h"

namespace shadowlab::figures {
namespace {

/// Where a segment, 0..1, is within a box; nothing where it misses it.
std::optional<dvec2> within(const dvec3& from, const dvec3& to, const dvec3& low, const dvec3& high) {
    double enter = 0, leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = to[axis] - from[axis];
        const double a = (low[axis] - from[axis]) / way, b = (high[axis] - from[axis]) / way;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter < leave ? std::optional(dvec2(enter, leave)) : std::nullopt;
}

TEST(BoundingVolumesFigureTest, TellWhatTheRayEntersAndWhatLiesInWhat) {
    int entered = 0, missed = 0, spared = 0, children = 0;
    for (const char* structure : {"groups", "object-boxes", "object-spheres", "sphere-tree", "bvh"})
        for (const ivec2 pixel : {ivec2(793, 144), ivec2(640, 500), ivec2(230, 430), ivec2(900, 650)}) {
            const FigureOf asked("billiards", "ray-traced", pixel, {{"structure", structure}});
            const Probe::Segment& ray = asked.probe.geometry.front();
            ASSERT_TRUE(asked.probe.find<StructureProbe>()) << structure;
            const std::vector<StructureProbe::Volume>& volumes = asked.probe.find<StructureProbe>()->volumes;
            ASSERT_GT(volumes.size(), 3u);
            for (const StructureProbe::Volume& volume : volumes) {
                const dvec3 centre = 0.5 * (volume.lowerWorld + volume.upperWorld);
                const dvec3 way = ray.toWorld - ray.fromWorld;
                const double t = std::clamp(glm::dot(centre - ray.fromWorld, way) / glm::dot(way, way), 0.0, 1.0);
                // What is touched within rounding may be said either way.
                const double depth = volume.isBall ? volume.radius - glm::length(ray.fromWorld + t * way - centre) : 0;
                const auto stretch = within(ray.fromWorld, ray.toWorld, volume.lowerWorld, volume.upperWorld);
                if (volume.isBall ? std::abs(depth) > 1e-9 : !stretch || stretch->y - stretch->x > 1e-9) {
                    const bool flat = glm::any(glm::lessThan(volume.upperWorld - volume.lowerWorld, dvec3(1e-6)));
                    if (!flat) {
                        EXPECT_EQ(volume.isEntered, volume.isBall ? depth > 0 : stretch.has_value()) << structure;
                    }
                }
                if (volume.parent >= 0) {
                    ++children;
                    const StructureProbe::Volume& parent = volumes[static_cast<std::size_t>(volume.parent)];
                    EXPECT_EQ(parent.level + 1, volume.level);
                    EXPECT_EQ(volume.isAsked, parent.isAsked && parent.isEntered);
                    // Boxes lie within their parents; of balls only what they hold does, so that they overlap at least.
                    const double slack = 1e-6;
                    EXPECT_TRUE(volume.isBall ||
                                (glm::all(glm::greaterThanEqual(volume.lowerWorld, parent.lowerWorld - slack)) &&
                                 glm::all(glm::lessThanEqual(volume.upperWorld, parent.upperWorld + slack))))
                        << structure;
                } else {
                    EXPECT_TRUE(volume.isAsked);
                }
                (volume.isEntered ? entered : missed) += 1;
                spared += !volume.isAsked;
            }
        }
    std::cout << entered << " entered, " << missed << " missed, " << spared << " never asked, " << children
              << " children\n";
    EXPECT_GT(entered, 50);
    EXPECT_GT(missed, 50);
    EXPECT_GT(spared, 10);
    EXPECT_GT(children, 100);
}

TEST(BoundingVolumesFigureTest, TheTreeHasAllOfThem) {
    const FigureOf asked("billiards", "ray-traced", {793, 144}, {{"structure", "groups"}});
    const Diagram drawn = asked.draw("bounding-volumes", {1920, 860});
    const auto& volumes = asked.probe.find<StructureProbe>()->volumes;
    const std::size_t enteredOnes = circlesOf(drawn, "entered").size(), others = circlesOf(drawn, "not entered").size();
    EXPECT_EQ(enteredOnes + others, volumes.size());
    EXPECT_EQ(enteredOnes, static_cast<std::size_t>(std::ranges::count_if(
                               volumes, [](const auto& volume) { return volume.isEntered && volume.isAsked; })));
    for (const char* name : {"white ball", "plate", "pane", "cloth"})
        EXPECT_TRUE(says(drawn, name)) << name;
}

TEST(GridFigureTest, CellsFollowTheRayAndListWhatLiesInThem) {
    int cells = 0, listed = 0;
    for (const ivec2 pixel : {ivec2(768, 252), ivec2(640, 500), ivec2(420, 300), ivec2(800, 650)}) {
        const FigureOf asked("cornell-room", "ray-traced", pixel, {{"structure", "grid"}});
        const Probe::Segment& ray = asked.probe.geometry.front();
        const StructureProbe& grid = *asked.probe.find<StructureProbe>();
        ASSERT_FALSE(grid.cells.empty());
        const dvec3 size = (grid.upperWorld - grid.lowerWorld) / dvec3(grid.counts);
        double reached = -1;
        for (std::size_t i = 0; i < grid.cells.size(); ++i, ++cells) {
            const StructureProbe::Cell& cell = grid.cells[i];
            EXPECT_LT(glm::length(grid.lowerWorld + dvec3(cell.at) * size - cell.lowerWorld), 1e-6);
            const auto stretch = within(ray.fromWorld, ray.toWorld, cell.lowerWorld - 1e-9, cell.upperWorld + 1e-9);
            ASSERT_TRUE(stretch) << i;
            EXPECT_GE(stretch->x, reached - 1e-6) << "in order";
            reached = stretch->x;
            if (i > 0) {
                const glm::ivec3 step = glm::abs(cell.at - grid.cells[i - 1].at);
                EXPECT_EQ(step.x + step.y + step.z, 1) << "through a face into the next one";
            }
            for (const std::string& name : cell.objects) {
                const scene::Bounds box =
                    scene::boundsWorld(*std::ranges::find(asked.scene->objects, name, &scene::Object::name));
                EXPECT_TRUE(glm::all(glm::lessThan(box.lowerWorld, cell.upperWorld + 1e-3)) &&
                            glm::all(glm::greaterThan(box.upperWorld, cell.lowerWorld - 1e-3)))
                    << name;
                ++listed;
            }
        }
        const std::vector<std::string>& last = grid.cells.back().objects;
        EXPECT_NE(std::ranges::find(last, asked.probe.tree.front().object), last.end())
            << "what is hit is listed where it is hit";
    }
    std::cout << cells << " cells, " << listed << " entries\n";
    EXPECT_GT(cells, 15);
    EXPECT_GT(listed, 8);
}

// The rows that are shown hold, colour by colour: what stands on the left is what stands on the right. The solver stops where the
// largest error is 1e-4 of the largest radiosity.
TEST(EquationsFigureTest, TheRowsAreEquationsThatHold) {
    const FigureOf asked("cornell-room", "radiosity", {500, 690}, {{"patches", "100"}}, 0, ivec2(300, 400));
    ASSERT_TRUE(asked.probe.find<RadiosityEquations>());
    const RadiosityEquations& e = *asked.probe.find<RadiosityEquations>();
    ASSERT_EQ(e.patches.size(), 5u);
    double largest = 0;
    for (const dvec3& radiosity : e.radiosity)
        largest = std::max({largest, radiosity.r, radiosity.g, radiosity.b});
    int compared = 0;
    for (std::size_t i = 0; i < 5; ++i)
        for (int channel = 0; channel < 3; ++channel, ++compared) {
            double left = 0;
            for (std::size_t k = 0; k < 5; ++k)
                left +=
                    ((i == k ? 1.0 : 0.0) - e.reflectance[i][channel] * e.formFactors[i][k]) * e.radiosity[k][channel];
            const double right = e.emission[i][channel] + e.reflectance[i][channel] * e.fromOthers[i][channel];
            EXPECT_NEAR(left, right, 1e-3 * largest) << e.patches[i];
            // Without the other columns they would not: the test could fail.
            if (channel == 0) {
                EXPECT_GT(std::abs(left - e.emission[i][channel]), 1e-2 * largest);
            }
        }
    EXPECT_EQ(compared, 15);
    const Diagram drawn = asked.draw("equations", {1920, 860});
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_TRUE(says(drawn, std::to_string(e.patches[i])));
    EXPECT_TRUE(says(drawn, "n = " + std::to_string(e.count)));
}

// Paths and tree in rooms of one size show the same rays.
TEST(RayTreeFiguresTest, PathsAndTreeShowTheSameRays) {
    int signs = 0;
    for (const ivec2 pixel : {ivec2(499, 419), ivec2(470, 400), ivec2(800, 450), ivec2(430, 470)}) {
        const FigureOf asked("mirror-and-glass", "ray-traced", pixel);
        const Diagram paths = asked.draw("paths"), tree = asked.draw("tree");
        for (int i = 1; i < 8; ++i) {
            const std::string surface = "S" + std::to_string(i);
            EXPECT_EQ(says(paths, surface), says(tree, surface)) << surface;
            for (const char* letter : {"R", "T"}) {
                const std::string sign = letter + std::to_string(i);
                if (says(paths, sign)) {
                    EXPECT_TRUE(says(tree, sign)) << sign;
                    ++signs;
                }
            }
        }
    }
    EXPECT_GT(signs, 10);
}

} // namespace
} // namespace shadowlab::figures
