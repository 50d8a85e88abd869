// SPDX-License-Identifier: MIT
#include "app/ui/gizmo.h"

#include <array>
#include <cmath>

#include "techniques/foundation/look.h"

namespace shadowlab::ui {

namespace {

using session::Handle;
using session::Selection;

constexpr float kGripEm = 1.1f;  ///< how near to a handle the mouse takes hold: easy to hit with a nervous hand
constexpr float kArrowEm = 4.5f; ///< length of an axis arrow
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
        const auto pixel = session::pixelOf(camera, size, positionWorld);
        if (!pixel) return {};
        return ImVec2(pane.pictureCorner.x + static_cast<float>(pixel->x),
                      pane.pictureCorner.y + static_cast<float>(pixel->y));
    }
    [[nodiscard]] dvec2 pixel(ImVec2 mouse) const {
        return {mouse.x - pane.pictureCorner.x, mouse.y - pane.pictureCorner.y};
    }
};

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
    const auto place = seen.place(handle.positionWorld);
    if (!place) return {};
    const float grip = kGripEm * theme.em;
    if (distance(*place, mouse) <= grip) return -1;
    if (!selected) return {};
    for (int i = 0; i < 3; ++i)
        if (const auto end = arrowEnd(seen, handle, i, kArrowEm * theme.em); end && distance(*end, mouse) <= grip)
            return i;
    return {};
}

void drawHandle(ImDrawList& list, const Seen& seen, const Handle& handle, bool selected, bool hovered,
                const Theme& theme) {
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
    const ImVec2 at(place->x + theme.em * 1.2f, place->y - theme.em * 1.6f);
    const ImVec2 size = theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, handle.label.c_str());
    list.AddRectFilled({at.x - theme.em * 0.3f, at.y - theme.em * 0.15f},
                       {at.x + size.x + theme.em * 0.3f, at.y + size.y + theme.em * 0.15f}, kPlateColor);
    list.AddText(theme.text, theme.em, at, kPlateText, handle.label.c_str());
}

/// How far the hand has moved the thing since the last frame.
std::optional<dvec3> pulled(const Seen& seen, const Handle& handle, int part, ImVec2 from, ImVec2 to) {
    if (part >= 0) {
        const auto before =
            session::placeOnLine(seen.camera, seen.size, seen.pixel(from), handle.positionWorld, axis(part));
        const auto after =
            session::placeOnLine(seen.camera, seen.size, seen.pixel(to), handle.positionWorld, axis(part));
        if (!before || !after) return {};
        return (*after - *before) * axis(part);
    }
    const dvec3 viewWorld = glm::normalize(seen.camera.targetWorld - seen.camera.positionWorld);
    const dvec3 upWorld = glm::normalize(seen.camera.upWorld);
    // Level with the ground; where the eye sees the ground nearly edge-on, in the plane of the picture.
    const bool level = std::abs(glm::dot(viewWorld, upWorld)) > 0.12 && !ImGui::GetIO().KeyShift;
    dvec3 normalWorld = level ? upWorld : viewWorld;
    const auto before =
        session::pointOnPlane(seen.camera, seen.size, seen.pixel(from), handle.positionWorld, normalWorld);
    const auto after = session::pointOnPlane(seen.camera, seen.size, seen.pixel(to), handle.positionWorld, normalWorld);
    if (!before || !after) return {};
    const dvec3 byWorld = *after - *before;
    if (ImGui::GetIO().KeyShift) return glm::dot(byWorld, upWorld) * upWorld;
    // Near the horizon a pixel is a mile: nobody means that.
    if (glm::length(byWorld) > glm::length(handle.positionWorld - seen.camera.positionWorld)) return {};
    return byWorld;
}

} // namespace

bool handleGizmos(Desk& desk, const std::vector<ShownPane>& panes, const Theme& theme) {
    if (!desk.shown.handles) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const session::Document& document = desk.bench.document();
    const std::vector<Handle> handles =
        session::handles(*desk.bench.shownScene(), desk.bench.bounds(), document.camera);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const bool free = desk.drag == Drag::none && !io.WantCaptureMouse;

    for (const ShownPane& pane : panes) {
        const session::PaneState& state = document.panes[static_cast<std::size_t>(pane.pane)];
        if (state.stage.starts_with("outside")) continue; // it shows the lights itself, from elsewhere
        const Seen seen{
            pane, document.camera, {static_cast<int>(pane.pictureSize.x), static_cast<int>(pane.pictureSize.y)}};
        const ImVec2 place = pressPlace(desk);
        const bool over = pane.area.contains(place);
        // The selected thing first: its arrows may lie over other handles.
        const Handle* hovered = nullptr;
        int part = -1;
        for (const bool selectedOnes : {true, false})
            for (const Handle& handle : handles) {
                const bool selected = handle.what == desk.selection;
                if (selected != selectedOnes || hovered || !over || !free) continue;
                if (const auto under = partUnder(seen, handle, selected, place, theme)) {
                    hovered = &handle;
                    part = *under;
                }
            }
        list.PushClipRect({static_cast<float>(pane.area.corner.x), static_cast<float>(pane.area.corner.y)},
                          {static_cast<float>(pane.area.corner.x + pane.area.size.x),
                           static_cast<float>(pane.area.corner.y + pane.area.size.y)},
                          true);
        for (const Handle& handle : handles) {
            const bool selected = handle.what == desk.selection;
            // Objects show theirs when the mouse is near: a picture full of dots would be no picture.
            if (handle.what.kind == Selection::Kind::object && !selected && &handle != hovered) continue;
            drawHandle(list, seen, handle, selected, &handle == hovered, theme);
        }
        list.PopClipRect();
        if (hovered && ImGui::IsMouseClicked(0)) {
            desk.selection = hovered->what;
            desk.drag = Drag::handle;
            desk.dragPart = part;
            desk.dragPane = pane.pane;
            desk.heldAt = {place.x, place.y};
        }
    }
    if (desk.drag != Drag::handle) return false;
    if (!ImGui::IsMouseDown(0)) {
        desk.drag = Drag::none;
        desk.bench.endGesture();
        return false;
    }
    for (const ShownPane& pane : panes) {
        if (pane.pane != desk.dragPane) continue;
        const Seen seen{
            pane, document.camera, {static_cast<int>(pane.pictureSize.x), static_cast<int>(pane.pictureSize.y)}};
        const auto held = std::ranges::find(handles, desk.selection, &Handle::what);
        const ImVec2 before(static_cast<float>(desk.heldAt.x), static_cast<float>(desk.heldAt.y));
        if (held == handles.end() || (io.MousePos.x == before.x && io.MousePos.y == before.y)) continue;
        desk.heldAt = {io.MousePos.x, io.MousePos.y};
        if (const auto byWorld = pulled(seen, *held, desk.dragPart, before, io.MousePos))
            moveSelected(desk, *byWorld, "drag a handle");
    }
    return true;
}

std::vector<std::pair<std::string, dvec2>> handlePlaces(Desk& desk, const ShownPane& pane) {
    const scene::Camera& camera = desk.bench.document().camera;
    const Seen seen{pane, camera, {static_cast<int>(pane.pictureSize.x), static_cast<int>(pane.pictureSize.y)}};
    std::vector<std::pair<std::string, dvec2>> places;
    for (const Handle& handle : session::handles(*desk.bench.shownScene(), desk.bench.bounds(), camera))
        if (const auto place = seen.place(handle.positionWorld); place && pane.area.contains(*place))
            places.emplace_back(handle.label, dvec2(place->x, place->y));
    return places;
}

} // namespace shadowlab::ui
