// Where the time of a frame of the window goes, and what its parts would take alone.
//
//   ninja -C build/release window_bench && build/release/tests/window_bench [SCENE [ROUNDS]]
//
// Opens a window of 1280 x 720 pixels that shows the shadow map beside the shadow volume, split, and lets the light turn. Six kinds of
// frame take turns, a few at a time, so that other programs slow all of them alike:
//   whole      each technique alone over the whole picture, one after the other
//   split      the pictures as the window shows them, each technique in its part
//   screen     the same with settings, texts and marks, all put together
//   window     the same shown: copied to the window, which X copies to the screen; now and then judged
//   shown      nothing but that copy, of a picture that stays: what no window can do without
// Every frame ends with glFinish. Printed are medians in milliseconds, each over that of `split`, and the least, which is what
// other programs have disturbed least.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/context/assets.h"
#include "app/context/window_context.h"
#include "app/window/screen.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/speed/median.h"

namespace shadowlab {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ivec2 kSize{1280, 720};
constexpr int kWarming = 2, kFrames = 8; ///< of each kind in a round: the first ones fit targets and buffers to another size
constexpr double kStep = 0.05;           ///< seconds from frame to frame, of the light's turn

struct Bench {
    explicit Bench(const std::string& sceneName)
        : context(context::createWindowContext({.width = kSize.x, .height = kSize.y})),
          ui(lab::newDocument(scene::loadScene(sceneName, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}), sceneName)),
          screen(ui, context::assetsRoot() / "fonts" / "DejaVuSans.ttf") {
        glfwSwapInterval(0);
        ui.shown.coarse = false;
        screen.fit(kSize, 1);
        screen.setPatience(std::chrono::hours(1)); // frames that are cut off are no frames
        screen.frame(kStep);
        ui.bench.play(true);
    }

    /// The pictures alone, as the window asks for them while something moves.
    void pictures(picture::Layout layout, int active) {
        ui.bench.change("", [&](lab::Document& document) {
            document.layout = layout;
            document.active = active;
        });
        ui.bench.allowDraft(false);
        ui.bench.wantVisibility({});
        ui.bench.setTimePasses(false);
        ui.bench.advance(kStep);
        ui.bench.update(screen.pictureSize(), Deadline::max());
    }
    void onScreen() {
        ui.bench.change("", [](lab::Document& document) { document.layout = picture::Layout::split; });
        screen.frame(kStep);
    }
    void show() {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, screen.framebuffer().id());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glDisable(GL_SCISSOR_TEST);
        glBlitFramebuffer(0, 0, kSize.x, kSize.y, 0, 0, kSize.x, kSize.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glfwSwapBuffers(context::glfwWindow(*context));
        glfwPollEvents();
    }

    std::unique_ptr<context::Context> context;
    window::WindowState ui;
    window::Screen screen;
};

int run(const std::string& scene, int rounds) {
    Bench bench(scene);
    using enum picture::Layout;
    struct Kind {
        const char* name;
        std::function<void()> frame;
        std::vector<double> ms{};
    };
    std::vector<Kind> kinds{{"whole, left technique", [&] { bench.pictures(single, 0); }},
                            {"whole, right technique", [&] { bench.pictures(single, 1); }},
                            {"split", [&] { bench.pictures(split, 0); }},
                            {"screen", [&] { bench.onScreen(); }},
                            {"window",
                             [&] {
                                 bench.onScreen();
                                 bench.show();
                             }},
                            {"shown", [&] { bench.show(); }}};
    for (int round = 0; round < rounds; ++round)
        for (Kind& kind : kinds)
            for (int i = 0; i < kWarming + kFrames; ++i) {
                const Clock::time_point begin = Clock::now();
                kind.frame();
                glFinish();
                if (i >= kWarming) kind.ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
            }
    const double ofSplit = median(kinds[2].ms);
    for (const Kind& kind : kinds)
        std::printf("%-24s %7.1f ms, %5.2f of split; the least %7.1f ms\n", kind.name, median(kind.ms), median(kind.ms) / ofSplit,
                    *std::ranges::min_element(kind.ms));
    return 0;
}

} // namespace
} // namespace shadowlab

int main(int count, char** arguments) {
    try {
        return shadowlab::run(count > 1 ? arguments[1] : "colonnade", count > 2 ? std::max(1, std::atoi(arguments[2])) : 8);
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "window_bench: %s\n", fault.what());
        return 1;
    }
}
