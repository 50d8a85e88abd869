// SPDX-License-Identifier: MIT
#include "app/window/gizmo.h"

#include <array>
#include <cmath>

#include "app/window/picture_mouse.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

using lab::Handle;
using lab::Selection;

constexpr float kGripEm = 1.1f;  ///< how near to a handle the mouse has to be: large enough to hit without care
constexpr float kArrowEm = 4.5f; ///< length of an axis arrow
constexpr float kEdgeEm = 2.4f;  ///< how far within the picture, clear of titles, a light outside it has its mark
constexpr ImU32 kDark = IM_COL32(16, 16, 18, 255);

// One colour an axis (Okabe and Ito): x vermilion, y bluish green, z blue; the letters say it too.
const std::array<vec3, 3> kAxisColors = {look::linearFromSrgb8(0xD5, 0x5E, 0x00),
                                         look::linearFromSrgb8(0x00, 0x9E, 0x73),
                                         look::linearFromSrgb8(0x56, 0xB4, 0xE9)};

dvec3 axis(int i) { return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0}; }

/// A pane and the camera its picture was made with.
struct Seen {
    const ShownPane& pane;
    const scene::Camera& camera;
    ivec2 size;
    [[nodiscard]] std::optional<ImVec2> place(const dvec3& positionWorld) const {
        const auto pixel = lab::pixelOf(camera, size, positionWorld);
        if (!pixel) return {};
        return ImVec2(pane.pictureCorner.x + static_cast<float>(pixel->x),
                      pane.pictureCorner.y + static_cast<float>(pixel->y));
    }
    /// For a light that the picture does not show.
    [[nodiscard]] std::optional<lab::EdgeMark> edgeMark(const Handle& handle, const Theme& theme) const {
        if (handle.what.kind != Selection::Kind::light) return {};
        auto mark = lab::edgeMarkOf(camera, size, kEdgeEm * theme.em, handle.positionWorld);
        if (mark) mark->pixel += dvec2(pane.pictureCorner.x, pane.pictureCorner.y);
        return mark;
    }
    [[nodiscard]] dvec2 pixel(ImVec2 mouse) const {
        return {mouse.x - pane.pictureCorner.x, mouse.y - pane.pictureCorner.y};
    }
};

Seen seenIn(const ShownPane& pane, const scene::Camera& camera) {
    return {pane, camera, {static_cast<int>(pane.pictureSize.x), static_cast<int>(pane.pictureSize.y)}};
}

/// What is seen from elsewhere, by the second camera or by a light, has other places for them.
bool showsHandles(const WindowState& ui, const ShownPane& pane) { return ui.bench.pane(pane.pane).showsTheEyesView(); }

double distance(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The end of an axis arrow in the picture, `length` pixels long however far away; nothing when it points at the eye.
std::optional<ImVec2> arrowEnd(const Seen& seen, const Handle& handle, int i, float length) {
    const auto from = seen.place(handle.positionWorld);
    const double metres = 1e-3 * glm::length(handle.positionWorld - seen.camera.positionWorld);
    const auto toward = seen.place(handle.positionWorld + metres * axis(i));
    if (!from || !toward) return {};
    const double seenLength = distance(*from, *toward);
    // What a metre on the screen would be if it were not foreshortened; less than a fifth of it cannot be aimed with.
    const double full = 1e-3 * seen.size.y / (2 * std::tan(glm::radians(seen.camera.fovYDegrees) / 2));
    if (seenLength < 0.2 * full) return {};
    const auto scale = static_cast<float>(length / seenLength);
    return ImVec2(from->x + (toward->x - from->x) * scale, from->y + (toward->y - from->y) * scale);
}

/// -1 the disc, 0..2 an arrow.
std::optional<int> partUnder(const Seen& seen, const Handle& handle, bool selected, ImVec2 mouse, const Theme& theme) {
    const float grip = kGripEm * theme.em;
    if (const auto mark = seen.edgeMark(handle, theme)) {
        const dvec2 away = mark->pixel - dvec2(mouse.x, mouse.y);
        return glm::length(away) <= grip ? std::optional(-1) : std::nullopt;
    }
    const auto place = seen.place(handle.positionWorld);
    if (!place) return {};
    if (distance(*place, mouse) <= grip) return -1;
    if (!selected) return {};
    for (int i = 0; i < 3; ++i)
        if (const auto end = arrowEnd(seen, handle, i, kArrowEm * theme.em); end && distance(*end, mouse) <= grip)
            return i;
    return {};
}

void drawLabel(ImDrawList& list, ImVec2 at, const std::string& label, const Theme& theme) {
    const ImVec2 size = theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, label.c_str());
    list.AddRectFilled({at.x - theme.em * 0.3f, at.y - theme.em * 0.15f},
                       {at.x + size.x + theme.em * 0.3f, at.y + size.y + theme.em * 0.15f}, kPlateColor);
    list.AddText(theme.text, theme.em, at, kPlateText, label.c_str());
}

