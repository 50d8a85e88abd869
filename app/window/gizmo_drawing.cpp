// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "app/window/free_places.h"
#include "app/window/gizmo.h"
#include "app/window/handle_places.h"
#include "app/window/name_plates.h"
#include "app/window/widget_renderer.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

using lab::Handle;
using lab::Selection;

constexpr double kFlashTurnSeconds = 0.35; ///< on, and off
constexpr float kOutlineEm = 1.15f;        ///< radius of the outline around a light's icon

// One colour an axis (Okabe and Ito): x vermilion, y bluish green, z blue; the letters say it too.
const std::array<vec3, 3> kAxisColors = {look::linearFromSrgb8(0xD5, 0x5E, 0x00),
                                         look::linearFromSrgb8(0x00, 0x9E, 0x73),
                                         look::linearFromSrgb8(0x56, 0xB4, 0xE9)};

/// How a handle is drawn.
struct Look {
    bool selected = false, hovered = false, flashes = false;
    bool isCurrent = false; ///< of several lights the one that stages and verdicts are about
    [[nodiscard]] bool stands() const { return selected || hovered || flashes; }
    /// What is selected has an outline: two things, two signs.
    [[nodiscard]] ImU32 color() const { return isCurrent ? kAccent : kPlateText; }
};

/// Around the icon of what is selected, a thin one around what the mouse would take hold of.
void drawOutline(ImDrawList& list, ImVec2 place, float radius, const Look& look) {
    if (!look.selected && !look.hovered) return;
    const float width = look.selected ? kOutline : 0.5f * kOutline;
    list.AddCircle(place, radius, kSignRim, 0, width + 3);
    list.AddCircle(place, radius, kPlateText, 0, width);
}

/// A sun: a disc with rays.
void drawRays(ImDrawList& list, ImVec2 place, float r, ImU32 color, const Theme& theme) {
    for (int i = 0; i < 8; ++i) {
        const float angle = static_cast<float>(i) * 0.7853982f, c = std::cos(angle), s = std::sin(angle);
        list.AddLine({place.x + 1.35f * r * c, place.y + 1.35f * r * s}, {place.x + 2 * r * c, place.y + 2 * r * s},
                     kSignRim, theme.em * 0.28f);
        list.AddLine({place.x + 1.35f * r * c, place.y + 1.35f * r * s},
                     {place.x + 1.9f * r * c, place.y + 1.9f * r * s}, color, theme.em * 0.14f);
    }
}

/// A disc behind the icon, larger than it: seen from the last row.
void drawFlash(ImDrawList& list, ImVec2 place, const Theme& theme) {
    list.AddCircleFilled(place, theme.em * 1.7f, kSignRim);
    list.AddCircleFilled(place, theme.em * 1.6f, kAccent);
    list.AddCircleFilled(place, theme.em * 1.25f, kSignRim);
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
    if (look.flashes) drawFlash(list, at(0, 0), theme);
    list.AddTriangleFilled(at(1.75, 0), at(0.85, -0.75), at(0.85, 0.75), kSignRim);
    list.AddTriangleFilled(at(1.6, 0), at(0.95, -0.5), at(0.95, 0.5), look.color());
    drawOutline(list, at(0, 0), theme.em * kOutlineEm, look);
    list.AddCircleFilled(at(0, 0), r + 2, kSignRim);
    if (handle.what.kind == Selection::Kind::light) drawRays(list, at(0, 0), r, look.color(), theme);
    list.AddCircleFilled(at(0, 0), r, look.color());
    plates.keepFree(at(1.3, 0), theme.em * 0.5f);
    plates.add(at(0, 0), theme.em * (look.stands() ? kOutlineEm : 0.9f), handle.label, look.color(), look.selected);
}

void drawArrows(ImDrawList& list, const SeenPane& seen, const Handle& handle, ImVec2 place, const Theme& theme) {
    for (int i = 0; i < 3; ++i) {
        const auto end = seen.arrowEnd(handle, i, theme);
        if (!end) continue;
        const ImU32 axisColor = shownColor(kAxisColors[static_cast<std::size_t>(i)]);
        list.AddLine(place, *end, kSignRim, theme.em * 0.36f);
        list.AddLine(place, *end, axisColor, theme.em * 0.2f);
        list.AddCircleFilled(*end, theme.em * 0.55f, kSignRim);
        list.AddCircleFilled(*end, theme.em * 0.46f, axisColor);
        const char letter[2] = {static_cast<char>('x' + i), 0};
        const ImVec2 size = theme.text->CalcTextSizeA(theme.em * 0.85f, FLT_MAX, 0, letter);
        list.AddText(theme.text, theme.em * 0.85f, {end->x - size.x / 2, end->y - size.y / 2}, kSignRim, letter);
    }
}

void drawHandle(ImDrawList& list, NamePlates& plates, const SeenPane& seen, const Handle& handle, const Look& look,
                const Theme& theme) {
    // In a part of a picture, what belongs to its other parts is theirs, names as well.
    const auto isHere = [&](ImVec2 at) { return seen.pane.area.contains(at); };
    if (const auto mark = seen.edgeMark(handle, look.selected, theme)) {
        if (isHere({static_cast<float>(mark->pixel.x), static_cast<float>(mark->pixel.y)}))
            drawEdgeMark(list, plates, *mark, handle, look, theme);
        return;
    }
    const auto itself = seen.place(handle.positionWorld);
    if (!itself || !isHere(*itself)) return;
    const ImVec2 place = seen.iconPlace(*itself, theme);
    const bool light = handle.what.kind == Selection::Kind::light;
    const float r = theme.em * (light ? 0.5f : 0.32f), outline = light ? theme.em * kOutlineEm : r + 2 * kOutline;
    if (look.flashes) drawFlash(list, place, theme);
    if (look.selected) drawArrows(list, seen, handle, place, theme);
    drawOutline(list, place, outline, look);
    list.AddCircleFilled(place, r + 2, kSignRim);
    if (light) drawRays(list, place, r, look.color(), theme);
    list.AddCircleFilled(place, r, look.color());
    if (light || look.stands())
        plates.add(place, look.stands() ? outline + kOutline : 2 * r, handle.label, look.color(), look.selected);
}

/// The light that stages are about, for a moment after it was chosen: on and off, first on.
bool flashes(const WindowState& ui, const Selection& what) {
    const double left = ui.flashUntil - ImGui::GetTime();
    return left > 0 && what == Selection{Selection::Kind::light, ui.bench.document().light} &&
           static_cast<int>((kFlashSeconds - left) / kFlashTurnSeconds) % 2 == 0;
}

} // namespace

std::vector<PlaceBox> drawGizmos(ImDrawList& list, WindowState& ui, const ShownPane& pane, FreePlaces& places, const Theme& theme) {
    if (!ui.shown.handles || !showsHandles(ui, pane)) return {};
    const scene::Camera& camera = ui.bench.document().camera;
    const SeenPane seen = seenIn(pane, camera);
    NamePlates plates(list, places, theme);
    const Selection current{Selection::Kind::light, ui.bench.document().light};
    const bool hasSeveral = ui.bench.shownScene()->lights.size() > 1;
    for (const Handle& handle : lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), camera)) {
        const Look look{handle.what == ui.selection, handle.what == ui.hovered, flashes(ui, handle.what),
                        hasSeveral && handle.what == current};
        // Objects show theirs when the mouse is near: a picture full of dots would be no picture.
        if (handle.what.kind == Selection::Kind::object && !look.stands()) continue;
        drawHandle(list, plates, seen, handle, look, theme);
    }
    return plates.draw();
}

} // namespace shadowlab::window
