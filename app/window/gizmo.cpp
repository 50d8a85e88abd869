// SPDX-License-Identifier: MIT
#include "app/window/gizmo.h"

#include <array>
#include <cmath>

#include "app/lab/object_picking.h"
#include "app/window/picture_mouse.h"
#include "app/window/widget_renderer.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

using lab::Handle;
using lab::Selection;

constexpr float kGripEm = 1.1f;  ///< how near to a handle the mouse has to be: large enough to hit without care
constexpr float kArrowEm = 4.5f; ///< length of an axis arrow
constexpr float kEdgeEm = 1.8f;  ///< how far within the picture a light outside it has its mark
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
    /// Of what the picture does not show: a light, or what is selected.
    [[nodiscard]] std::optional<lab::EdgeMark> edgeMark(const Handle& handle, bool selected, const Theme& theme) const {
        if (handle.what.kind != Selection::Kind::light && !selected) return {};
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

/// What the mouse would take hold of.
struct Grip {
    const Handle* handle = nullptr;
    int part = -1; ///< an arrow, 0 to 2; or -1: the handle's disc, or any other place of the thing
    dvec3 positionWorld{0.0};
    explicit operator bool() const { return handle != nullptr; }
};

/// Of one thing: its mark at the picture's edge, its disc, and where it is selected its arrows.
Grip gripOf(const Seen& seen, const Handle& handle, bool selected, ImVec2 mouse, const Theme& theme) {
    const float near = kGripEm * theme.em;
    if (const auto mark = seen.edgeMark(handle, selected, theme)) {
        const dvec2 away = mark->pixel - dvec2(mouse.x, mouse.y);
        return glm::length(away) <= near ? Grip{&handle, -1, handle.positionWorld} : Grip();
    }
    const auto place = seen.place(handle.positionWorld);
    if (!place) return {};
    if (distance(*place, mouse) <= near) return {&handle, -1, handle.positionWorld};
    if (!selected) return {};
    for (int i = 0; i < 3; ++i)
        if (const auto end = arrowEnd(seen, handle, i, kArrowEm * theme.em); end && distance(*end, mouse) <= near)
            return {&handle, i, handle.positionWorld};
    return {};
}

/// The object whose surface lies under the mouse. What the others stand on is taken hold of so only where it is selected:
/// elsewhere a drag on it turns the camera.
Grip gripOfSurface(WindowState& ui, const Seen& seen, const std::vector<Handle>& handles, ImVec2 mouse) {
    const std::vector<scene::Bounds>& bounds = ui.bench.bounds();
    const auto hit = lab::objectAt(*ui.bench.shownScene(), bounds, seen.camera, seen.size, seen.pixel(mouse));
    if (!hit) return {};
    const Selection what{Selection::Kind::object, static_cast<int>(hit->object)};
    if (what != ui.selection && lab::isBackdrop(bounds, hit->object)) return {};
    const auto handle = std::ranges::find(handles, what, &Handle::what);
    return handle == handles.end() ? Grip() : Grip{&*handle, -1, hit->positionWorld};
}

/// The selected thing comes first: its arrows may lie over other handles. Then lights, then objects, and last any place of an object.
Grip gripUnder(WindowState& ui, const Seen& seen, const std::vector<Handle>& handles, ImVec2 mouse, const Theme& theme) {
    for (const bool selectedOnes : {true, false})
        for (const Handle& handle : handles) {
            const bool selected = handle.what == ui.selection;
            if (selected != selectedOnes) continue;
            if (const Grip grip = gripOf(seen, handle, selected, mouse, theme)) return grip;
        }
    return gripOfSurface(ui, seen, handles, mouse);
}

/// Name plates of one pane. Each is moved down, or at the pane's foot up, until it covers no other.
class NamePlates {
public:
    NamePlates(ImDrawList& list, const ShownPane& pane, const Theme& theme) : list_(list), pane_(pane), theme_(theme) {}

    /// `share` of its width lies to the left of `at`, and its upper edge there.
    void add(ImVec2 at, float share, const std::string& name, ImU32 color) {
        const float pad = theme_.em * 0.3f;
        const ImVec2 text = theme_.text->CalcTextSizeA(theme_.em, FLT_MAX, 0, name.c_str());
        const ImVec2 size(text.x + 2 * pad, text.y + pad);
        const ImVec2 low = imVec(pane_.area.corner), high = imVec(pane_.area.corner + pane_.area.size);
        Plate plate{{std::clamp(at.x - share * size.x, low.x, std::max(low.x, high.x - size.x)),
                     std::clamp(at.y, low.y, std::max(low.y, high.y - size.y))},
                    size};
        const bool upward = plate.corner.y + 3 * size.y > high.y;
        for (std::size_t tries = 0; tries <= plates_.size(); ++tries)
            for (const Plate& other : plates_)
                if (plate.overlaps(other))
                    plate.corner.y = upward ? other.corner.y - size.y - 1 : other.corner.y + other.size.y + 1;
        plates_.push_back(plate);
        list_.AddRectFilled(plate.corner, {plate.corner.x + size.x, plate.corner.y + size.y}, kPlateColor);
        list_.AddText(theme_.text, theme_.em, {plate.corner.x + pad, plate.corner.y + pad / 2}, color, name.c_str());
    }

private:
    struct Plate {
        ImVec2 corner, size;
        [[nodiscard]] bool overlaps(const Plate& other) const {
            return corner.x < other.corner.x + other.size.x && other.corner.x < corner.x + size.x &&
                   corner.y < other.corner.y + other.size.y && other.corner.y < corner.y + size.y;
        }
    };
    ImDrawList& list_;
    const ShownPane& pane_;
    const Theme& theme_;
    std::vector<Plate> plates_;
};

/// How a handle is drawn.
struct Look {
    bool selected = false, hovered = false, flashes = false;
    [[nodiscard]] bool stands() const { return selected || hovered || flashes; }
    [[nodiscard]] ImU32 color() const { return stands() ? kAccent : kPlateText; }
};

/// A sun: a disc with rays.
void drawRays(ImDrawList& list, ImVec2 place, float r, ImU32 color, const Theme& theme) {
    for (int i = 0; i < 8; ++i) {
        const float angle = static_cast<float>(i) * 0.7853982f, c = std::cos(angle), s = std::sin(angle);
        list.AddLine({place.x + 1.35f * r * c, place.y + 1.35f * r * s}, {place.x + 2 * r * c, place.y + 2 * r * s},
                     kDark, theme.em * 0.28f);
        list.AddLine({place.x + 1.35f * r * c, place.y + 1.35f * r * s},
                     {place.x + 1.9f * r * c, place.y + 1.9f * r * s}, color, theme.em * 0.14f);
    }
}

/// What lies outside the picture: its disc at the edge, a light's with rays, and before it a point in its direction.
void drawEdgeMark(ImDrawList& list, NamePlates& plates, const lab::EdgeMark& mark, const Handle& handle, const Look& look,
                  const Theme& theme) {
    const auto at = [&](double outward, double across) {
        const dvec2 p = mark.pixel + static_cast<double>(theme.em) *
                                         (outward * mark.outward + across * dvec2(-mark.outward.y, mark.outward.x));
        return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y));
    };
    const float r = theme.em * 0.4f;
    list.AddTriangleFilled(at(1.75, 0), at(0.85, -0.75), at(0.85, 0.75), kDark);
    list.AddTriangleFilled(at(1.6, 0), at(0.95, -0.5), at(0.95, 0.5), look.color());
    list.AddCircleFilled(at(0, 0), r + 2, kDark);
    if (handle.what.kind == Selection::Kind::light) drawRays(list, at(0, 0), r, look.color(), theme);
    list.AddCircleFilled(at(0, 0), r, look.color());
    const ImVec2 inward = at(-1.3, 0); // the name lies on the picture's side of the mark
    const float share = mark.outward.x > 0.3 ? 1.0f : mark.outward.x < -0.3 ? 0.0f : 0.5f;
    plates.add({inward.x, inward.y - theme.em * 0.6f}, share, handle.label, look.color());
}

