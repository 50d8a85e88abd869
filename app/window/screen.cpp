// SPDX-License-Identifier: MIT
#include "app/window/screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/actions.h"
#include "app/window/gizmo.h"
#include "app/window/panels/lesson_marks.h"
#include "app/window/panels/panels.h"
#include "app/window/picture_mouse.h"
#include "techniques/foundation/scene/query/view/empty_view.h"

namespace shadowlab::window {

namespace {

constexpr double kBetweenTimes = 1.5;     ///< seconds, while something moves
constexpr std::chrono::milliseconds kStripSlice{25}; ///< for the strip's pictures, in a frame that other pictures have filled
constexpr float kLeastOfPictures = 0.5f, kLeastOfTwoRows = 0.65f; ///< of the window's height, that the strip leaves to the panes
constexpr double kRestBeforeTimes = 0.25; ///< seconds; the judge's own look at what is new comes first, and is timed

float panelWidth(const Theme& theme, int windowWidth) {
    return std::round(std::min(theme.em * 23, static_cast<float>(windowWidth) * 0.36f));
}

} // namespace

void Screen::ContextDeleter::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

Screen::Screen(WindowState& ui, std::filesystem::path fontFile)
    : ui_(ui), fontFile_(std::move(fontFile)), imgui_(ImGui::CreateContext()), labels_(fontFile_),
      errors_(labels_, ui.live) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // what is kept between runs is our own business
    io.LogFilename = nullptr;
    io.MouseDragThreshold = 2;
    renderer_ = std::make_unique<WidgetRenderer>();
}

Screen::~Screen() = default;

void Screen::fit(ivec2 windowPixels, float contentScale) {
    if (windowPixels.x < 1 || windowPixels.y < 1) {
        size_ = ivec2(0);
        return;
    }
    // What of a window is larger than any picture may be stays black.
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    windowPixels = glm::min(windowPixels, ivec2(most));
    ImGui::GetIO().DisplaySize = {static_cast<float>(windowPixels.x), static_cast<float>(windowPixels.y)};
    const float em = typeSize(windowPixels, contentScale, ui_.shown.presenter);
    if (em != theme_.em || ui_.shown.presenter != theme_.presenter || !theme_.text) {
        theme_ = applyTheme(em, ui_.shown.presenter, fontFile_);
        renderer_->uploadFonts();
    }
    if (windowPixels == size_) return;
    size_ = windowPixels;
    framebuffer_ = {};
    picture_ = gl::Texture2D(GL_RGBA8, size_, "window");
    framebuffer_ = gl::Framebuffer(&picture_, nullptr, "window");
}

Area Screen::room() const {
    const auto top = static_cast<int>(topBarHeight());
    const int right = ui_.shown.panel ? static_cast<int>(panelWidth(theme_, size_.x)) : 0;
    return {{0, top}, glm::max(ivec2(0), ivec2(size_.x - right - sourceWidth(), size_.y - top))};
}

StripShape Screen::stripShape() const {
    if (!ui_.shown.strip) return window::stripShape(theme_, FLT_MAX); // of the pictures in the list of views
    const StoryLayout without = layStory(ui_, room(), legends_.lines(), theme_);
    const float least = ui_.bench.document().layout == picture::Layout::grid ? kLeastOfTwoRows : kLeastOfPictures;
    return window::stripShape(theme_, static_cast<float>(without.pictures.size.y) - least * static_cast<float>(size_.y));
}

StoryLayout Screen::layout(const StripShape& strip) const {
    Area room = this->room();
    if (ui_.shown.strip) room.size.y = std::max(0, room.size.y - strip.height);
    return layStory(ui_, room, legends_.lines(), theme_);
}

PaneFrames Screen::framesOf(const StoryLayout& story) const {
    return paneFrames(ui_, theme_, story.pictures, legends_.lines(), story.hasCompactHeader);
}

ivec2 Screen::pictureSize() const {
    return ui_.bench.shownSize(framesOf(layout(stripShape())).pictureSize());
}

int Screen::sourceWidth() const {
    return static_cast<int>(SourcePanel::width(ui_, theme_, static_cast<float>(size_.x)));
}

