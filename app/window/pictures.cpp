// SPDX-License-Identifier: MIT
#include "app/window/pictures.h"

#include <algorithm>
#include <cmath>

#include "app/window/gizmo.h"
#include "app/window/imgui_bridge.h"
#include "app/window/panels/legend.h"
#include "app/window/panels/lesson_marks.h"
#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

using picture::Layout;

constexpr double kBlinkSeconds = 0.6; ///< of each picture: slow enough to see it, quick enough that differences jump
constexpr float kHalfSplitLine = 2;   ///< pixels
constexpr ImU32 kPartnerRing = IM_COL32(0x56, 0xB4, 0xE9, 0xFF); ///< look::kPatchK, as kAccent is look::kPatchJ

std::string titleOf(const WindowState& ui, int pane) {
    const lab::PaneState& state = ui.bench.document().panes[static_cast<std::size_t>(pane)];
    const lab::Pane& drawn = ui.bench.pane(pane);
    std::string title(findTechnique(state.technique).title);
    // Of one technique twice, the settings say which is which.
    const int others = lab::shownPanes(ui.bench.document().layout);
    bool twice = false;
    for (int other = 0; other < others; ++other)
        twice = twice || (other != pane &&
                          ui.bench.document().panes[static_cast<std::size_t>(other)].technique == state.technique);
    if (twice)
        for (const auto& [param, value] : state.values())
            title += "\n" + param + " = " + value;
    if (!drawn.picture().caption.empty() && !state.stage.isPicture()) title += "\n" + drawn.picture().caption;
    return title;
}

/// A title in the upper left corner, wrapped where the pane is too narrow for it.
void drawPlate(ImDrawList& list, ImVec2 corner, float widest, const std::string& text, const Theme& theme,
               bool active) {
    const float mark = theme.em * 0.2f, pad = theme.em * 0.4f, room = std::max(theme.em, widest - 2 * pad - mark);
    const ImVec2 size = theme.heading->CalcTextSizeA(theme.headingSize, FLT_MAX, room, text.c_str());
    const ImVec2 end(corner.x + size.x + 2 * pad + mark, corner.y + size.y + 2 * pad);
    list.AddRectFilled(corner, end, kPlateColor);
    if (active) list.AddRectFilled(corner, {corner.x + std::max(3.0f, mark), end.y}, kAccent);
    list.AddText(theme.heading, theme.headingSize, {corner.x + pad + mark, corner.y + pad}, kPlateText, text.c_str(),
                 nullptr, room);
}

/// The picture of a size of its own, a light's view of the scene, as large as fits, in the middle.
void drawFitted(ImDrawList& list, const gl::Texture2D& texture, const Area& area) {
    const ImVec2 size = imVec(texture.size());
    const float scale = std::min(static_cast<float>(area.size.x) / size.x, static_cast<float>(area.size.y) / size.y);
    const ImVec2 shown(size.x * scale, size.y * scale);
    const ImVec2 corner(
        std::round(static_cast<float>(area.corner.x) + (static_cast<float>(area.size.x) - shown.x) / 2),
        std::round(static_cast<float>(area.corner.y) + (static_cast<float>(area.size.y) - shown.y) / 2));
    list.AddImage(imguiTexture(texture), corner, {corner.x + shown.x, corner.y + shown.y}, {0, 1}, {1, 0});
}

/// Draws in the place of the whole picture; verdicts are transparent where they say nothing.
void drawWhole(ImDrawList& list, const gl::Texture2D& texture, const ShownPane& shown, bool opaque) {
    const ImVec2 low = shown.pictureCorner, high(low.x + shown.pictureSize.x, low.y + shown.pictureSize.y);
    if (opaque)
        addOpaqueImage(list, texture, low, high);
    else
        list.AddImage(imguiTexture(texture), low, high, {0, 1}, {1, 0});
}

/// A sentence in the middle of the pane, on a plate.
void drawNote(ImDrawList& list, const ShownPane& shown, const std::string& note, ImU32 color, const Theme& theme) {
    const float width = static_cast<float>(shown.area.size.x) - 2 * theme.em;
    if (note.empty() || width < theme.em) return;
    const ImVec2 size = theme.text->CalcTextSizeA(theme.em, FLT_MAX, width, note.c_str());
    const ImVec2 low = imVec(shown.area.corner);
    const ImVec2 corner(low.x + (static_cast<float>(shown.area.size.x) - size.x) / 2,
                        low.y + (static_cast<float>(shown.area.size.y) - size.y) / 2);
    list.AddRectFilled({corner.x - theme.em / 2, corner.y - theme.em / 2},
                       {corner.x + size.x + theme.em / 2, corner.y + size.y + theme.em / 2}, kPlateColor);
    list.AddText(theme.text, theme.em, corner, color, note.c_str(), nullptr, width);
}

