// Where the time of a frame of the window goes, and what its parts would take alone.
//
//   ninja -C build/release window_bench && build/release/tests/window_bench [SCENE [ROUNDS [SETTING...]]]
//
// Opens a window of 1280 x 720 pixels that shows the shadow map beside the shadow volume, split, and lets the light turn. A setting such as
// shadow-map.filter=hard holds where its technique is shown, right=shadow-volume shows another technique on the right, and with turns=camera
// the camera turns. Eight kinds of frame take turns, a few at a time, so that other programs slow all of them alike:
//   whole      each technique alone over the whole picture, one after the other
//   split      the pictures as the window shows them, each technique in its part
//   screen     the same with settings, texts and marks, all put together
//   window     the same shown: copied to the window, which X copies to the screen; now and then judged
//   shown      nothing but that copy, of a picture that stays: what no window can do without
//   floor      a map on the left and volumes counted by depth fail on the right, by programs that do only that work (floors.h)
//   faces      the same, volumes alone
// Every frame ends with glFinish. Printed are medians in milliseconds, each over that of `split`, and the least, which is what
// other programs have disturbed least.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/context/assets.h"
#include "app/context/window_context.h"
#include "app/lab/settings.h"
#include "app/window/screen.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/speed/floors.h"
#include "tests/speed/median.h"

namespace shadowlab {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ivec2 kSize{1280, 720};
constexpr int kWarming = 2, kFrames = 8; ///< of each kind in a round: the first ones fit targets and buffers to another size
constexpr double kStep = 0.05;           ///< seconds from frame to frame, of the light's turn

struct Bench {
    Bench(const std::string& sceneName, std::span<const char* const> settings)
        : context(context::createWindowContext({.width = kSize.x, .height = kSize.y})),
          ui(lab::newDocument(scene::loadScene(sceneName, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}), sceneName)),
          screen(ui, context::assetsRoot() / "fonts" / "DejaVuSans.ttf") {
        for (const std::string setting : settings) {
            if (setting == "turns=camera")
                ui.bench.setAnimation([](lab::Animation& animation) {
                    animation.lights = false;
                    animation.camera = true;
                });
            else
                ui.bench.change("", [&](lab::Document& document) { set(document, setting); });
        }
        glfwSwapInterval(0);
        ui.shown.coarse = false;
        screen.fit(kSize, 1);
        screen.setPatience(std::chrono::hours(1)); // frames that are cut off are no frames
        screen.frame(kStep);
        ui.bench.play(true);
    }

    static void set(lab::Document& document, const std::string& setting) {
        constexpr std::string_view kRight = "right=";
        if (setting.starts_with(kRight)) {
            document.panes[1].technique = setting.substr(kRight.size());
            return;
        }
        const lab::Setting parsed = lab::parseSetting(setting);
        for (lab::PaneState& pane : document.panes)
            if (pane.technique == parsed.id) pane.settings[parsed.id][parsed.param] = parsed.value;
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
    /// The volumes of what is shown next, for a floor in the pictures' size.
    void extrude() {
        if (!floors) floors.emplace(screen.pictureSize());
        ui.bench.advance(kStep);
        floors->extrude(ui.bench.shownScene());
        glFinish();
    }
    void drawFloor(speed::Floor floor, int half) {
        const int middle = screen.pictureSize().x / 2;
        floors->draw(floor, ui.bench.shownScene(), ui.bench.document().camera, {.first = half * middle, .count = middle});
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
    std::optional<speed::Floors> floors;
};

int run(const std::string& scene, int rounds, std::span<const char* const> settings) {
    Bench bench(scene, settings);
    using enum picture::Layout;
    struct Kind {
        const char* name;
        std::function<void()> frame;
        std::function<void()> before = [] {}; ///< the clock does not count it
        std::vector<double> ms{};
    };
    using speed::Floor;
    std::vector<Kind> kinds{{"whole, left technique", [&] { bench.pictures(single, 0); }},
                            {"whole, right technique", [&] { bench.pictures(single, 1); }},
                            {"split", [&] { bench.pictures(split, 0); }},
                            {"screen", [&] { bench.onScreen(); }},
                            {"window",
                             [&] {
                                 bench.onScreen();
                                 bench.show();
                             }},
                            {"shown", [&] { bench.show(); }},
                            {"floor",
                             [&] {
                                 bench.drawFloor(Floor::map, 0);
                                 bench.drawFloor(Floor::failing, 1);
                             },
                             [&] { bench.extrude(); }},
                            {"faces", [&] { bench.drawFloor(Floor::failing, 1); }, [&] { bench.extrude(); }}};
    for (int round = 0; round < rounds; ++round)
        for (Kind& kind : kinds)
            for (int i = 0; i < kWarming + kFrames; ++i) {
                kind.before();
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
        const std::span<const char* const> given(arguments, static_cast<std::size_t>(count));
        return shadowlab::run(count > 1 ? given[1] : "colonnade", count > 2 ? std::max(1, std::atoi(given[2])) : 8,
                              count > 3 ? given.subspan(3) : given.subspan(given.size()));
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "window_bench: %s\n", fault.what());
        return 1;
    }
}
