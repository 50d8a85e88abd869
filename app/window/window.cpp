// SPDX-License-Identifier: MIT
#include "app/window/window.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <nlohmann/json.hpp>

#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/context/window_context.h"
#include "app/lab/scene_loader.h"
#include "app/lab/shader_watch.h"
#include "app/window/imgui_bridge.h"
#include "app/window/screen.h"
#include "app/window/state_report.h"
#include "app/window/window_files.h"
#include "app/window/window_settings.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::window {

namespace {

using Clock = std::chrono::steady_clock;

/// Frames that follow one in which something happened: ImGui needs two to lay out what has changed.
constexpr int kFramesAfter = 3;
/// Frames that need all programs on show, while something moves.
constexpr int kFramesToCompile = 10;
/// How long a window sleeps in which nothing happens, between looks at files and loaders.
constexpr double kIdleSeconds = 0.1;
/// The same while exact errors are being found, which only the processor's idle time is given to.
constexpr double kWaitSeconds = 0.04;

class Window {
public:
    Window(const WindowSettings& settings, const scene::LoadOptions& loading)
        : settings_(settings), loading_(loading),
          memory_(settings.keepSettings ? readWindowMemory(windowMemoryFile()) : WindowMemory{}), loader_(loading) {
        // Before a window flashes up.
        const scene::Snapshot first = scene::loadScene(settings.scene, loading);
        if (!settings.deck.empty()) static_cast<void>(course::Deck(settings.deck, loading));
        if (!settings.lesson.empty()) static_cast<void>(course::loadLesson(settings.lesson, loading));
        const ivec2 size = settings.size.x > 0 ? settings.size : memory_.size;
        context_ = context::createWindowContext(
            {.width = size.x, .height = size.y, .title = "Shadowlab", .visible = true, .debug = false});
        window_ = context::glfwWindow(*context_);
        glfwSwapInterval(1);
        ui_.emplace(lab::newDocument(first, settings.scene));
        ui_->scenes = scene::builtInScenes(context::assetsRoot());
        ui_->lesson.all = course::builtInLessons(context::assetsRoot());
        ui_->lesson.loading = loading;
        ui_->slides.decks = course::builtInDecks(context::assetsRoot());
        ui_->slides.loading = loading;
        ui_->showsTimes = !settings.report; // the report has them
        if (settings.presenter) // a lecture begins the same way every time, whatever the last run has left
            togglePresenter(*ui_);
        else
            applyMemory(*ui_, memory_);
        screen_.emplace(*ui_, context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
        files_.emplace(*ui_, *screen_);
        glfwSetWindowUserPointer(window_, this);
        glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
            static_cast<Window*>(glfwGetWindowUserPointer(window))->files_->openDropped(count, paths);
        });
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
            static_cast<Window*>(glfwGetWindowUserPointer(window))->press(key, scancode, action, modifiers);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int action, int) {
            auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
            if (action == GLFW_PRESS) self.ui_->pressedAt = self.cursor_ * self.pixelsPerPoint_;
        });
        if (!settings.lesson.empty()) openLesson(*ui_, settings.lesson);
        if (!settings.deck.empty()) openDeck(*ui_, settings.deck, settings.slide);
        ImGui_ImplGlfw_InitForOpenGL(window_, true); // it calls what was set before it
        glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) { // in its place: it takes pixels
            auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
            self.cursor_ = {x, y};
            tellMouse(window, x * self.pixelsPerPoint_, y * self.pixelsPerPoint_);
        });
    }
    ~Window() { ImGui_ImplGlfw_Shutdown(); }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    int run() {
        Clock::time_point last = Clock::now();
        int busy = kFramesAfter;
        while (!glfwWindowShouldClose(window_) && !ui_->requests.quit) {
            context::throwIfInterrupted();
            if (busy > 0)
                glfwPollEvents();
            else
                glfwWaitEventsTimeout(screen_->isSettled() ? kIdleSeconds : kWaitSeconds);
            if (takeWhatArrived()) busy = kFramesAfter;
            const Clock::time_point now = Clock::now();
            const double seconds = std::min(0.25, std::chrono::duration<double>(now - last).count());
            last = now;
            if (!showFrame(seconds)) {
                busy = 0; // minimised: nothing to draw to
                continue;
            }
            busy = screen_->isBusy() || ui_->shown.blink ? kFramesAfter : std::max(0, busy - 1);
            doRequests();
        }
        keepMemory();
        return 0;
    }