void drawArrows(ImDrawList& list, const Seen& seen, const Handle& handle, ImVec2 place, const Theme& theme) {
    for (int i = 0; i < 3; ++i) {
        const auto end = arrowEnd(seen, handle, i, kArrowEm * theme.em);
        if (!end) continue;
        const ImU32 axisColor = shownColor(kAxisColors[static_cast<std::size_t>(i)]);
        list.AddLine(place, *end, kDark, theme.em * 0.36f);
        list.AddLine(place, *end, axisColor, theme.em * 0.2f);
        list.AddCircleFilled(*end, theme.em * 0.55f, kDark);
        list.AddCircleFilled(*end, theme.em * 0.46f, axisColor);
        const char letter[2] = {static_cast<char>('x' + i), 0};
        const ImVec2 size = theme.text->CalcTextSizeA(theme.em * 0.85f, FLT_MAX, 0, letter);
        list.AddText(theme.text, theme.em * 0.85f, {end->x - size.x / 2, end->y - size.y / 2}, kDark, letter);
    }
}

void drawHandle(ImDrawList& list, NamePlates& plates, const Seen& seen, const Handle& handle, const Look& look,
                const Theme& theme) {
    // In a part of a picture, what belongs to its other parts is theirs, names as well.
    const auto isHere = [&](ImVec2 at) { return seen.pane.area.contains(at); };
    if (const auto mark = seen.edgeMark(handle, look.selected, theme)) {
        if (isHere({static_cast<float>(mark->pixel.x), static_cast<float>(mark->pixel.y)}))
            drawEdgeMark(list, plates, *mark, handle, look, theme);
        return;
    }
    const auto place = seen.place(handle.positionWorld);
    if (!place || !isHere(*place)) return;
    const bool light = handle.what.kind == Selection::Kind::light;
    const float r = theme.em * (light ? 0.5f : 0.32f) * (look.flashes ? 1.5f : 1);
    if (look.selected) drawArrows(list, seen, handle, *place, theme);
    list.AddCircleFilled(*place, r + 2, kDark);
    if (light) drawRays(list, *place, r, look.color(), theme);
    list.AddCircleFilled(*place, r, look.color());
    if (light || look.stands())
        plates.add({place->x + theme.em * 1.3f, place->y - theme.em * 1.6f}, 0, handle.label, look.color());
}