bool Screen::frame(double seconds) {
    ran_.clear();
    if (size_.x < 1 || size_.y < 1) return false;
    clock_ += seconds;
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = static_cast<float>(std::max(seconds, 1e-5));
    // In an open list the arrows choose. Without a window there is no keyboard that ImGui knows.
    if (ui_.panelHasKeys || (isPopupOpen() && io.BackendPlatformName))
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    else
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::NewFrame();
    ran_ = runKeys(ui_);
    if (!ui_.requests.news.empty()) say(std::exchange(ui_.requests.news, {}));

    const StripShape stripShape = this->stripShape();
    const StoryLayout story = layout(stripShape);
    const PaneFrames frames = framesOf(story);
    const ivec2 pictures = frames.pictureSize();
    panes_ = window::shownPanes(ui_, frames, clock_);
    const bool painting = ui_.lesson.paints(); // then the mouse is a brush
    const bool painted = handlePainting(ui_, panes_);
    const bool held = !painting && handleGizmos(ui_, panes_, frames.pictures(), theme_);
    const bool moved = !painting && (handleMouse(ui_, panes_, frames.pictures(), theme_) || held);
    ui_.pressedAt.reset();
    ui_.bench.setMoving(moved);
    if (ui_.selection.kind == lab::Selection::Kind::object)
        ui_.bench.setOutsideCaster(static_cast<std::size_t>(ui_.selection.index));
    ui_.bench.setOutsideType(static_cast<int>(std::lround(theme_.em / picture::kOutsideTypeShare)));
    ui_.bench.allowDraft(ui_.shown.coarse);
    ui_.bench.drawWhole(ui_.shown.magnifier || ui_.shown.blink);
    ui_.bench.advance(seconds);
    const bool asked = errors_.ask(ui_.bench, pictures, clock_);
    // A clock around every pass keeps the driver from doing two things at once. So what is new is drawn without it, and
    // again with it when all is at rest; and while something moves, now and then a frame that has no more to draw than
    // others.
    const bool atRest = !moved && !ui_.bench.animation().playing;
    const bool timed = !ui_.live || (atRest ? asked || (clock_ - drawn_ >= kRestBeforeTimes && !errors_.seesNew())
                                              : clock_ - timed_ >= kBetweenTimes && !asked);
    if (timed) timed_ = clock_;
    ui_.bench.setTimePasses(timed);
    const Deadline deadline = std::chrono::steady_clock::now() + patience_;
    const bool drawn = ui_.bench.update(pictures, deadline);
    if (drawn && !timed) drawn_ = clock_;
    const bool judged = errors_.update(ui_.bench, pictures, clock_);
    if (const std::string failure = errors_.takeFailure(); !failure.empty())
        complain("errors cannot be found: " + failure);
    keepJudged(ui_, errors_);
    const bool small = updateStrip(deadline, stripShape);
    const bool hasOtherBands = legends_.follow(ui_, errors_, story.pictures, theme_);
    const bool figured = figure_.update(ui_, story.figure.size, theme_.em, labels_);
    busy_ = drawn || figured || moved || painted || judged || small || hasOtherBands || !ran_.empty() || !ui_.bench.isAtRest() ||
            ui_.flashUntil > ImGui::GetTime();
    if (!busy_) busy_ = measureShownState(ui_); // once, and seen in the next frame
    settled_ = !busy_ && errors_.isDone();

    signs_ = drawPictures(ui_, errors_, panes_, frames, theme_);
    drawMagnifiers(ui_, errors_, panes_, theme_);
    viewsAreOpen_ = false;
    const float headerType = headerTypeShare(ui_, errors_, frames, theme_);
    for (const PaneHeader& header : paneHeaders(ui_, frames))
        viewsAreOpen_ = paneHeader(ui_, errors_, strip_, header, frames, headerType, theme_) || viewsAreOpen_;
    drawWidgets(story, stripShape);
    if (ui_.bench.isAtRest() && !panes_.empty()) sayWhyNothingIsSeen(pictures);
    drawMessages(frames);
    ui_.requests.focusPanel = false;
    ImGui::Render();

    framebuffer_.bind();
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.03f, 0.03f, 0.035f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer_->draw(*ImGui::GetDrawData(), framebuffer_);
    return true;
}