/// A light outside the picture: a disc at the edge with a point toward it.
void drawEdgeMark(ImDrawList& list, const lab::EdgeMark& mark, const std::string& label, bool chosen,
                  const Theme& theme) {
    const auto at = [&](double outward, double across) {
        const dvec2 p = mark.pixel + static_cast<double>(theme.em) *
                                         (outward * mark.outward + across * dvec2(-mark.outward.y, mark.outward.x));
        return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y));
    };
    const ImU32 color = chosen ? kAccent : kPlateText;
    list.AddTriangleFilled(at(1.3, 0), at(0.3, -0.75), at(0.3, 0.75), kDark);
    list.AddCircleFilled(at(0, 0), theme.em * 0.62f, kDark);
    list.AddTriangleFilled(at(1.1, 0), at(0.4, -0.5), at(0.4, 0.5), color);
    list.AddCircleFilled(at(0, 0), theme.em * 0.42f, color);
    if (!chosen) return;
    const ImVec2 size = theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, label.c_str());
    const ImVec2 inward = at(-1.4, 0); // the label lies on the picture's side of the mark
    drawLabel(list,
              {inward.x - (mark.outward.x > 0.3    ? size.x
                           : mark.outward.x < -0.3 ? 0.0f
                                                   : size.x / 2),
               inward.y - size.y / 2},
              label, theme);
}

void drawHandle(ImDrawList& list, const Seen& seen, const Handle& handle, bool selected, bool hovered,
                const Theme& theme) {
    if (const auto mark = seen.edgeMark(handle, theme)) {
        drawEdgeMark(list, *mark, handle.label, selected || hovered, theme);
        return;
    }
    const auto place = seen.place(handle.positionWorld);
    if (!place) return;
    const bool light = handle.what.kind == Selection::Kind::light;
    const float r = theme.em * (light ? 0.5f : 0.32f);
    const ImU32 color = selected || hovered ? kAccent : kPlateText;
    if (selected)
        for (int i = 0; i < 3; ++i)
            if (const auto end = arrowEnd(seen, handle, i, kArrowEm * theme.em)) {
                const ImU32 axisColor = shownColor(kAxisColors[static_cast<std::size_t>(i)]);
                list.AddLine(*place, *end, kDark, theme.em * 0.36f);
                list.AddLine(*place, *end, axisColor, theme.em * 0.2f);
                list.AddCircleFilled(*end, theme.em * 0.55f, kDark);
                list.AddCircleFilled(*end, theme.em * 0.46f, axisColor);
                const char letter[2] = {static_cast<char>('x' + i), 0};
                const ImVec2 size = theme.text->CalcTextSizeA(theme.em * 0.85f, FLT_MAX, 0, letter);
                list.AddText(theme.text, theme.em * 0.85f, {end->x - size.x / 2, end->y - size.y / 2}, kDark, letter);
            }
    list.AddCircleFilled(*place, r + 2, kDark);
    if (light) { // a sun: a disc with rays
        for (int i = 0; i < 8; ++i) {
            const float angle = static_cast<float>(i) * 0.7853982f, c = std::cos(angle), s = std::sin(angle);
            list.AddLine({place->x + 1.35f * r * c, place->y + 1.35f * r * s},
                         {place->x + 2 * r * c, place->y + 2 * r * s}, kDark, theme.em * 0.28f);
            list.AddLine({place->x + 1.35f * r * c, place->y + 1.35f * r * s},
                         {place->x + 1.9f * r * c, place->y + 1.9f * r * s}, color, theme.em * 0.14f);
        }
    }
    list.AddCircleFilled(*place, r, color);
    if (!selected && !hovered) return;
    drawLabel(list, {place->x + theme.em * 1.2f, place->y - theme.em * 1.6f}, handle.label, theme);
}

