// SPDX-License-Identifier: MIT
#include "app/window/panels/lesson_marks.h"

#include <algorithm>

#include "app/window/imgui_bridge.h"

namespace shadowlab::window {

namespace {

constexpr double kBrush = 0.025; ///< radius, as a share of the picture's height: a finger on a far screen
constexpr ImU32 kPaint = IM_COL32(40, 40, 44, 170);

void drawLook(ImDrawList& list, const course::LookBox& box, const ShownPane& shown, const Theme& theme, bool named) {
    const ImVec2 low = shown.at(box.corner), high = shown.at(box.corner + box.size);
    const float width = std::max(2.0f, theme.em / 7);
    list.AddRect({low.x - 1, low.y - 1}, {high.x + 1, high.y + 1}, IM_COL32(16, 16, 18, 255), 0, 0, width + 2);
    list.AddRect(low, high, kAccent, 0, 0, width);
    if (!named) return;
    const float pad = 0.35f * theme.em;
    const ImVec2 size = theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, box.label.c_str());
    const float top = static_cast<float>(shown.area.corner.y), left = static_cast<float>(shown.area.corner.x);
    const float bottom = top + static_cast<float>(shown.area.size.y),
                right = left + static_cast<float>(shown.area.size.x);
    const float plate = size.y + 2 * pad;
    // Above the box, else below it, else in it; clear of the title of the pane, two lines at most.
    float y = low.y - plate - width;
    if (y < top + 2.5f * theme.headingSize) y = high.y + width;
    if (y + plate > bottom) y = low.y + width;
    const float x = std::clamp(low.x, left, std::max(left, right - size.x - 2 * pad));
    list.AddRectFilled({x, y}, {x + size.x + 2 * pad, y + plate}, kPlateColor);
    list.AddText(theme.text, theme.em, {x + pad, y + pad}, kPlateText, box.label.c_str());
}

/// Cells of one kind, run by run along the rows.
template <typename ColorOf>
void drawCells(ImDrawList& list, const ShownPane& shown, const ColorOf& colorOf) {
    const dvec2 size(course::kPredictionSize);
    for (int y = 0; y < course::kPredictionSize.y; ++y)
        for (int x = 0, end = 0; x < course::kPredictionSize.x; x = end) {
            const ImU32 color = colorOf(x, y);
            for (end = x + 1; end < course::kPredictionSize.x && colorOf(end, y) == color;)
                ++end;
            if (color != 0)
                list.AddRectFilled(shown.at(dvec2(x, y) / size), shown.at(dvec2(end, y + 1) / size), color);
        }
}

/// As the lesson means it: neither from another place, nor from outside, nor after a step that does not show it yet.
bool showsLook(const WindowState& ui, const ShownPane& shown) {
    const LessonState& on = ui.lesson;
    if (!on.now || (on.step != LessonStep::artefact && on.step != LessonStep::remedy)) return false;
    const picture::StageRef& stage = ui.bench.document().panes[static_cast<std::size_t>(shown.pane)].stage;
    return ui.bench.document().camera == on.now->states[on.step == LessonStep::remedy ? 1 : 0].camera && !stage.isOutside() &&
           !stage.isPass;
}

} // namespace

std::vector<PlaceBox> lessonFrames(const WindowState& ui, const ShownPane& shown) {
    std::vector<PlaceBox> frames;
    if (!showsLook(ui, shown)) return frames;
    for (const course::LookBox& box : ui.lesson.now->look)
        frames.push_back({shown.at(box.corner), shown.at(box.corner + box.size)});
    return frames;
}

void drawLessonMarks(ImDrawList& list, const WindowState& ui, const ShownPane& shown, const Theme& theme) {
    const LessonState& on = ui.lesson;
    if (!on.now) return;
    const course::ShownState& state = on.now->states[on.step == LessonStep::remedy ? 1 : 0];
    if (ui.bench.document().camera != state.camera) return;
    if (on.paints())
        drawCells(list, shown, [&](int x, int y) { return on.painted.isPainted(x, y) ? kPaint : ImU32{0}; });
    if (on.step == LessonStep::reveal && on.score)
        drawCells(list, shown, [&](int x, int y) {
            const auto cell = static_cast<std::size_t>(y * course::kPredictionSize.x + x);
            switch (on.score->cells[cell]) {
            case course::PredictedCell::right: return kPredictedRight;
            case course::PredictedCell::missed: return kPredictedMissed;
            case course::PredictedCell::wrong: return kPredictedWrong;
            default: return ImU32{0};
            }
        });
    if (!showsLook(ui, shown)) return;
    for (const course::LookBox& box : on.now->look)
        drawLook(list, box, shown, theme, on.step == LessonStep::artefact);
}

bool handlePainting(WindowState& ui, const std::vector<ShownPane>& panes) {
    if (!ui.lesson.paints() || panes.empty()) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const bool paints = wasDown(0), wipes = wasDown(1);
    if (io.WantCaptureMouse || (!paints && !wipes)) return false;
    const ShownPane& shown = panes.front();
    if (!shown.area.contains(io.MousePos)) return false;
    // Along the whole way since the last frame, so that fast strokes have no gaps.
    const dvec2 to = shown.placeAt({io.MousePos.x, io.MousePos.y});
    const bool begins = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1);
    const dvec2 from = begins ? to : shown.placeAt({io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y});
    const int steps = 1 + static_cast<int>(glm::length(to - from) / (0.5 * kBrush));
    for (int i = 0; i <= steps; ++i)
        ui.lesson.painted.paint(glm::mix(from, to, static_cast<double>(i) / steps), kBrush, paints);
    return true;
}

} // namespace shadowlab::window
