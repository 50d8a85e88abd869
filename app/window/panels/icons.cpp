// SPDX-License-Identifier: MIT
#include "app/window/panels/icons.h"

#include <algorithm>
#include <cmath>

#include "app/window/panels/widgets.h"

namespace shadowlab::window {

namespace {

constexpr float kInset = 0.22f; ///< of a button's side, between its edge and the icon
constexpr float kPi = 3.14159265f;

/// Draws in the unit square, y down.
struct Pen {
    ImDrawList& list;
    ImVec2 corner;
    float side;
    ImU32 color;
    [[nodiscard]] ImVec2 at(float x, float y) const { return {corner.x + x * side, corner.y + y * side}; }
    [[nodiscard]] float width() const { return std::max(1.0f, side * 0.11f); }
    void box(float x0, float y0, float x1, float y1) const { list.AddRect(at(x0, y0), at(x1, y1), color, 0, 0, width()); }
    void area(float x0, float y0, float x1, float y1) const { list.AddRectFilled(at(x0, y0), at(x1, y1), color); }
    void line(float x0, float y0, float x1, float y1) const { list.AddLine(at(x0, y0), at(x1, y1), color, width()); }
    void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const { list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), color); }
    /// Angles in radians from the right, clockwise as the screen counts.
    void arc(float x, float y, float radius, float from, float to) const {
        list.PathArcTo(at(x, y), radius * side, from, to, 16);
        list.PathStroke(color, 0, width());
    }
};

/// An arrow that turns back to the left; mirrored to the right.
void turn(const Pen& pen, bool mirrored) {
    const auto x = [&](float left) { return mirrored ? 1 - left : left; };
    pen.arc(0.5f, 0.62f, 0.34f, mirrored ? -0.95f * kPi : -0.85f * kPi + 0.0f, mirrored ? -0.15f * kPi : -0.05f * kPi);
    pen.line(x(0.84f), 0.58f, x(0.84f), 0.8f);
    pen.triangle({x(0.0f), 0.42f}, {x(0.42f), 0.42f}, {x(0.1f), 0.8f});
}

} // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 corner, float side, ImU32 color) {
    const Pen pen{list, corner, side, color};
    switch (icon) {
    case Icon::single: pen.box(0, 0.1f, 1, 0.9f); break;
    case Icon::side:
        pen.box(0, 0.1f, 0.46f, 0.9f);
        pen.box(0.56f, 0.1f, 1, 0.9f);
        break;
    case Icon::split:
        pen.box(0, 0.1f, 1, 0.9f);
        pen.area(0.52f, 0.1f, 1, 0.9f);
        break;
    case Icon::grid:
        for (const float x : {0.0f, 0.55f})
            for (const float y : {0.08f, 0.56f})
                pen.box(x, y, x + 0.43f, y + 0.38f);
        break;
    case Icon::difference: // two areas that overlap in part
        pen.box(0, 0.05f, 0.68f, 0.68f);
        pen.box(0.32f, 0.32f, 1, 0.95f);
        pen.area(0.32f, 0.32f, 0.68f, 0.68f);
        break;
    case Icon::play: pen.triangle({0.15f, 0.02f}, {0.15f, 0.98f}, {0.95f, 0.5f}); break;
    case Icon::pause:
        pen.area(0.14f, 0.05f, 0.4f, 0.95f);
        pen.area(0.6f, 0.05f, 0.86f, 0.95f);
        break;
    case Icon::undo: turn(pen, false); break;
    case Icon::redo: turn(pen, true); break;
    case Icon::save: // an arrow into a tray
        pen.line(0.5f, 0, 0.5f, 0.45f);
        pen.triangle({0.22f, 0.38f}, {0.78f, 0.38f}, {0.5f, 0.72f});
        pen.line(0.04f, 0.6f, 0.04f, 0.95f);
        pen.line(0, 0.95f, 1, 0.95f);
        pen.line(0.96f, 0.6f, 0.96f, 0.95f);
        break;
    case Icon::present: // a screen on its stand
        pen.box(0, 0.05f, 1, 0.65f);
        pen.line(0.5f, 0.65f, 0.5f, 0.8f);
        pen.line(0.22f, 0.95f, 0.5f, 0.72f);
        pen.line(0.78f, 0.95f, 0.5f, 0.72f);
        break;
    case Icon::help:
        pen.arc(0.5f, 0.3f, 0.26f, -kPi, 0.4f * kPi);
        pen.line(0.54f, 0.52f, 0.5f, 0.7f);
        list.AddCircleFilled(pen.at(0.5f, 0.92f), 0.09f * side, color);
        break;
    case Icon::panel:
        pen.box(0, 0.1f, 1, 0.9f);
        pen.area(0.64f, 0.1f, 1, 0.9f);
        break;
    case Icon::stages:
        pen.box(0, 0.05f, 1, 0.6f);
        for (const float x : {0.0f, 0.37f, 0.74f})
            pen.area(x, 0.72f, x + 0.26f, 0.97f);
        break;
    case Icon::lens:
        list.AddCircle(pen.at(0.4f, 0.4f), 0.34f * side, color, 0, pen.width());
        list.AddLine(pen.at(0.64f, 0.64f), pen.at(0.97f, 0.97f), color, 1.8f * pen.width());
        break;
    }
}

bool iconButton(const char* id, Icon icon, bool on, const char* help) {
    const float side = ImGui::GetFrameHeight();
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_HeaderActive]);
    ImGui::PushID(id);
    const bool pressed = ImGui::Button("##icon", {side * 1.15f, side});
    ImGui::PopID();
    if (on) ImGui::PopStyleColor();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float room = side * (1 - 2 * kInset);
    drawIcon(*ImGui::GetWindowDrawList(), icon,
             {std::round((low.x + high.x - room) / 2), std::round((low.y + high.y - room) / 2)}, room,
             on ? kAccent : ImGui::GetColorU32(ImGuiCol_Text));
    hint(help);
    return pressed;
}

} // namespace shadowlab::window