/// The verdicts on a stage that is judged in the background, or its ground as long as there are none.
void drawJudged(ImDrawList& list, const lab::JudgedPicture* judged, const lab::Pane& pane, ShownPane& shown,
                const Theme& theme) {
    if (!judged) {
        if (pane.picture().texture) drawWhole(list, pane.picture().texture, shown, true);
        drawNote(list, shown, "finding the exact answer ...", kPlateText, theme);
        return;
    }
    if (judged->ground) drawWhole(list, judged->ground, shown, true);
    if (judged->verdicts) drawWhole(list, judged->verdicts, shown, false);
    shown.legendSize = drawLegend(list, judged->legend, true, shown.area.corner, shown.area.size, theme);
}

std::string noteOf(const WindowState& ui, const lab::Pane& pane) {
    if (!pane.failure().empty()) return pane.failure();
    if (pane.progress() < 1) return "preparing: " + std::to_string(static_cast<int>(100 * pane.progress())) + " %";
    return ui.bench.draft() > 1 ? "while it moves: one pixel for " + std::to_string(ui.bench.draft() * ui.bench.draft())
                                : "";
}

/// A ring with four strokes around a pixel: none of them covers it.
void drawRing(ImDrawList& list, const ShownPane& shown, const dvec2& picked, ImU32 ring, float radius) {
    const ImVec2 at(shown.pictureCorner.x + static_cast<float>(picked.x) * shown.pictureSize.x,
                    shown.pictureCorner.y + static_cast<float>(picked.y) * shown.pictureSize.y);
    for (const bool rim : {true, false}) {
        const ImU32 color = rim ? IM_COL32(16, 16, 18, 255) : ring;
        const float width = rim ? 5.0f : 2.5f;
        list.AddCircle(at, radius, color, 0, width);
        for (const ImVec2& way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
            list.AddLine({at.x + way.x * radius, at.y + way.y * radius},
                         {at.x + 1.7f * way.x * radius, at.y + 1.7f * way.y * radius}, color, width);
    }
}

/// Around the picked pixels, each in a colour and a size of its own: both are seen where they are one.
void drawPicked(ImDrawList& list, const WindowState& ui, const ShownPane& shown, const Theme& theme) {
    if (!ui.bench.pane(shown.pane).showsTheEyesView()) return;
    const lab::Document& document = ui.bench.document();
    if (document.partner) drawRing(list, shown, *document.partner, kPartnerRing, 0.8f * theme.em);
    if (document.picked) drawRing(list, shown, *document.picked, kAccent, 0.55f * theme.em);
}

void drawPane(ImDrawList& list, WindowState& ui, const lab::LiveErrors& errors, ShownPane& shown, const Theme& theme) {
    const lab::Pane& pane = ui.bench.pane(shown.pane);
    const lab::Document& document = ui.bench.document();
    const ImVec2 low = imVec(shown.area.corner), high = imVec(shown.area.corner + shown.area.size);
    list.PushClipRect(low, high, true);
    if (!pane.picture().texture || pane.picture().texture.size() != pane.drawnFor().view.size)
        list.AddRectFilled(low, high, IM_COL32(12, 12, 14, 255));
    std::string title = titleOf(ui, shown.pane);
    bool legend = false;
    if (document.layout == Layout::diff) {
        title += " against " + titleOf(ui, 1 - shown.pane);
        drawJudged(list, errors.difference(), pane, shown, theme);
    } else if (document.panes[static_cast<std::size_t>(shown.pane)].stage.isJudged()) {
        drawJudged(list, errors.picture(shown.pane), pane, shown, theme);
    } else if (const gl::Texture2D& texture = pane.picture().texture) {
        if (pane.showsTheEyesView())
            drawWhole(list, texture, shown, true);
        else
            drawFitted(list, texture, shown.area);
        legend = true;
    }
    if (!ui.lesson.isOn())
        drawGizmos(list, ui, shown, theme); // under the plates: a title has to be read, a handle can be moved
    drawPicked(list, ui, shown, theme);
    if (legend) shown.legendSize = drawLegend(list, pane.picture(), false, shown.area.corner, shown.area.size, theme);
    const bool active = shown.pane == document.active && document.layout != Layout::single;
    // Clear of the split line, half of which lies on the pane to its right.
    const float beside = hasSplitLine(ui) && shown.area.corner.x > 0 ? kHalfSplitLine : 0;
    drawPlate(list, {low.x + beside, low.y}, high.x - low.x - beside, title, theme, active);
    drawLessonMarks(list, ui, shown, theme);
    drawNote(list, shown, noteOf(ui, pane), pane.failure().empty() ? kPlateText : kAccent, theme);
    list.PopClipRect();
}

void drawSplitLine(ImDrawList& list, const WindowState& ui, const Area& area, const Theme& theme) {
    const float x = splitLineX(ui, area), top = static_cast<float>(area.corner.y),
                bottom = top + static_cast<float>(area.size.y), middle = (top + bottom) / 2;
    // A dark line and a light one: one of them is seen on any picture.
    list.AddRectFilled({x - kHalfSplitLine, top}, {x, bottom}, IM_COL32(16, 16, 18, 255));
    list.AddRectFilled({x, top}, {x + kHalfSplitLine, bottom}, kPlateText);
    const float r = theme.em * 0.55f;
    list.AddCircleFilled({x, middle}, r + 2, IM_COL32(16, 16, 18, 255));
    list.AddCircleFilled({x, middle}, r, kPlateText);
    list.AddTriangleFilled({x - r * 0.7f, middle}, {x - r * 0.15f, middle - r * 0.45f},
                           {x - r * 0.15f, middle + r * 0.45f}, IM_COL32(16, 16, 18, 255));
    list.AddTriangleFilled({x + r * 0.7f, middle}, {x + r * 0.15f, middle - r * 0.45f},
                           {x + r * 0.15f, middle + r * 0.45f}, IM_COL32(16, 16, 18, 255));
}

} // namespace

