// SPDX-License-Identifier: MIT
#include "app/window/window.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <optional>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/context/window_context.h"
#include "app/course/capture_words.h"
#include "app/course/slide_file.h"
#include "app/lab/scene_loader.h"
#include "app/lab/shader_watch.h"
#include "app/window/imgui_bridge.h"
#include "app/window/own_program.h"
#include "app/window/screen.h"
#include "app/window/state_report.h"
#include "app/window/window_settings.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::window {

namespace {

using Clock = std::chrono::steady_clock;

/// Frames that follow one in which something happened: ImGui needs two to lay out what has changed.
constexpr int kFramesAfter = 3;
/// How long a window sleeps in which nothing happens, between looks at files and loaders.
constexpr double kIdleSeconds = 0.1;
/// The same while exact errors are being found, which only the processor's idle time is given to.
constexpr double kWaitSeconds = 0.04;

class Window {
public:
    Window(const WindowSettings& settings, const scene::LoadOptions& loading)
        : settings_(settings), loading_(loading),
          memory_(settings.keepSettings ? readWindowMemory(windowMemoryFile())
                                        : WindowMemory{}),
          loader_(loading) {
        // Before a window flashes up.
        const scene::Snapshot first = scene::loadScene(settings.scene, loading);
        if (!settings.deck.empty()) static_cast<void>(course::Deck(settings.deck, loading));
        if (!settings.lesson.empty()) static_cast<void>(course::loadLesson(settings.lesson, loading));
        const ivec2 size = settings.size.x > 0 ? settings.size : memory_.size;
        context_ = context::createWindowContext(
            {.width = size.x, .height = size.y, .title = "Shadowlab", .visible = true, .debug = false});
        window_ = context::glfwWindow(*context_);
        glfwSwapInterval(1);
        desk_.emplace(lab::newDocument(first, settings.scene));
        desk_->scenes = scene::builtInScenes(context::assetsRoot());
        desk_->lesson.all = course::builtInLessons(context::assetsRoot());
        desk_->lesson.loading = loading;
        desk_->slides.decks = course::builtInDecks(context::assetsRoot());
        desk_->slides.loading = loading;
        desk_->shown.panel = memory_.panel;
        desk_->shown.strip = memory_.strip;
        desk_->shown.handles = memory_.handles;
        desk_->shown.coarse = memory_.coarse;
        if (settings.presenter && !memory_.presenter) togglePresenter(*desk_);
        desk_->shown.presenter = desk_->shown.presenter || memory_.presenter;
        screen_.emplace(*desk_, context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
        glfwSetWindowUserPointer(window_, this);
        glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
            static_cast<Window*>(glfwGetWindowUserPointer(window))->drop(count, paths);
        });
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
            static_cast<Window*>(glfwGetWindowUserPointer(window))->press(key, scancode, action, modifiers);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int action, int) {
            auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
            if (action == GLFW_PRESS) self.desk_->pressedAt = self.cursor_ * self.pixelsPerPoint_;
        });
        if (!settings.lesson.empty()) openLesson(*desk_, settings.lesson);
        if (!settings.deck.empty()) openDeck(*desk_, settings.deck, settings.slide);
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
        while (!glfwWindowShouldClose(window_) && !desk_->requests.quit) {
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
            busy = screen_->isBusy() || desk_->shown.blink ? kFramesAfter : std::max(0, busy - 1);
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
        const std::string state = stateReport(*desk_, *screen_);
        if (state == reported_) return;
        reported_ = state;
        // Frames since the first, and seconds: how quick the window is, for whoever watches it play.
        const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
        std::printf("%s, \"frames\": %ld, \"seconds\": %s}\n", state.substr(0, state.size() - 1).c_str(), frames_,
                    scene::numberText(std::round(seconds * 1e4) / 1e4).c_str());
        std::fflush(stdout);
    }

    /// What others have finished meanwhile. True if there was anything.
    bool takeWhatArrived() {
        bool any = false;
        if (const auto loaded = loader_.take()) {
            any = true;
            screen_->withdraw("loading ");
            if (loaded->scene) {
                desk_->selection = {};
                desk_->lesson.now.reset(); // whoever chooses a scene has left the lesson
                desk_->lesson.earlier.reset();
                desk_->slides.deck.reset(); // and the slides
                desk_->slides.earlier.reset();
                desk_->bench.showScene(loaded->scene, loaded->nameOrPath);
                for (const std::string& note : loaded->scene->notes)
                    screen_->say(note);
            } else {
                screen_->complain(loaded->fault);
                loadFault_ = loaded->fault;
            }
        }
        if (const auto ended = program_.take()) {
            any = true;
            screen_->withdraw("saving ");
            if (ended->status == 0)
                screen_->say("saved " + scene::shown(ended->words[3]) +
                             " and beside it the scene and the command line");
            else
                discardScreenshot(*ended);
        }
        if (watch_.changed()) {
            any = true;
            desk_->requests.reloadShaders = true;
        }
        return any;
    }

    void doRequests() {
        Requests& requests = desk_->requests;
        if (!requests.scene.empty()) {
            if (!loadFault_.empty()) screen_->withdraw(std::exchange(loadFault_, {})); // one such message is enough
            loader_.begin(requests.scene);
            screen_->withdraw("loading ");
            screen_->say("loading " + scene::shown(requests.scene));
            requests.scene.clear();
        }
        if (std::exchange(requests.saveScene, false)) saveScene();
        if (std::exchange(requests.saveSlide, false)) saveAsSlide(*desk_);
        if (std::exchange(requests.screenshot, false)) saveScreenshot();
        if (std::exchange(requests.fullScreen, false)) toggleFullScreen();
        if (std::exchange(requests.reloadShaders, false)) {
            gl::reloadShaders();
            desk_->bench.drawAnew();
            shadersReloaded_ = true;
        } else if (std::exchange(shadersReloaded_, false)) {
            // By now every program on show was compiled again.
            const std::vector<std::string> faults = gl::takeShaderFaults();
            for (const std::string& fault : shaderFaults_)
                screen_->withdraw(fault);
            shaderFaults_ = faults;
            for (const std::string& fault : faults)
                screen_->complain(fault);
            if (faults.empty()) screen_->say("shaders compiled");
        }
    }

    /// "still-life-3" in the current folder: the first number under which nothing is there yet.
    [[nodiscard]] std::filesystem::path freeName(const std::vector<std::string>& endings) const {
        const std::string stem = desk_->bench.shownScene()->name;
        for (int number = 1;; ++number) {
            const std::filesystem::path path = course::currentFolder() / (stem + "-" + std::to_string(number));
            const bool taken = std::ranges::any_of(endings, [&](const std::string& ending) {
                std::error_code ignored;
                return std::filesystem::exists(path.string() + ending, ignored);
            });
            if (!taken) return path;
        }
    }

    [[nodiscard]] std::string sceneText() const {
        return scene::sceneText(*desk_->bench.shownScene(), desk_->bench.document().camera, course::currentFolder());
    }

    void saveScene() {
        try {
            const image::FolderLock alone(course::currentFolder()); // two windows choose two names
            const std::filesystem::path file = freeName({".json"}).string() + ".json";
            image::writeWhole(file, sceneText());
            screen_->say("saved " + scene::shownPath(file));
        } catch (const std::exception& fault) {
            screen_->complain(fault.what());
        }
    }

    void saveScreenshot() {
        try {
            const ivec2 size = screen_->pictureSize();
            if (std::min(size.x, size.y) < 1)
                throw Error(ExitStatus::usage, "there is no room for a picture in this window; make it larger");
            const image::FolderLock alone(course::currentFolder());
            const std::string stem = freeName({".json", ".png", ".txt"}).string();
            image::writeWhole(stem + ".json", sceneText());
            std::vector<std::string> words =
                course::captureWords(desk_->bench.document(), stem + ".json", stem + ".png", size);
            for (const std::filesystem::path& folder :
                 scene::foldersToAllow(*desk_->bench.shownScene(), course::currentFolder(), context::assetsRoot()))
                words.insert(words.end(), {"--allow", folder.string()});
            image::writeWhole(stem + ".txt", "shadowlab " + course::asCommandLine(words) + "\n");
            screen_->say("saving " + scene::shownPath(stem + ".png"));
            program_.start(std::move(words));
        } catch (const std::exception& fault) {
            screen_->complain(fault.what());
        }
    }

    /// Without the picture the scene and the command line beside it are of no use.
    void discardScreenshot(const OwnProgram::Ended& ended) {
        std::error_code ignored;
        for (const char* ending : {".json", ".txt"})
            std::filesystem::remove(std::filesystem::path(ended.words[3]).replace_extension(ending), ignored);
        constexpr std::string_view kProgram = "shadowlab: ";
        const std::size_t begin = ended.message.starts_with(kProgram) ? kProgram.size() : 0;
        screen_->complain("the picture was not saved: " + ended.message.substr(begin));
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
        // GLFW numbers keys by their place on an American keyboard; what is printed on them is meant.
        const char* const printed = glfwGetKeyName(key, scancode);
        if (printed && printed[0] != 0 && printed[1] == 0) {
            const char c = printed[0];
            key = c >= 'a' && c <= 'z' ? GLFW_KEY_A + (c - 'a') : c == '+' ? GLFW_KEY_EQUAL : c;
        }
        if (action == GLFW_RELEASE) {
            desk_->held.erase(key);
            return;
        }
        desk_->held.insert(key);
        KeyPress press{key, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0,
                       (modifiers & GLFW_MOD_ALT) != 0, action == GLFW_REPEAT};
        if (key == GLFW_KEY_EQUAL) press.shift = false; // where it takes Shift to write a plus
        if (key == GLFW_KEY_KP_ENTER) press.key = GLFW_KEY_ENTER;
        desk_->keys.push_back(press);
    }

    void drop(int count, const char** paths) {
        for (int i = 0; i < count; ++i) {
            const std::string dropped = scene::shown(paths[i]);
            if (dropped.find("://") != std::string::npos) {
                screen_->complain(dropped + ": is an address and no file; save it, and drop the file");
                continue;
            }
            std::error_code failed;
            const std::filesystem::path path = std::filesystem::absolute(paths[i], failed);
            if (failed) {
                screen_->complain(dropped + ": cannot be found: " + failed.message() + "; drop it from another folder");
                continue;
            }
            std::string ending = path.extension().string();
            std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
            if (ending == ".json" || ending == ".obj")
                desk_->requests.scene = path.string();
            else
                screen_->complain(scene::shownPath(path) +
                                  ": neither a .json scene nor an .obj mesh; drop one of these");
        }
    }

    void keepMemory() {
        if (!settings_.keepSettings) return;
        WindowMemory memory = memory_;
        if (!glfwGetWindowMonitor(window_)) glfwGetWindowSize(window_, &memory.size.x, &memory.size.y);
        memory.panel = desk_->shown.panel;
        memory.strip = desk_->shown.strip;
        memory.handles = desk_->shown.handles;
        memory.coarse = desk_->shown.coarse;
        memory.presenter = desk_->shown.presenter;
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
    std::optional<Desk> desk_;
    std::optional<Screen> screen_;
    lab::SceneLoader loader_;
    OwnProgram program_;
    lab::ShaderWatch watch_;
    std::vector<std::string> shaderFaults_;
    bool shadersReloaded_ = false;
    std::string loadFault_; ///< of the last scene that could not be loaded
    std::string reported_;
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
