// SPDX-License-Identifier: MIT
#include "app/window/picture_mouse.h"

#include <algorithm>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/lab/camera_control.h"
#include "app/window/imgui_bridge.h"

namespace shadowlab::window {

namespace {

constexpr float kLineGrip = 0.6f; ///< em to either side of the split line that take hold of it
constexpr double kOrbitDegrees = 200, kTurnHeadDegrees = 90; ///< for a drag over the whole height of the picture
constexpr double kWheelFactor = 0.88;

/// The pixel of what the eye sees there, and its pane.
void pickPixel(WindowState& ui, const std::vector<ShownPane>& panes, ImVec2 place, bool asPartner) {
    for (const ShownPane& shown : panes) {
        if (!shown.area.contains(place) || !ui.bench.pane(shown.pane).showsTheEyesView()) continue;
        ui.bench.activate(shown.pane);
        // The middle of the pixel: its edge may be rounded to either side.
        const dvec2 picked = shown.placeAt(dvec2(place.x, place.y) + 0.5);
        if (asPartner)
            ui.bench.pickPartner(picked);
        else
            ui.bench.pick(picked);
    }
}

} // namespace

ImVec2 pressPlace(const WindowState& ui) {
    if (!ui.pressedAt) return ImGui::GetIO().MousePos;
    return {static_cast<float>(ui.pressedAt->x), static_cast<float>(ui.pressedAt->y)};
}

bool isOnSplitLine(const WindowState& ui, const Area& pictures, ImVec2 place, const Theme& theme) {
    return hasSplitLine(ui) && pictures.contains(place) && std::abs(place.x - splitLineX(ui, pictures)) <= kLineGrip * theme.em;
}

bool isOnSplitKnob(const WindowState& ui, const Area& pictures, ImVec2 place, const Theme& theme) {
    const float middle = static_cast<float>(pictures.corner.y) + 0.5f * static_cast<float>(pictures.size.y);
    return isOnSplitLine(ui, pictures, place, theme) && std::abs(place.y - middle) <= kLineGrip * theme.em;
}

bool handleMouse(WindowState& ui, const std::vector<ShownPane>& panes, const Area& area, const Theme& theme) {
    const ImGuiIO& io = ImGui::GetIO();
    static_assert(ImGuiMouseButton_Left == 0);
    const ImVec2 place = pressPlace(ui);
    const bool over = area.contains(place) && !io.WantCaptureMouse;
    const bool onLine = over && isOnSplitLine(ui, area, place, theme);
    if (onLine) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);

    if (std::exchange(ui.requests.pick, false)) pickPixel(ui, panes, io.MousePos, false);
    if (std::exchange(ui.requests.pickPartner, false)) pickPixel(ui, panes, io.MousePos, true);
    const bool picks = over && ui.drag == Drag::none && io.KeyCtrl && ImGui::IsMouseClicked(0);
    if (picks) pickPixel(ui, panes, place, io.KeyShift);
    if (over && !picks && ui.drag == Drag::none &&
        (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2))) {
        ui.drag = onLine && ImGui::IsMouseClicked(0) ? Drag::splitLine : Drag::camera;
        if (ui.drag == Drag::camera)
            for (const ShownPane& pane : panes)
                if (pane.area.contains(place)) ui.bench.activate(pane.pane);
        ui.heldAt = {place.x, place.y};
    }
    const dvec2 byPixels = dvec2(io.MousePos.x, io.MousePos.y) - ui.heldAt;
    const double height = std::max(1, area.size.y), right = byPixels.x / height, down = byPixels.y / height;
    if (ui.drag == Drag::splitLine || ui.drag == Drag::camera) ui.heldAt = {io.MousePos.x, io.MousePos.y};
    bool moved = false;
    if (ui.drag == Drag::splitLine) {
        const double share = (io.MousePos.x - static_cast<float>(area.corner.x)) / std::max(1, area.size.x);
        ui.bench.change("split", [&](lab::Document& document) { document.split = std::clamp(share, 0.0, 1.0); });
        moved = byPixels.x != 0;
    } else if (ui.drag == Drag::camera && (right != 0 || down != 0)) {
        moved = true;
        const bool pan = wasDown(2) || (wasDown(0) && io.KeyShift);
        moveCamera(ui, [&](const scene::Camera& camera) {
            if (wasDown(1)) return lab::turnedHead(camera, right * kTurnHeadDegrees, -down * kTurnHeadDegrees);
            if (pan) return lab::panned(camera, right, -down);
            return lab::orbited(camera, -right * kOrbitDegrees, down * kOrbitDegrees);
        });
    }
    if (ui.drag == Drag::camera && ImGui::IsMouseDown(1)) { // fly, as long as the right button is down
        const auto pressed = [&](int key) { return ui.heldKeys.contains(key) ? 1.0 : 0.0; };
        const double step = io.DeltaTime * (io.KeyShift ? 2.0 : 0.5);
        const double x = pressed(GLFW_KEY_D) - pressed(GLFW_KEY_A), y = pressed(GLFW_KEY_E) - pressed(GLFW_KEY_Q),
                     z = pressed(GLFW_KEY_W) - pressed(GLFW_KEY_S);
        if (x != 0 || y != 0 || z != 0) {
            moved = true;
            moveCamera(ui, [&](const scene::Camera& camera) {
                const double metres = step * lab::targetDistance(camera);
                return lab::flown(camera, x * metres, y * metres, z * metres);
            });
        }
    }
    if (over && io.MouseWheel != 0) {
        moved = true;
        moveCamera(ui, [&](const scene::Camera& camera) {
            return lab::zoomed(camera, std::pow(kWheelFactor, io.MouseWheel));
        });
    }
    if (!ImGui::IsMouseDown(0) && !ImGui::IsMouseDown(1) && !ImGui::IsMouseDown(2) &&
        (ui.drag == Drag::camera || ui.drag == Drag::splitLine)) {
        ui.drag = Drag::none;
        ui.bench.endGesture();
    }
    return moved || ui.drag != Drag::none;
}

} // namespace shadowlab::window