float splitLineX(const WindowState& ui, const Area& area) {
    return std::round(static_cast<float>(area.corner.x) +
                      static_cast<float>(ui.bench.document().split) * static_cast<float>(area.size.x));
}

bool hasSplitLine(const WindowState& ui) { return ui.bench.document().layout == Layout::split && !ui.shown.blink; }

std::vector<ShownPane> shownPanes(const WindowState& ui, const Area& area, double seconds) {
    std::vector<ShownPane> panes;
    for (const lab::PlacedPane& placed : ui.bench.placed(area.size)) {
        const picture::Cell& cell = placed.cell;
        ShownPane shown;
        shown.pane = placed.pane;
        shown.area = {area.corner + ivec2(cell.x, cell.y), {cell.width, cell.height}};
        shown.pictureCorner = imVec(shown.area.corner - ivec2(cell.cropX, 0));
        shown.pictureSize = imVec(cell.pictureSize);
        panes.push_back(shown);
    }
    if (ui.bench.document().layout == Layout::diff && panes.size() > 1) panes.pop_back(); // one picture of both
    if (ui.shown.blink && panes.size() >= 2) {
        const int turn = static_cast<int>(seconds / kBlinkSeconds) % 2;
        ShownPane shown = panes[static_cast<std::size_t>(turn)];
        shown.area = area;
        shown.pictureCorner = imVec(area.corner);
        shown.pictureSize = imVec(area.size);
        return {shown};
    }
    return panes;
}

void drawPictures(WindowState& ui, const lab::LiveErrors& errors, std::vector<ShownPane>& panes, const Area& area,
                  const Theme& theme) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (ShownPane& pane : panes)
        drawPane(list, ui, errors, pane, theme);
    for (const ShownPane& pane : panes) { // the lines between panes of the grid
        if (hasSplitLine(ui)) break;
        const ImVec2 low = imVec(pane.area.corner);
        if (pane.area.corner.x > area.corner.x)
            list.AddLine(low, {low.x, low.y + static_cast<float>(pane.area.size.y)}, kPlateText, 2);
        if (pane.area.corner.y > area.corner.y)
            list.AddLine(low, {low.x + static_cast<float>(pane.area.size.x), low.y}, kPlateText, 2);
    }
    if (hasSplitLine(ui)) drawSplitLine(list, ui, area, theme);
}

} // namespace shadowlab::window
