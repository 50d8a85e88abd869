// SPDX-License-Identifier: MIT
#include "app/window/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/lab/object_picking.h"
#include "app/window/handle_places.h"
#include "app/window/picture_mouse.h"

namespace shadowlab::window {

namespace {

using lab::Handle;
using lab::Selection;

constexpr float kGripEm = 1.1f;  ///< how near to a handle the mouse has to be: large enough to hit without care

float distance(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// What the mouse would take hold of.
struct Grip {
    const Handle* handle = nullptr;
    int part = -1; ///< an arrow, 0 to 2; or -1: the handle's disc, or any other place of the thing
    dvec3 positionWorld{0.0};
    explicit operator bool() const { return handle != nullptr; }
};

/// Of one thing: its mark at the picture's edge, its disc, and where it is selected its arrows.
Grip gripOf(const SeenPane& seen, const Handle& handle, bool selected, ImVec2 mouse, const Theme& theme) {
    const float near = kGripEm * theme.em;
    if (const auto mark = seen.edgeMark(handle, selected, theme)) {
        const dvec2 away = mark->pixel - dvec2(mouse.x, mouse.y);
        return glm::length(away) <= near ? Grip{&handle, -1, handle.positionWorld} : Grip();
    }
    const auto place = seen.place(handle.positionWorld);
    if (!place) return {};
    if (distance(*place, mouse) <= near || distance(seen.iconPlace(*place, theme), mouse) <= near) return {&handle, -1, handle.positionWorld};
    if (!selected) return {};
    for (int i = 0; i < 3; ++i)
        if (const auto end = seen.arrowEnd(handle, i, theme); end && distance(*end, mouse) <= near)
            return {&handle, i, handle.positionWorld};
    return {};
}

/// The object whose surface lies under the mouse. What the others stand on is taken hold of so only where it is selected:
/// elsewhere a drag on it turns the camera.
Grip gripOfSurface(WindowState& ui, const SeenPane& seen, const std::vector<Handle>& handles, ImVec2 mouse) {
    const std::vector<scene::Bounds>& bounds = ui.bench.bounds();
    const auto hit = lab::objectAt(*ui.bench.shownScene(), bounds, seen.camera, seen.size, seen.pixel(mouse));
    if (!hit) return {};
    const Selection what{Selection::Kind::object, static_cast<int>(hit->object)};
    if (what != ui.selection && lab::isBackdrop(bounds, hit->object)) return {};
    const auto handle = std::ranges::find(handles, what, &Handle::what);
    return handle == handles.end() ? Grip() : Grip{&*handle, -1, hit->positionWorld};
}

/// The selected thing comes first: its arrows may lie over other handles. Then lights, then objects, and last any place of an object,
/// where the split line is not over it.
Grip gripUnder(WindowState& ui, const SeenPane& seen, const std::vector<Handle>& handles, const Area& pictures, ImVec2 mouse,
               const Theme& theme) {
    if (isOnSplitKnob(ui, pictures, mouse, theme)) return {};
    for (const bool selectedOnes : {true, false})
        for (const Handle& handle : handles) {
            const bool selected = handle.what == ui.selection;
            if (selected != selectedOnes) continue;
            if (const Grip grip = gripOf(seen, handle, selected, mouse, theme)) return grip;
        }
    return isOnSplitLine(ui, pictures, mouse, theme) ? Grip() : gripOfSurface(ui, seen, handles, mouse);
}

lab::Hold holdOf(const WindowState& ui, const SeenPane& seen, const Grip& grip, const Theme& theme) {
    const auto mark = seen.edgeMark(*grip.handle, grip.handle->what == ui.selection, theme);
    std::optional<dvec2> markPixel;
    if (mark) markPixel = mark->pixel - dvec2(seen.pane.pictureCorner.x, seen.pane.pictureCorner.y);
    lab::Hold hold = lab::holdOf(seen.camera, seen.size, *ui.bench.shownScene(), *grip.handle, grip.positionWorld, markPixel);
    constexpr std::array kAlong = {lab::DragWay::alongX, lab::DragWay::alongY, lab::DragWay::alongZ};
    if (grip.part >= 0) hold.way = kAlong[static_cast<std::size_t>(grip.part)];
    return hold;
}

} // namespace

bool handleGizmos(WindowState& ui, const std::vector<ShownPane>& panes, const Area& pictures, const Theme& theme) {
    ui.hovered = {};
    if (!ui.shown.handles || ui.lesson.isOn()) return false; // a lesson's counts are those of its scene
    const ImGuiIO& io = ImGui::GetIO();
    const lab::Document& document = ui.bench.document();
    const std::vector<Handle> handles =
        lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), document.camera);
    // With Alt the mouse moves the camera, and with Ctrl it picks a pixel, whatever lies under it.
    const bool free = ui.drag == Drag::none && !io.WantCaptureMouse && !io.KeyAlt && !io.KeyCtrl;

    for (const ShownPane& pane : panes) {
        const ImVec2 place = pressPlace(ui);
        if (!free || !pane.area.contains(place) || !showsHandles(ui, pane)) continue;
        const SeenPane seen = seenIn(pane, document.camera);
        const Grip grip = gripUnder(ui, seen, handles, pictures, place, theme);
        if (!grip) continue;
        ui.hovered = grip.handle->what;
        if (!ImGui::IsMouseClicked(0)) continue;
        ui.held = holdOf(ui, seen, grip, theme);
        ui.bench.activate(pane.pane); // as any other press in it does
        ui.selection = grip.handle->what;
        ui.drag = Drag::handle;
        ui.dragPane = pane.pane;
        ui.heldAt = {place.x, place.y};
    }
    if (ui.drag != Drag::handle) return false;
    for (const ShownPane& pane : panes) {
        if (pane.pane != ui.dragPane) continue;
        const SeenPane seen = seenIn(pane, document.camera);
        const auto held = std::ranges::find(handles, ui.selection, &Handle::what);
        const dvec2 mouse(io.MousePos.x, io.MousePos.y), byPixels = mouse - ui.heldAt;
        if (held == handles.end() || byPixels == dvec2(0.0)) continue;
        ui.heldAt = mouse;
        lab::Hold hold = ui.held;
        if (io.KeyShift && hold.way != lab::DragWay::turn) hold.way = lab::DragWay::upright;
        moveSelected(ui, lab::draggedBy(hold, seen.camera, seen.size, held->positionWorld, byPixels), "drag a handle");
    }
    if (!ImGui::IsMouseDown(0)) {
        ui.drag = Drag::none;
        ui.bench.endGesture();
    }
    return true;
}

std::vector<std::pair<std::string, dvec2>> handlePlaces(WindowState& ui, const ShownPane& pane, const Theme& theme) {
    const scene::Camera& camera = ui.bench.document().camera;
    const SeenPane seen = seenIn(pane, camera);
    std::vector<std::pair<std::string, dvec2>> places;
    for (const Handle& handle : lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), camera))
        if (const auto mark = seen.edgeMark(handle, handle.what == ui.selection, theme))
            places.emplace_back(handle.label, mark->pixel);
        else if (const auto place = seen.place(handle.positionWorld); place && pane.area.contains(*place))
            places.emplace_back(handle.label, dvec2(place->x, place->y));
    return places;
}

} // namespace shadowlab::window
