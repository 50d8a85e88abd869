// SPDX-License-Identifier: MIT
#include "app/window/pictures.h"

#include <algorithm>
#include <cmath>

#include "app/window/gizmo.h"
#include "app/window/imgui_bridge.h"
#include "app/window/object_places.h"
#include "app/window/panels/legend.h"
#include "app/window/panels/lesson_marks.h"
#include "app/window/panels/panels.h"
#include "app/window/picture_view.h"
#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

using picture::Layout;

constexpr float kHalfSplitLine = 2;   ///< pixels
constexpr float kSplitKnobEm = 0.55f; ///< radius of what the split line is taken hold of by
constexpr ImU32 kPartnerRing = IM_COL32(0x56, 0xB4, 0xE9, 0xFF); ///< look::kPatchK, as kAccent is look::kPatchJ

void drawFitted(ImDrawList& list, const gl::Texture2D& texture, const Area& area) {
    const PlaceBox box = fittedPicture(imVec(texture.size()), area);
    list.AddImage(imguiTexture(texture), box.low, box.high, {0, 1}, {1, 0});
}

/// Draws in the place of the whole picture; verdicts are transparent where they say nothing.
void drawWhole(ImDrawList& list, const gl::Texture2D& texture, const ShownPane& shown, bool opaque) {
    const ImVec2 low = shown.pictureCorner, high(low.x + shown.pictureSize.x, low.y + shown.pictureSize.y);
    if (opaque)
        addOpaqueImage(list, texture, low, high);
    else
        list.AddImage(imguiTexture(texture), low, high, {0, 1}, {1, 0});
}

constexpr ImU32 kDimmed = IM_COL32(0, 0, 0, 150); ///< over a picture that is not yet what the pane's header says

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
void drawJudged(ImDrawList& list, const lab::JudgedPicture* judged, const lab::Pane& pane, const ShownPane& shown,
                const Theme& theme) {
    if (!judged) {
        if (pane.picture().texture) drawWhole(list, pane.picture().texture, shown, true);
        return;
    }
    if (judged->ground) drawWhole(list, judged->ground, shown, true);
    if (judged->verdicts) drawWhole(list, judged->verdicts, shown, false);
    drawLegend(list, judged->legend, shown.footer, theme);
}

/// A ring with four strokes around a pixel: none of them covers it.
void drawRing(ImDrawList& list, ImVec2 at, ImU32 ring, float radius) {
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
    const lab::Document& document = ui.bench.document();
    if (document.partner && ui.bench.pane(shown.pane).showsTheEyesView())
        drawRing(list, shown.at(*document.partner), kPartnerRing, 0.8f * theme.em);
    if (const auto at = pickedPlace(ui, shown)) drawRing(list, *at, kAccent, 0.55f * theme.em);
}

/// In a pane without a header, at its lower right: what is not finished yet.
void drawProgress(ImDrawList& list, const std::string& progress, const ShownPane& shown, const Theme& theme) {
    if (progress.empty()) return;
    const ImVec2 size = theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, progress.c_str());
    const ImVec2 high = imVec(shown.area.corner + shown.area.size);
    const ImVec2 corner(high.x - size.x - theme.em * 0.5f, high.y - size.y - theme.em * 0.25f);
    list.AddRectFilled({corner.x - theme.em * 0.4f, corner.y - theme.em * 0.2f}, high, kPlateColor);
    list.AddText(theme.text, theme.em, corner, kPlateText, progress.c_str());
}

/// Does the pane show verdicts, or wait for them?
bool isJudged(const WindowState& ui, int pane) {
    const lab::Document& document = ui.bench.document();
    return document.layout == Layout::diff || document.panes[static_cast<std::size_t>(pane)].stage.isJudged();
}

/// Where the split line lies over the panes it is not to be written.
void takeSplitLine(FreePlaces& places, const WindowState& ui, const Area& area, const Theme& theme) {
    if (!hasSplitLine(ui)) return;
    const float x = splitLineX(ui, area), y = static_cast<float>(area.corner.y) + static_cast<float>(area.size.y) / 2;
    places.take(PlaceBox::around({x, y}, kSplitKnobEm * theme.em + 2), FreePlaces::kSign);
}