private:
    bool showFrame(double seconds) {
        ImGui_ImplGlfw_NewFrame();
        ivec2 pixels(0), points(0);
        glfwGetFramebufferSize(window_, &pixels.x, &pixels.y);
        glfwGetWindowSize(window_, &points.x, &points.y);
        float scale = 1, scaleY = 1;
        glfwGetWindowContentScale(window_, &scale, &scaleY);
        if (points.x > 0) pixelsPerPoint_ = static_cast<double>(pixels.x) / points.x;
        scaleMouse(static_cast<float>(pixelsPerPoint_));
        ImGui::GetIO().DisplayFramebufferScale = {1, 1};
        screen_->fit(pixels, scale);
        if (!screen_->frame(seconds)) return false;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, screen_->framebuffer().id());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glDisable(GL_SCISSOR_TEST);
        const ivec2 drawn = screen_->framebuffer().size(); // from the upper left corner on
        if (drawn != pixels) {
            glClearColor(0, 0, 0, 1);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glBlitFramebuffer(0, 0, drawn.x, drawn.y, 0, pixels.y - drawn.y, drawn.x, pixels.y, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
        glfwSwapBuffers(window_);
        gl::check("window");
        report();
        return true;
    }

    void report() {
        ++frames_;
        if (!settings_.report) return;
        nlohmann::ordered_json state = stateReport(*ui_, *screen_);
        if (state == reported_) return;
        reported_ = state;
        // How quick the window is, for a program that drives it: frames since the first, and seconds.
        const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
        state["frames"] = frames_;
        state["seconds"] = std::round(seconds * 1e4) / 1e4;
        std::printf("%s\n", stateLine(state).c_str());
        std::fflush(stdout);
    }

    /// Takes what other threads and programs have finished. True if there was anything.
    bool takeWhatArrived() {
        bool any = false;
        if (const auto loaded = loader_.take()) {
            any = true;
            screen_->withdraw("loading ");
            if (loaded->scene) {
                ui_->selection = {};
                ui_->lesson.now.reset(); // choosing a scene leaves the lesson
                ui_->lesson.earlier.reset();
                ui_->slides.deck.reset(); // and the slides
                ui_->slides.earlier.reset();
                ui_->bench.showScene(loaded->scene, loaded->nameOrPath);
                for (const std::string& note : loaded->scene->notes)
                    screen_->say(note);
            } else {
                screen_->complain(loaded->fault);
                loadFault_ = loaded->fault;
            }
        }
        if (files_->takeWhatArrived()) any = true;
        if (watch_.changed()) {
            any = true;
            ui_->requests.reloadShaders = true;
        }
        return any;
    }

    void doRequests() {
        Requests& requests = ui_->requests;
        if (!requests.scene.empty()) {
            if (!loadFault_.empty()) screen_->withdraw(std::exchange(loadFault_, {})); // one such message is enough
            loader_.begin(requests.scene);
            screen_->withdraw("loading ");
            screen_->say("loading " + scene::shown(requests.scene));
            requests.scene.clear();
        }
        if (std::exchange(requests.saveScene, false)) files_->saveScene();
        if (std::exchange(requests.saveSlide, false)) saveAsSlide(*ui_);
        if (std::exchange(requests.screenshot, false)) files_->saveScreenshot();
        if (std::exchange(requests.fullScreen, false)) toggleFullScreen();
        if (std::exchange(requests.reloadShaders, false)) {
            gl::reloadShaders();
            ui_->bench.drawAnew();
            framesSinceReload_ = 0;
        } else if (framesSinceReload_ && (!screen_->isBusy() || ++*framesSinceReload_ > kFramesToCompile)) {
            // By now every program on show was compiled again: those that draw, and from the next frame on those that are judged by.
            framesSinceReload_.reset();
            const std::vector<std::string> faults = gl::takeShaderFaults();
            for (const std::string& fault : shaderFaults_)
                screen_->withdraw(fault);
            shaderFaults_ = faults;
            for (const std::string& fault : faults)
                screen_->complain(fault);
            if (faults.empty()) screen_->say("shaders compiled");
        }
    }

    void toggleFullScreen() {
        if (glfwGetWindowMonitor(window_)) {
            glfwSetWindowMonitor(window_, nullptr, place_.x, place_.y, windowed_.x, windowed_.y, GLFW_DONT_CARE);
            return;
        }
        GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
        if (!mode) return;
        glfwGetWindowPos(window_, &place_.x, &place_.y);
        glfwGetWindowSize(window_, &windowed_.x, &windowed_.y);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

    void press(int key, int scancode, int action, int modifiers) {
        // GLFW numbers keys by their place on an American keyboard; the program goes by what is printed on them.
        const char* const printed = glfwGetKeyName(key, scancode);
        if (printed && printed[0] != 0 && printed[1] == 0) {
            const char c = printed[0];
            key = c >= 'a' && c <= 'z' ? GLFW_KEY_A + (c - 'a') : c == '+' ? GLFW_KEY_EQUAL : c;
        }
        if (action == GLFW_RELEASE) {
            ui_->heldKeys.erase(key);
            return;
        }
        ui_->heldKeys.insert(key);
        KeyPress press{key, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0,
                       (modifiers & GLFW_MOD_ALT) != 0, action == GLFW_REPEAT};
        if (key == GLFW_KEY_EQUAL) press.shift = false; // where it takes Shift to write a plus
        if (key == GLFW_KEY_KP_ENTER) press.key = GLFW_KEY_ENTER;
        ui_->keys.push_back(press);
    }

    void keepMemory() {
        if (!settings_.keepSettings) return;
        WindowMemory memory = settings_.presenter ? memory_ : memoryOf(*ui_, memory_.size);
        if (!glfwGetWindowMonitor(window_)) glfwGetWindowSize(window_, &memory.size.x, &memory.size.y);
        const std::filesystem::path file = windowMemoryFile();
        if (memory == memory_ || file.empty()) return;
        try {
            writeWindowMemory(file, memory);
        } catch (const Error&) {
            // The next run begins as this one did; that is no failure of this one.
        }
    }

    const WindowSettings& settings_;
    const scene::LoadOptions& loading_;
    WindowMemory memory_;
    std::unique_ptr<context::Context> context_; ///< before all that lives in it
    GLFWwindow* window_ = nullptr;
    std::optional<WindowState> ui_;
    std::optional<Screen> screen_;
    std::optional<WindowFiles> files_;
    lab::SceneLoader loader_;
    lab::ShaderWatch watch_;
    std::vector<std::string> shaderFaults_;
    std::optional<int> framesSinceReload_; ///< none: the faults of the last reload were taken
    std::string loadFault_;           ///< of the last scene that could not be loaded
    nlohmann::ordered_json reported_; ///< without frames and seconds
    long frames_ = 0;
    Clock::time_point began_ = Clock::now();
    dvec2 cursor_{0.0}; ///< of the last event, in window coordinates
    double pixelsPerPoint_ = 1;
    ivec2 place_{0}, windowed_{1280, 720}; ///< of the window before it filled the screen
};

} // namespace

int runWindow(const WindowSettings& settings, const scene::LoadOptions& loading) {
    return Window(settings, loading).run();
}

} // namespace shadowlab::window
