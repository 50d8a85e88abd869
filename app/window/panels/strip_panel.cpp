// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <string>

#include "app/window/panels/widgets.h"
#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

constexpr int kCaptionLines = 3;
constexpr float kThumbnailEm = 5.5f, kLeastThumbnailEm = 3; ///< heights of a small picture
constexpr float kCaptionLineEm = 0.95f;

/// The picture in the middle of a frame of that size, its proportions kept.
void drawInFrame(ImDrawList& list, const lab::PanePicture& picture, ImVec2 corner, ImVec2 frame) {
    list.AddRectFilled(corner, {corner.x + frame.x, corner.y + frame.y}, IM_COL32(12, 12, 14, 255));
    if (!picture.texture) return;
    const ImVec2 size = imVec(picture.texture.size());
    const float scale = std::min(frame.x / size.x, frame.y / size.y);
    const ImVec2 low(corner.x + (frame.x - size.x * scale) / 2, corner.y + (frame.y - size.y * scale) / 2);
    list.AddImage(imguiTexture(picture.texture), low, {low.x + size.x * scale, low.y + size.y * scale}, {0, 1}, {1, 0});
}

/// How far a picture has come that is still to be drawn, or to be refined. On a plate, where there is something under it.
void drawWord(ImDrawList& list, const lab::Thumbnail& thumbnail, double progress, ImVec2 corner, ImVec2 frame,
              const Theme& theme) {
    if (!thumbnail.isToCome) return;
    const bool isEmpty = !thumbnail.picture.texture;
    const std::string word = std::to_string(static_cast<int>(100 * progress)) + " %";
    const float small = theme.em * 0.85f, pad = theme.em * 0.2f, wrap = frame.x - 2 * pad;
    const ImVec2 extent = theme.text->CalcTextSizeA(small, FLT_MAX, wrap, word.c_str());
    const ImVec2 low = isEmpty ? ImVec2(corner.x + (frame.x - extent.x) / 2, corner.y + (frame.y - extent.y) / 2)
                               : ImVec2(corner.x + frame.x - extent.x - pad, corner.y + frame.y - extent.y - pad);
    if (!isEmpty) list.AddRectFilled({low.x - pad, low.y}, {corner.x + frame.x, corner.y + frame.y}, kPlateColor);
    list.AddText(theme.text, small, low, isEmpty ? ImGui::GetColorU32(ImGuiCol_TextDisabled) : kPlateText, word.c_str(), nullptr,
                 wrap);
}

} // namespace

StripShape stripShape(const Theme& theme, float most) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float rim = 2 * style.WindowPadding.y + style.ScrollbarSize + theme.em * 0.3f;
    StripShape shape;
    shape.captionLines = kCaptionLines;
    const auto pictureHeight = [&] { return most - rim - static_cast<float>(shape.captionLines) * kCaptionLineEm * theme.em; };
    while (shape.captionLines > 1 && pictureHeight() < kThumbnailEm * theme.em) // words go first: the tooltip has them
        --shape.captionLines;
    const float height = std::clamp(pictureHeight(), kLeastThumbnailEm * theme.em, kThumbnailEm * theme.em);
    shape.thumbnail = {static_cast<int>(height) * 16 / 9, static_cast<int>(height)};
    shape.height = static_cast<int>(height + rim + static_cast<float>(shape.captionLines) * kCaptionLineEm * theme.em);
    return shape;
}

void stripPanel(WindowState& ui, const lab::StageStrip& strip, const Area& area, const StripShape& shape,
                const Theme& theme) {
    ImGui::SetNextWindowPos(imVec(area.corner));
    ImGui::SetNextWindowSize(imVec(area.size));
    ImGui::Begin("stages", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_HorizontalScrollbar |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    const picture::StageRef now = ui.bench.activeState().stage.ofAnyLight();
    const ImVec2 frame = imVec(shape.thumbnail);
    const float small = theme.em * 0.85f;
    int number = 0;
    for (const lab::Thumbnail& thumbnail : strip.thumbnails()) {
        if (number > 0) ImGui::SameLine();
        ImGui::PushID(number++);
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const ImVec2 size(frame.x, frame.y + static_cast<float>(shape.captionLines) * kCaptionLineEm * theme.em);
        if (ImGui::InvisibleButton("stage", size)) chooseStage(ui, thumbnail.stage);
        const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemFocused(), chosen = thumbnail.stage == now;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        drawInFrame(list, thumbnail.picture, corner, frame);
        drawWord(list, thumbnail, strip.progress(), corner, frame, theme);
        list.AddRect(corner, {corner.x + frame.x, corner.y + frame.y},
                     chosen || hovered ? kAccent : ImGui::GetColorU32(ImGuiCol_Border), 0, 0, chosen ? 3.0f : 1.0f);
        const std::string caption = shape.captionLines == 1 ? cutTo(thumbnail.caption, frame.x, small) : thumbnail.caption;
        list.PushClipRect({corner.x, corner.y + frame.y}, {corner.x + size.x, corner.y + size.y}, true);
        list.AddText(theme.text, small, {corner.x, corner.y + frame.y + theme.em * 0.15f},
                     chosen ? kAccent : ImGui::GetColorU32(ImGuiCol_Text), caption.c_str(), nullptr, frame.x);
        list.PopClipRect();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", thumbnail.caption.c_str());
        ImGui::PopID();
    }
    ImGui::End();
}

} // namespace shadowlab::window
