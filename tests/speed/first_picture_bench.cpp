// How soon a technique that takes seconds shows something: what a class waits for when a scene is opened.
//
//   ninja -C build/release first_picture_bench && build/release/tests/first_picture_bench [TECHNIQUE]
//
// Every built-in scene at 1280x720, from nothing, in frames of 60 ms as the window draws them. Printed is the time to the first picture
// at all (of radiosity surfaces in the scene's ambient light), to the first with direct light in it, until nothing gets better, and
// of the longest frame. The scene is loaded beforehand. Default technique: radiosity.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/context/assets.h"
#include "app/context/context.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{1280, 720};
constexpr std::chrono::milliseconds kFrame{60};

struct Times {
    double firstMs = 0, directMs = 0, allMs = 0, longestMs = 0;
};

Times timesOf(const scene::Snapshot& snapshot, const std::string& technique) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const auto ms = [&] { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); };
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot(technique);
    View view;
    view.camera = snapshot->camera;
    view.size = kSize;
    Times times;
    while (times.allMs == 0) {
        const double frameBegin = ms();
        FrameRequest request;
        request.deadline = Clock::now() + kFrame;
        request.waitForGl = false;
        const picture::RenderedFrame frame = session.render(slot, view, request);
        times.longestMs = std::max(times.longestMs, ms() - frameBegin);
        const auto& passes = frame.result.passes;
        if (times.firstMs == 0 && !passes.empty()) times.firstMs = ms();
        const bool hasDirect = std::ranges::any_of(passes, [](const StageKey& pass) { return pass.id == "direct"; });
        if (times.directMs == 0 && (hasDirect || frame.converged)) times.directMs = ms();
        if (frame.converged) times.allMs = ms();
    }
    return times;
}

int run(const std::string& technique) {
    std::printf("%-20s %10s %12s %10s %16s\n", technique.c_str(), "first, ms", "direct, ms", "all, ms", "longest frame");
    for (const std::string& name : scene::builtInScenes(context::assetsRoot())) {
        const scene::Snapshot snapshot = scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        const Times times = timesOf(snapshot, technique);
        std::printf("%-20s %10.0f %12.0f %10.0f %16.0f\n", name.c_str(), times.firstMs, times.directMs, times.allMs, times.longestMs);
        std::fflush(stdout);
    }
    return 0;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    try {
        const auto context = shadowlab::context::createContext(shadowlab::context::Backend::automatic);
        return shadowlab::run(argc > 1 ? argv[1] : "radiosity");
    } catch (const shadowlab::Error& error) {
        std::fprintf(stderr, "first_picture_bench: %s\n", error.what());
        return 1;
    }
}
