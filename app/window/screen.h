// Everything that is seen in the window, drawn into a framebuffer of our own: pictures, widgets, messages. A window shows
// it, a headless capture writes it down; the bytes are the same.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/lab/stage_strip.h"
#include "app/window/imgui_bridge.h"
#include "app/window/panels/legend_room.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/source_panel.h"
#include "app/window/panels/story_bar.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"
#include "app/window/widget_renderer.h"
#include "app/window/window_state.h"

struct ImGuiContext;

namespace shadowlab::window {

class Screen {
public:
    /// Needs a current GL context for its whole life. `fontFile` is DejaVu Sans.
    Screen(WindowState& ui, std::filesystem::path fontFile);
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// Before ImGui's own input is fed: makes type and framebuffer fit a window of that many pixels on a screen of that
    /// scale. A size of zero is a window that is not seen; nothing is drawn then.
    void fit(ivec2 windowPixels, float contentScale);

    /// How long the drawing of one frame may take before it goes on in the next.
    void setPatience(std::chrono::milliseconds patience) { patience_ = patience; }

    /// One frame: keys and mouse as ImGui has them, the pictures that have changed, the widgets. `seconds` is the time
    /// since the last frame. Returns false when there was nothing to draw to.
    bool frame(double seconds);

    [[nodiscard]] const gl::Framebuffer& framebuffer() const { return framebuffer_; }
    [[nodiscard]] const gl::Texture2D& picture() const { return picture_; }
    /// Whether the next frame should follow at once. False while only exact errors are missing, which need the processor.
    [[nodiscard]] bool isBusy() const { return busy_; }
    /// Pixels of the picture area: what a capture of the pictures alone has.
    [[nodiscard]] ivec2 pictureSize() const;
    /// Whether the next frame would look just like this one, without input and without time passing.
    [[nodiscard]] bool isSettled() const { return settled_; }
    [[nodiscard]] const lab::LiveErrors& errors() const { return errors_; }
    /// The step as text, as it was shown last.
    [[nodiscard]] const picture::StepSource& stepSource() const { return source_.shown(); }
    /// The drawing of the slide on show, as it was shown last.
    [[nodiscard]] const SlideFigure& figure() const { return figure_; }
    [[nodiscard]] const std::vector<ShownPane>& shownPanes() const { return panes_; }
    /// What was written over them, and where.
    [[nodiscard]] const std::vector<PaneSigns>& paneSigns() const { return signs_; }
    /// Whether a drop-down list or a menu is open.
    [[nodiscard]] bool isListOpen() const { return isPopupOpen(); }
    [[nodiscard]] const Theme& theme() const { return theme_; }
    [[nodiscard]] const lab::StageStrip& strip() const { return strip_; }
    /// The ids of the actions that keys have run in the last frame.
    [[nodiscard]] const std::vector<std::string>& ran() const { return ran_; }

    void say(const std::string& news) { ui_.messages.push_back({news, false, clock_ + 6}); }
    void complain(const std::string& fault) { window::complain(ui_, fault); }
    [[nodiscard]] const std::vector<Message>& messages() const { return ui_.messages; }
    /// Removes the messages that begin so: their cause is gone.
    void withdraw(const std::string& beginning);

private:
    /// A message where a scene or a camera at rest shows no surface in pictures of that size: once, and until one is seen.
    void sayWhyNothingIsSeen(ivec2 pictures);
    void drawMessages(const PaneFrames& frames);
    void drawWidgets(const StoryLayout& story, const StripShape& strip);
    /// Where pictures, band and drawing are.
    [[nodiscard]] StoryLayout layout(const StripShape& strip) const;
    /// What the strip and all of that share.
    [[nodiscard]] Area room() const;
    [[nodiscard]] PaneFrames framesOf(const StoryLayout& story) const;
    [[nodiscard]] StripShape stripShape() const;
    [[nodiscard]] int sourceWidth() const;
    /// Small pictures wait until nothing moves: they must not slow down what does.
    bool updateStrip(Deadline deadline, const StripShape& shape);

    WindowState& ui_;
    std::filesystem::path fontFile_;
    struct ContextDeleter {
        void operator()(ImGuiContext* context) const;
    };
    std::unique_ptr<ImGuiContext, ContextDeleter> imgui_;
    std::unique_ptr<WidgetRenderer> renderer_;
    Theme theme_;
    lab::StageStrip strip_;
    LegendRoom legends_;
    SourcePanel source_;
    SlideFigure figure_;
    image::Font labels_; ///< for numbers inside of pictures
    lab::LiveErrors errors_;
    gl::Texture2D picture_;
    gl::Framebuffer framebuffer_;
    ivec2 size_{0};
    std::vector<std::string> ran_;
    std::vector<ShownPane> panes_;             ///< of the last frame
    std::vector<PaneSigns> signs_;
    scene::Snapshot lookedAt_;                 ///< by sayWhyNothingIsSeen()
    scene::Camera lookedFrom_;
    double clock_ = 0, timed_ = 0, drawn_ = 0; ///< seconds: now, and of the last frames with and without times
    // The window has to react within a tenth of a second; the rest of a frame takes its part of that.
    std::chrono::milliseconds patience_{60};
    bool viewsAreOpen_ = false; ///< a pane's list of views, with small pictures
    bool settled_ = false, busy_ = true;
};

} // namespace shadowlab::window
