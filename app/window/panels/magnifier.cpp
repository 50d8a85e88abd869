// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

constexpr int kPixelsAcross = 17; ///< of the picture, odd: one of them is in the middle
constexpr float kShareOfPane = 0.42f, kLargestEm = 17;
constexpr float kEdgeEm = 0.7f; ///< between the glass and what is around it

/// What of the pane is enlarged, from below to above, all of one size: its picture, or what a judged stage has in its place.
std::vector<const gl::Texture2D*> layersOf(const WindowState& ui, const lab::LiveErrors& errors, int pane) {
    std::vector<const gl::Texture2D*> layers;
    const auto add = [&](const gl::Texture2D& texture) {
        if (texture) layers.push_back(&texture);
    };
    if (const lab::JudgedPicture* const judged = errors.shownOn(ui.bench.document(), pane)) {
        add(judged->ground);
        add(judged->onePixelEach ? judged->onePixelEach : judged->verdicts);
    } else {
        add(ui.bench.pane(pane).picture().texture);
    }
    return layers;
}

void drawGlass(ImDrawList& list, const std::vector<const gl::Texture2D*>& layers, const Glass& glass, const ShownPane& pane,
               ivec2 middle, const Theme& theme) {
    const ImVec2 low = glass.corner;
    const int cell = glass.cell;
    const auto side = static_cast<float>(cell * glass.across);
    const ImVec2 high(low.x + side, low.y + side);
    const ivec2 size = layers.front()->size(), first = glass.firstPixel, last = first + glass.across;
    list.AddRectFilled({low.x - 3, low.y - 3}, {high.x + 3, high.y + 3}, IM_COL32(16, 16, 18, 255));
    list.PushClipRect(low, high, true);
    // Beyond the picture's edge its last pixels would be repeated: only what there is of it is drawn.
    const ivec2 from = glm::clamp(first, ivec2(0), size), to = glm::clamp(last, ivec2(0), size);
    const auto place = [&](ivec2 pixel) {
        return ImVec2(low.x + static_cast<float>((pixel.x - first.x) * cell),
                      low.y + static_cast<float>((pixel.y - first.y) * cell));
    };
    const auto uv = [&](ivec2 pixel) {
        return ImVec2(static_cast<float>(pixel.x) / static_cast<float>(size.x),
                      1 - static_cast<float>(pixel.y) / static_cast<float>(size.y));
    };
    if (to.x > from.x && to.y > from.y)
        for (const gl::Texture2D* const layer : layers)
            list.AddImage(imguiTexture(*layer), place(from), place(to), uv(from), uv(to));
    for (int i = 0; i <= glass.across; ++i) { // the grid between pixels: seen on light and on dark ones
        const auto at = static_cast<float>(i * cell);
        list.AddLine({low.x + at, low.y}, {low.x + at, high.y}, IM_COL32(128, 128, 128, 110));
        list.AddLine({low.x, low.y + at}, {high.x, low.y + at}, IM_COL32(128, 128, 128, 110));
    }
    const ImVec2 mark = place(middle);
    const auto c = static_cast<float>(cell);
    list.AddRect({mark.x - 1, mark.y - 1}, {mark.x + c + 1, mark.y + c + 1}, IM_COL32(16, 16, 18, 255), 0, 0, 3);
    list.AddRect(mark, {mark.x + c, mark.y + c}, kAccent, 0, 0, 2);
    list.PopClipRect();
    const std::string label = "pixel " + std::to_string(middle.x) + ", " + std::to_string(middle.y);
    const ImVec2 extent = theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, label.c_str());
    const auto right = static_cast<float>(pane.area.corner.x + pane.area.size.x);
    const float at = std::min(low.x, right - extent.x - kEdgeEm * theme.em); // a small glass is narrower than it
    list.AddRectFilled({at - 3, low.y - 3 - extent.y}, {at + extent.x + 5, low.y - 3}, kPlateColor);
    list.AddText(theme.text, theme.em, {at, low.y - 3 - extent.y}, kPlateText, label.c_str());
}

} // namespace

std::optional<Glass> glassOver(const ShownPane& pane, ivec2 middle, const Theme& theme) {
    const auto width = static_cast<float>(pane.area.size.x), height = static_cast<float>(pane.area.size.y);
    const float edge = kEdgeEm * theme.em;
    const float most = std::min(kShareOfPane * std::min(width, height), kLargestEm * theme.em);
    const auto cell = static_cast<int>(most / kPixelsAcross);
    if (cell < 2) return std::nullopt;
    const auto side = static_cast<float>(cell * kPixelsAcross);
    const ivec2 end = pane.area.corner + pane.area.size;
    return Glass{{static_cast<float>(end.x) - side - edge, static_cast<float>(end.y) - side - edge},
                 cell,
                 kPixelsAcross,
                 middle - kPixelsAcross / 2};
}

void drawMagnifiers(WindowState& ui, const lab::LiveErrors& errors, const std::vector<ShownPane>& panes, const Theme& theme) {
    if (!ui.shown.magnifier) return;
    const ImGuiIO& io = ImGui::GetIO();
    for (const ShownPane& pane : panes)
        if (pane.area.contains(io.MousePos) && !io.WantCaptureMouse)
            ui.lens = dvec2((io.MousePos.x - pane.pictureCorner.x) / pane.pictureSize.x,
                            (io.MousePos.y - pane.pictureCorner.y) / pane.pictureSize.y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const ShownPane& pane : panes) {
        const std::vector<const gl::Texture2D*> layers = layersOf(ui, errors, pane.pane);
        if (layers.empty()) continue;
        const ivec2 size = layers.front()->size();
        const ivec2 middle = glm::clamp(ivec2(glm::floor(ui.lens * dvec2(size))), ivec2(0), size - 1);
        if (const std::optional<Glass> glass = glassOver(pane, middle, theme))
            drawGlass(list, layers, *glass, pane, middle, theme);
        // Where in the picture that is, for the panes in which the mouse is not.
        const ImVec2 at(pane.pictureCorner.x + static_cast<float>(ui.lens.x) * pane.pictureSize.x,
                        pane.pictureCorner.y + static_cast<float>(ui.lens.y) * pane.pictureSize.y);
        list.PushClipRect({static_cast<float>(pane.area.corner.x), static_cast<float>(pane.area.corner.y)},
                          {static_cast<float>(pane.area.corner.x + pane.area.size.x),
                           static_cast<float>(pane.area.corner.y + pane.area.size.y)},
                          true);
        list.AddRect({at.x - theme.em * 0.6f, at.y - theme.em * 0.6f}, {at.x + theme.em * 0.6f, at.y + theme.em * 0.6f},
                     IM_COL32(16, 16, 18, 255), 0, 0, 3);
        list.AddRect({at.x - theme.em * 0.6f, at.y - theme.em * 0.6f}, {at.x + theme.em * 0.6f, at.y + theme.em * 0.6f},
                     kPlateText, 0, 0, 1);
        list.PopClipRect();
    }
}

} // namespace shadowlab::window