/// How far the mouse has moved the thing since the last frame.
std::optional<dvec3> pulled(const Seen& seen, const Handle& handle, int part, ImVec2 from, ImVec2 to) {
    if (part >= 0) {
        const auto before =
            lab::placeOnLine(seen.camera, seen.size, seen.pixel(from), handle.positionWorld, axis(part));
        const auto after =
            lab::placeOnLine(seen.camera, seen.size, seen.pixel(to), handle.positionWorld, axis(part));
        if (!before || !after) return {};
        return (*after - *before) * axis(part);
    }
    const dvec3 viewWorld = glm::normalize(seen.camera.targetWorld - seen.camera.positionWorld);
    const dvec3 upWorld = glm::normalize(seen.camera.upWorld);
    // Level with the ground; where the eye sees the ground nearly edge-on, in the plane of the picture.
    const bool level = std::abs(glm::dot(viewWorld, upWorld)) > 0.12 && !ImGui::GetIO().KeyShift;
    dvec3 normalWorld = level ? upWorld : viewWorld;
    const auto before =
        lab::pointOnPlane(seen.camera, seen.size, seen.pixel(from), handle.positionWorld, normalWorld);
    const auto after = lab::pointOnPlane(seen.camera, seen.size, seen.pixel(to), handle.positionWorld, normalWorld);
    if (!before || !after) return {};
    const dvec3 byWorld = *after - *before;
    if (ImGui::GetIO().KeyShift) return glm::dot(byWorld, upWorld) * upWorld;
    // Near the horizon one pixel is a very long way, which is not what the user intends.
    if (glm::length(byWorld) > glm::length(handle.positionWorld - seen.camera.positionWorld)) return {};
    return byWorld;
}

} // namespace

bool handleGizmos(WindowState& ui, const std::vector<ShownPane>& panes, const Theme& theme) {
    ui.hovered = {};
    if (!ui.shown.handles) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const lab::Document& document = ui.bench.document();
    const std::vector<Handle> handles =
        lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), document.camera);
    const bool free = ui.drag == Drag::none && !io.WantCaptureMouse;

    for (const ShownPane& pane : panes) {
        if (!showsHandles(ui, pane)) continue;
        const Seen seen = seenIn(pane, document.camera);
        const ImVec2 place = pressPlace(ui);
        const bool over = pane.area.contains(place);
        // The selected thing first: its arrows may lie over other handles.
        const Handle* hovered = nullptr;
        int part = -1;
        for (const bool selectedOnes : {true, false})
            for (const Handle& handle : handles) {
                const bool selected = handle.what == ui.selection;
                if (selected != selectedOnes || hovered || !over || !free) continue;
                if (const auto under = partUnder(seen, handle, selected, place, theme)) {
                    hovered = &handle;
                    part = *under;
                }
            }
        if (hovered) ui.hovered = hovered->what;
        if (hovered && ImGui::IsMouseClicked(0) && !io.KeyCtrl) {
            ui.selection = hovered->what;
            ui.drag = Drag::handle;
            ui.dragPart = part;
            ui.dragPane = pane.pane;
            ui.heldAt = {place.x, place.y};
        }
    }
    if (ui.drag != Drag::handle) return false;
    for (const ShownPane& pane : panes) {
        if (pane.pane != ui.dragPane) continue;
        const Seen seen = seenIn(pane, document.camera);
        const auto held = std::ranges::find(handles, ui.selection, &Handle::what);
        const ImVec2 before(static_cast<float>(ui.heldAt.x), static_cast<float>(ui.heldAt.y));
        if (held == handles.end() || (io.MousePos.x == before.x && io.MousePos.y == before.y)) continue;
        ui.heldAt = {io.MousePos.x, io.MousePos.y};
        if (const auto byWorld = pulled(seen, *held, ui.dragPart, before, io.MousePos))
            moveSelected(ui, *byWorld, "drag a handle");
    }
    if (!ImGui::IsMouseDown(0)) {
        ui.drag = Drag::none;
        ui.bench.endGesture();
    }
    return true;
}

void drawGizmos(ImDrawList& list, WindowState& ui, const ShownPane& pane, const Theme& theme) {
    if (!ui.shown.handles || !showsHandles(ui, pane)) return;
    const scene::Camera& camera = ui.bench.document().camera;
    const Seen seen = seenIn(pane, camera);
    for (const Handle& handle : lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), camera)) {
        const bool selected = handle.what == ui.selection, hovered = handle.what == ui.hovered;
        // Objects show theirs when the mouse is near: a picture full of dots would be no picture.
        if (handle.what.kind == Selection::Kind::object && !selected && !hovered) continue;
        drawHandle(list, seen, handle, selected, hovered, theme);
    }
}

std::vector<std::pair<std::string, dvec2>> handlePlaces(WindowState& ui, const ShownPane& pane) {
    const scene::Camera& camera = ui.bench.document().camera;
    const Seen seen = seenIn(pane, camera);
    std::vector<std::pair<std::string, dvec2>> places;
    for (const Handle& handle : lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), camera))
        if (const auto place = seen.place(handle.positionWorld); place && pane.area.contains(*place))
            places.emplace_back(handle.label, dvec2(place->x, place->y));
    return places;
}

} // namespace shadowlab::window