/// The light that stages are about, for a moment after it was chosen: four times on and off.
bool flashes(const WindowState& ui, const Selection& what) {
    const double left = ui.flashUntil - ImGui::GetTime();
    return left > 0 && what == Selection{Selection::Kind::light, ui.bench.document().light} &&
           static_cast<int>(left / (kFlashSeconds / 8)) % 2 == 1;
}

lab::Hold holdOf(const WindowState& ui, const Seen& seen, const Grip& grip, const Theme& theme) {
    const auto mark = seen.edgeMark(*grip.handle, grip.handle->what == ui.selection, theme);
    std::optional<dvec2> markPixel;
    if (mark) markPixel = mark->pixel - dvec2(seen.pane.pictureCorner.x, seen.pane.pictureCorner.y);
    lab::Hold hold = lab::holdOf(seen.camera, seen.size, *ui.bench.shownScene(), *grip.handle, grip.positionWorld, markPixel);
    constexpr std::array kAlong = {lab::DragWay::alongX, lab::DragWay::alongY, lab::DragWay::alongZ};
    if (grip.part >= 0) hold.way = kAlong[static_cast<std::size_t>(grip.part)];
    return hold;
}

} // namespace

bool handleGizmos(WindowState& ui, const std::vector<ShownPane>& panes, const Theme& theme) {
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
        const Seen seen = seenIn(pane, document.camera);
        const Grip grip = gripUnder(ui, seen, handles, place, theme);
        if (!grip) continue;
        ui.hovered = grip.handle->what;
        if (!ImGui::IsMouseClicked(0)) continue;
        ui.held = holdOf(ui, seen, grip, theme);
        ui.selection = grip.handle->what;
        ui.drag = Drag::handle;
        ui.dragPane = pane.pane;
        ui.heldAt = {place.x, place.y};
    }
    if (ui.drag != Drag::handle) return false;
    for (const ShownPane& pane : panes) {
        if (pane.pane != ui.dragPane) continue;
        const Seen seen = seenIn(pane, document.camera);
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

void drawGizmos(ImDrawList& list, WindowState& ui, const ShownPane& pane, const Theme& theme) {
    if (!ui.shown.handles || !showsHandles(ui, pane)) return;
    const scene::Camera& camera = ui.bench.document().camera;
    const Seen seen = seenIn(pane, camera);
    NamePlates plates(list, pane, theme);
    for (const Handle& handle : lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), camera)) {
        const Look look{handle.what == ui.selection, handle.what == ui.hovered, flashes(ui, handle.what)};
        // Objects show theirs when the mouse is near: a picture full of dots would be no picture.
        if (handle.what.kind == Selection::Kind::object && !look.stands()) continue;
        drawHandle(list, plates, seen, handle, look, theme);
    }
}

std::vector<std::pair<std::string, dvec2>> handlePlaces(WindowState& ui, const ShownPane& pane, const Theme& theme) {
    const scene::Camera& camera = ui.bench.document().camera;
    const Seen seen = seenIn(pane, camera);
    std::vector<std::pair<std::string, dvec2>> places;
    for (const Handle& handle : lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), camera))
        if (const auto mark = seen.edgeMark(handle, handle.what == ui.selection, theme))
            places.emplace_back(handle.label, mark->pixel);
        else if (const auto place = seen.place(handle.positionWorld); place && pane.area.contains(*place))
            places.emplace_back(handle.label, dvec2(place->x, place->y));
    return places;
}

} // namespace shadowlab::window
