// A window's state and its screen, for tests without a window and without a user.
// SPDX-License-Identifier: MIT
#pragma once
#include <thread>

#include "app/context/assets.h"
#include "app/window/screen.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab::testing {

class ScreenFixture : public GlTest {
protected:
    static scene::Snapshot scene(const std::string& name) {
        return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    }
    static void settle(window::Screen& screen) {
        for (int settled = 0, frames = 0; settled < 3 && frames < 4000; ++frames) {
            screen.frame(1.0 / 30);
            settled = screen.isSettled() ? settled + 1 : 0;
            if (settled == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        EXPECT_TRUE(screen.isSettled());
    }
    static std::vector<std::uint8_t> pixels(const window::Screen& screen) {
        return picture::PictureEncoder::read(screen.picture()).rgba;
    }
};

/// The state of a window and its screen, without a user (`live` is false): exact errors come at once.
struct Lab {
    Lab(const scene::Snapshot& scene, ivec2 size)
        : ui(lab::newDocument(scene, scene->name)), screen(calm(ui), font()) {
        screen.setPatience(std::chrono::hours(1));
        screen.fit(size, 1);
    }
    static std::filesystem::path font() { return context::assetsRoot() / "fonts" / "DejaVuSans.ttf"; }
    static window::WindowState& calm(window::WindowState& ui) {
        ui.live = false;
        ui.bench.allowDraft(false);
        return ui;
    }
    window::WindowState ui;
    window::Screen screen;
};

} // namespace shadowlab::testing
