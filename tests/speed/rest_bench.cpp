// What a frame costs in which nothing has moved: the program's own work, without that of the graphics driver.
//
//   ninja -C build/release rest_bench && build/release/tests/rest_bench [TECHNIQUE[,PARAM=VALUE...]]...
//
// Every technique draws two scenes of 100,000 triangles, one knot and 200 tori, until nothing gets better; then OpenGL is
// silenced (silent_gl.h) and the same frame drawn again and again. Printed is the median of the processor time of all
// threads for one frame, prepare and render together, and the most it may be. Exits with 1 where that is exceeded. Beside it,
// for comparison, stands what a frame of the 200 tori costs while the light moves. Not drawn unless it is asked for is
// ray-traced: its finished picture stays, and drawn again it is traced again.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <sstream>

#include "app/context/context.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/speed/silent_gl.h"
#include "tests/support/scenes.h"
#include "tests/support/trefoil.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{640, 360};
constexpr int kFrames = 201;
constexpr double kMostMs = 0.2; // a frame of 60 in a second has 16.7: what rests must not be felt

double processorMs() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

scene::Scene litFloor(const char* name) {
    scene::Scene scene = testing::floorScene();
    scene.name = name;
    scene.camera.positionWorld = {0, 6, 11};
    scene.camera.targetWorld = {0, 1.5, 0};
    scene.lights.push_back(testing::pointLight({4, 9, 3}));
    return scene;
}

scene::Scene oneKnot() {
    scene::Scene scene = litFloor("one knot");
    scene::Mesh knot = testing::trefoil(0.25, 500, 100);
    knot.parts = {{"", 0, static_cast<std::uint32_t>(knot.triangles.size())}};
    testing::addObject(scene, scene::withNormals(knot, scene::NormalMode::smooth), testing::translation({0, 3, 0}));
    return scene;
}

scene::Scene manyTori() {
    scene::Scene scene = litFloor("200 tori");
    for (int i = 0; i < 200; ++i)
        testing::addObject(scene, scene::makeTorus(0.2, 0.08, {25, 10}),
                           testing::translation({0.6 * (i % 14) - 4, 0.3 + 0.01 * (i % 7), 0.6 * (i / 14) - 4.2}));
    return scene;
}

picture::Slot slotOf(const std::string& text) {
    std::istringstream words(text);
    std::string technique, setting;
    std::getline(words, technique, ',');
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(technique));
    while (std::getline(words, setting, ','))
        lab::applySettings(slots, {technique + "." + setting});
    return std::move(slots.front());
}

enum class Light { rests, moves };

/// Median processor time of one frame, milliseconds.
double frameMs(const scene::Snapshot& snapshot, Light light, const std::string& entry, context::Context& context) {
    picture::Session session(snapshot);
    picture::Slot slot = slotOf(entry);
    View view;
    view.camera = snapshot->camera;
    view.size = kSize;
    for (int i = 0; i < 2; ++i)
        session.render(slot, view);
    speed::silenceGl();
    std::vector<double> ms;
    for (int i = 0; i < kFrames; ++i) {
        scene::Snapshot next = snapshot;
        if (light == Light::moves) {
            std::vector<scene::Light> lights = snapshot->lights;
            lights[0].positionWorld.x += 0.01 * (i + 1);
            next = scene::withLights(snapshot, lights);
        }
        const double before = processorMs();
        if (light == Light::moves) session.setScene(next);
        session.render(slot, view);
        ms.push_back(processorMs() - before);
    }
    context.makeCurrent();
    std::ranges::nth_element(ms, ms.begin() + kFrames / 2);
    return ms[kFrames / 2];
}

int run(const std::vector<std::string>& entries, context::Context& context) {
    bool exceeded = false;
    std::printf("at rest at most %.1f ms\n%-32s %12s %12s %12s\n", kMostMs, "technique", "one knot", "200 tori",
                "light moves");
    const scene::Snapshot knot = testing::snapshot(oneKnot()), tori = testing::snapshot(manyTori());
    for (const std::string& entry : entries) {
        const double ms[] = {frameMs(knot, Light::rests, entry, context), frameMs(tori, Light::rests, entry, context)};
        std::printf("%-32s %9.3f ms %9.3f ms %9.3f ms\n", entry.c_str(), ms[0], ms[1],
                    frameMs(tori, Light::moves, entry, context));
        std::fflush(stdout);
        exceeded = exceeded || std::ranges::max(ms) > kMostMs;
    }
    return exceeded ? 1 : 0;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    try {
        const auto context = shadowlab::context::createContext(shadowlab::context::Backend::automatic);
        std::vector<std::string> entries(argv + 1, argv + argc);
        if (entries.empty())
            for (const auto& technique : shadowlab::techniquesOf(shadowlab::TechniqueGroup::production))
                if (technique.info->id != "ray-traced") entries.emplace_back(technique.info->id);
        return shadowlab::run(entries, *context);
    } catch (const shadowlab::Error& error) {
        std::fprintf(stderr, "rest_bench: %s\n", error.what());
        return 1;
    }
}