void Screen::sayWhyNothingIsSeen(ivec2 pictures) {
    const scene::Snapshot& scene = ui_.bench.shownScene();
    const scene::Camera& camera = ui_.bench.document().camera;
    if (pictures.x < 1 || pictures.y < 1 || (scene == lookedAt_ && camera == lookedFrom_)) return;
    lookedAt_ = scene;
    lookedFrom_ = camera;
    const std::string said = "no surface is in view: ";
    withdraw(said);
    if (const std::string why = scene::whyNothingIsSeen(*scene, camera, pictures); !why.empty()) say(said + why);
}

bool Screen::updateStrip(Deadline deadline, const StripShape& shape) {
    if (!(ui_.shown.strip || viewsAreOpen_) || !ui_.bench.isAtRest()) return false;
    if (!ran_.empty()) return true; // what a key has changed is seen first
    deadline = std::max(deadline, std::chrono::steady_clock::now() + kStripSlice);
    lab::PlacedPane active;
    active.pane = ui_.bench.document().active;
    try {
        return strip_.update(ui_.bench.session(), ui_.bench.encoder(), ui_.bench.requestFor(active),
                             shape.thumbnail, deadline);
    } catch (const std::exception& fault) {
        complain(fault.what());
        return false;
    }
}

void Screen::drawWidgets(const StoryLayout& story, const StripShape& strip) {
    const int top = story.pictures.corner.y;
    const int besideStory = story.room.size.x;
    topBar(ui_, {{0, 0}, {size_.x, top}}, theme_);
    const int besidePictures = besideStory + sourceWidth();
    if (ui_.shown.source) source_.draw(ui_, {{besideStory, top}, {sourceWidth(), size_.y - top}}, theme_);
    if (ui_.shown.panel)
        sidePanel(ui_, errors_, {{besidePictures, top}, {size_.x - besidePictures, size_.y - top}}, theme_);
    storyBar(ui_, figure_, story, theme_);
    if (ui_.shown.strip)
        stripPanel(ui_, strip_, {{0, size_.y - strip.height}, {besideStory, strip.height}}, strip, theme_);
    if (ui_.shown.keys) keyOverlay(ui_, size_, theme_);
}

void Screen::withdraw(const std::string& beginning) {
    std::erase_if(ui_.messages, [&](const Message& message) { return message.text.starts_with(beginning); });
}

void Screen::drawMessages(const PaneFrames& frames) {
    std::erase_if(ui_.messages,
                  [&](const Message& message) { return !message.fault && clock_ > message.untilSeconds; });
    // From the foot of the pictures upward, the newest lowest: most are one line, in the place of the legends.
    const Area pictures = frames.pictures();
    float bottom = static_cast<float>(pictures.corner.y + pictures.size.y + frames.lastFooter());
    const float width = std::min(static_cast<float>(pictures.size.x), theme_.em * 60);
    for (std::size_t i = ui_.messages.size(); i-- > 0;) {
        const Message message = ui_.messages[i];
        ImGui::SetNextWindowPos(
            {static_cast<float>(pictures.corner.x) + (static_cast<float>(pictures.size.x) - width) / 2, bottom}, 0, {0, 1});
        ImGui::SetNextWindowSize({width, 0});
        ImGui::PushStyleColor(ImGuiCol_Border, message.fault ? kWarning : kPlateText);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme_.em * 0.5f, theme_.em * 0.25f});
        ImGui::Begin(("message" + std::to_string(i)).c_str(), nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_NoNav);
        const char* const close = "Close (Esc)";
        const float button = ImGui::CalcTextSize(close).x + 2 * ImGui::GetStyle().FramePadding.x + theme_.em;
        ImGui::PushTextWrapPos(message.fault ? width - button : 0);
        if (message.fault)
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", message.text.c_str());
        else
            ImGui::TextUnformatted(message.text.c_str());
        ImGui::PopTextWrapPos();
        if (message.fault) {
            ImGui::SameLine(width - button);
            if (ImGui::SmallButton(close)) ui_.messages.erase(ui_.messages.begin() + static_cast<std::ptrdiff_t>(i));
        }
        bottom -= ImGui::GetWindowHeight() + theme_.em * 0.2f;
        ImGui::End();
        ImGui::PopStyleVar(2);
        ImGui::PopStyleColor();
    }
}

} // namespace shadowlab::window