PaneSigns drawPane(ImDrawList& list, WindowState& ui, const lab::LiveErrors& errors, const ShownPane& shown, const PaneFrames& frames,
                   const Theme& theme) {
    const lab::Pane& pane = ui.bench.pane(shown.pane);
    const ImVec2 low = imVec(shown.area.corner), high = imVec(shown.area.corner + shown.area.size);
    list.PushClipRect(low, high, true);
    if (!pane.picture().texture || pane.picture().texture.size() != pane.drawnFor().view.size)
        list.AddRectFilled(low, high, IM_COL32(12, 12, 14, 255));
    list.PopClipRect();
    list.PushClipRect(low, {high.x, high.y + static_cast<float>(shown.footer.size.y)}, true);
    const bool judged = isJudged(ui, shown.pane);
    const gl::Texture2D& texture = pane.picture().texture;
    if (judged)
        drawJudged(list, errors.shownOn(ui.bench.document(), shown.pane), pane, shown, theme);
    else if (texture && pane.showsTheEyesView())
        drawWhole(list, texture, shown, true);
    else if (texture)
        drawFitted(list, texture, shown.area);
    if (!judged && !pane.showsAnother()) drawLegend(list, pane.picture(), shown.footer, theme);
    list.PopClipRect();

    list.PushClipRect(low, high, true);
    FreePlaces places = placesBesideThings(ui, shown, theme);
    takeSplitLine(places, ui, frames.pictures(), theme);
    for (const PlaceBox& frame : lessonFrames(ui, shown))
        places.take(frame, FreePlaces::kSign);
    std::vector<PlaceBox> names = drawGizmos(list, ui, shown, places, theme);
    drawPicked(list, ui, shown, theme);
    if (const auto& partner = ui.bench.document().partner; partner && pane.showsTheEyesView())
        places.take(PlaceBox::around(shown.at(*partner), 1.4f * theme.em), FreePlaces::kSign);
    if (const auto glass = ui.shown.magnifier ? glassOver(shown, ivec2(0), theme) : std::nullopt) { // wherever it looks
        const auto side = static_cast<float>(glass->cell * glass->across);
        const ImVec2 low = glass->corner;
        places.take({{low.x, low.y - 1.5f * theme.em}, {low.x + side, low.y + side}}, FreePlaces::kSign); // with its label
    }
    PaneSigns signs{shown.pane, std::move(places), std::move(names), {}};
    signs.card = probeCard(ui, shown, signs.places, theme);
    drawLessonMarks(list, ui, shown, theme);
    if (pane.showsAnother() && pane.failure().empty()) {
        list.AddRectFilled(low, high, kDimmed);
        drawNote(list, shown, progressOf(ui, errors, shown.pane).front(), kPlateText, theme);
    }
    drawNote(list, shown, pane.failure(), kAccent, theme);
    if (frames.header == 0) drawProgress(list, progressOf(ui, errors, shown.pane).front(), shown, theme);
    list.PopClipRect();
    return signs;
}

void drawSplitLine(ImDrawList& list, const WindowState& ui, const Area& area, const Theme& theme) {
    const float x = splitLineX(ui, area), top = static_cast<float>(area.corner.y),
                bottom = top + static_cast<float>(area.size.y), middle = (top + bottom) / 2;
    // A dark line and a light one: one of them is seen on any picture.
    list.AddRectFilled({x - kHalfSplitLine, top}, {x, bottom}, IM_COL32(16, 16, 18, 255));
    list.AddRectFilled({x, top}, {x + kHalfSplitLine, bottom}, kPlateText);
    const float r = theme.em * kSplitKnobEm;
    list.AddCircleFilled({x, middle}, r + 2, IM_COL32(16, 16, 18, 255));
    list.AddCircleFilled({x, middle}, r, kPlateText);
    list.AddTriangleFilled({x - r * 0.7f, middle}, {x - r * 0.15f, middle - r * 0.45f},
                           {x - r * 0.15f, middle + r * 0.45f}, IM_COL32(16, 16, 18, 255));
    list.AddTriangleFilled({x + r * 0.7f, middle}, {x + r * 0.15f, middle - r * 0.45f},
                           {x + r * 0.15f, middle + r * 0.45f}, IM_COL32(16, 16, 18, 255));
}

} // namespace

std::vector<std::string> progressOf(const WindowState& ui, const lab::LiveErrors& errors, int number) {
    const lab::Pane& pane = ui.bench.pane(number);
    if (!pane.failure().empty()) return {""};
    if (pane.progress() < 1) {
        const std::string percent = std::to_string(static_cast<int>(100 * pane.progress())) + " %";
        return {"preparing: " + percent, percent};
    }
    if (ui.bench.draft() > 1) {
        const std::string count = std::to_string(ui.bench.draft() * ui.bench.draft());
        return {"while it moves: one pixel for " + count, "1 pixel for " + count};
    }
    if (pane.drawnShare() < 1 || pane.showsAnother()) {
        const std::string percent = std::to_string(static_cast<int>(100 * pane.drawnShare())) + " %";
        return {"drawing: " + percent, percent};
    }
    const bool waits = isJudged(ui, number) && !errors.shownOn(ui.bench.document(), number);
    return waits ? std::vector<std::string>{"finding the exact answer ...", "judging ..."} : std::vector<std::string>{""};
}

std::vector<PaneSigns> drawPictures(WindowState& ui, const lab::LiveErrors& errors, const std::vector<ShownPane>& panes,
                                    const PaneFrames& frames, const Theme& theme) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    std::vector<PaneSigns> signs;
    for (const ShownPane& pane : panes)
        signs.push_back(drawPane(list, ui, errors, pane, frames, theme));
    for (const ShownPane& pane : panes) { // the lines between panes that stand side by side
        if (hasSplitLine(ui) || pane.area.corner.x == frames.whole.corner.x) continue;
        const ImVec2 low = imVec(pane.area.corner);
        list.AddLine(low, {low.x, low.y + static_cast<float>(pane.area.size.y)}, kPlateText, 2);
    }
    if (hasSplitLine(ui)) drawSplitLine(list, ui, frames.pictures(), theme);
    // Last, for in the split picture the pixel may lie beyond the line.
    for (const PaneSigns& one : signs)
        if (one.card) drawProbeCard(list, *one.card, theme);
    return signs;
}

} // namespace shadowlab::window
