// How wrong shadow maps are, and what that depends on: their resolution, and where the light is as seen from the eye.
//
//   ninja -C build/release map_error_bench && build/release/tests/map_error_bench [RESOLUTION.svg ANGLE.svg]
//
// Prints two tables of edgeErrorPx, the mean distance in pixels between the true edge of a shadow and the drawn one, and
// draws them as charts if asked to.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <iostream>
#include <random>

#include "app/context/context.h"
#include "app/lab/settings.h"
#include "app/report/measurement.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/speed/line_plot.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{1280, 720};

struct Way {
    std::string name, color;
    std::vector<std::string> settings;
};

double edgeErrorPx(const scene::Scene& scene, const std::vector<std::string>& settings) {
    const auto snapshot = testing::snapshot(scene);
    picture::Session session(snapshot);
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("shadow-map"));
    for (const std::string& setting : settings)
        lab::applySettings(slots, {"shadow-map." + setting});
    report::Measurement measurement(session, slots, 0, kSize);
    measurement.addFrame({snapshot, snapshot->camera});
    return measurement.results()[0].edgeErrorPx.value_or(0);
}

/// A floor that faces the sun, seen from straight above through many small triangles that hang over the eye. The map holds
/// all of them, 2.4 m across; the picture shows a sixth of that, so that even the finest texels are larger than a pixel's
/// band of ties.
scene::Scene facingPlane() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1.2, 1.2), offset(-0.09, 0.09);
    std::vector<dvec3> corners;
    for (int i = 0; i < 300; ++i) {
        const dvec3 middle(place(random), 0, place(random));
        for (int corner = 0; corner < 3; ++corner)
            corners.push_back(middle + dvec3(offset(random), 0, offset(random)));
    }
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, testing::triangleSoup(corners), testing::translation({0, 10, 0}));
    scene.camera.positionWorld = {0.05, 8, 0.02};
    scene.camera.targetWorld = {0.05, 0, 0.02};
    scene.camera.upWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 2 * std::atan(0.2 / 8) * 180 / M_PI;
    scene.lights = {testing::directionalLight({0, -1, 0})};
    return scene;
}

/// Boxes that float before the eye, near and far, lit from any side.
scene::Scene boxField(double degrees) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0, 1), turn(0, 360);
    scene::Scene scene;
    scene.materials = testing::floorScene().materials;
    for (int i = 0; i < 90; ++i) {
        const double depth = 1.5 * std::pow(40.0, share(random)); // as many in each octave of distance
        const double x = (share(random) - 0.5) * 1.3 * depth, y = (share(random) - 0.5) * 0.8 * depth;
        const dvec3 size = 0.09 * depth * dvec3(0.4 + share(random), 0.4 + share(random), 0.4 + share(random));
        testing::addObject(scene, scene::makeBox(dvec3(1)),
                           scene::worldFromObjectOf(size, {turn(random), turn(random), turn(random)}, {x, y, -depth}));
    }
    scene.camera.positionWorld = {0, 0, 0};
    scene.camera.targetWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 45;
    scene.camera.near = 0.1;
    // 0: from behind the eye; 90: from above, and a little aside; 180: into the eye's face.
    const double radians = degrees * M_PI / 180;
    const dvec3 across = glm::normalize(dvec3(0.3, -1, 0));
    scene.lights = {testing::directionalLight(std::cos(radians) * dvec3(0, 0, -1) + std::sin(radians) * across)};
    return scene;
}

void print(const Plot& plot) {
    std::printf("%-12s", plot.xLabel.substr(0, 12).c_str());
    for (const PlotLine& line : plot.lines)
        std::printf("%14s", line.name.c_str());
    std::printf("\n");
    for (std::size_t i = 0; i < plot.x.size(); ++i) {
        std::printf("%-12g", plot.x[i]);
        for (const PlotLine& line : plot.lines)
            std::printf("%14.4f", line.y[i]);
        std::printf("\n");
    }
}

/// Of the logarithms, by least squares.
double slopeOf(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double lx = std::log(x[i]), ly = std::log(y[i]);
        sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
    }
    const double n = static_cast<double>(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Plot againstResolution() {
    Plot plot{.xLabel = "resolution, texels",
              .yLabel = "edge error, px",
              .x = {256, 512, 1024, 2048, 4096, 8192},
              .xByPowersOfTwo = true,
              .xMarks = {256, 512, 1024, 2048, 4096, 8192},
              .firstPower = -2,
              .lastPower = 1,
              .lines = {{"hard", "#d55e00", {}}}};
    const scene::Scene scene = facingPlane();
    for (const double resolution : plot.x)
        plot.lines[0].y.push_back(edgeErrorPx(
            scene, {"filter=hard", "fit=scene", "resolution=" + std::to_string(static_cast<int>(resolution))}));
    print(plot);
    std::printf("slope of the logarithms: %.3f\n\n", slopeOf(plot.x, plot.lines[0].y));
    return plot;
}

Plot againstAngle() {
    const std::vector<Way> ways = {{"uniform", "#d55e00", {}},
                                   {"LiSPSM", "#0072b2", {"warp=lispsm"}},
                                   {"4 cascades", "#009e73", {"cascades=4"}},
                                   {"both", "#cc79a7", {"cascades=4", "warp=lispsm"}}};
    Plot plot{.xLabel = "angle between light and view, degrees",
              .yLabel = "edge error, px",
              .x = {},
              .xByPowersOfTwo = false,
              .xMarks = {0, 30, 60, 90, 120, 150, 180},
              .firstPower = -1,
              .lastPower = 1,
              .lines = {}};
    for (double degrees = 0; degrees <= 180; degrees += 15)
        plot.x.push_back(degrees);
    for (const Way& way : ways) {
        plot.lines.push_back({way.name, way.color, {}});
        for (const double degrees : plot.x) {
            std::vector<std::string> settings = {"filter=hard", "resolution=1024"};
            settings.insert(settings.end(), way.settings.begin(), way.settings.end());
            plot.lines.back().y.push_back(edgeErrorPx(boxField(degrees), settings));
        }
    }
    print(plot);
    return plot;
}

int run(int argc, char** argv) {
    const auto context = context::createContext(context::Backend::automatic, false);
    context->makeCurrent();
    const Plot plots[] = {againstResolution(), againstAngle()};
    for (int i = 0; i < 2 && i + 1 < argc; ++i)
        std::ofstream(argv[i + 1]) << linePlot(plots[i]);
    return 0;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    try {
        return shadowlab::run(argc, argv);
    } catch (const shadowlab::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return static_cast<int>(error.status());
    }
}
