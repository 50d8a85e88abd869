// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "app/window/gizmo.h"
#include "app/window/handle_places.h"
#include "app/window/widget_renderer.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

using lab::Handle;
using lab::Selection;

constexpr ImU32 kDark = IM_COL32(16, 16, 18, 255);

// One colour an axis (Okabe and Ito): x vermilion, y bluish green, z blue; the letters say it too.
const std::array<vec3, 3> kAxisColors = {look::linearFromSrgb8(0xD5, 0x5E, 0x00),
                                         look::linearFromSrgb8(0x00, 0x9E, 0x73),
                                         look::linearFromSrgb8(0x56, 0xB4, 0xE9)};

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

void drawArrows(ImDrawList& list, const SeenPane& seen, const Handle& handle, ImVec2 place, const Theme& theme) {
    for (int i = 0; i < 3; ++i) {
        const auto end = seen.arrowEnd(handle, i, theme);
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

void drawHandle(ImDrawList& list, NamePlates& plates, const SeenPane& seen, const Handle& handle, const Look& look,
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

} // namespace

void drawGizmos(ImDrawList& list, WindowState& ui, const ShownPane& pane, const Theme& theme) {
    if (!ui.shown.handles || !showsHandles(ui, pane)) return;
    const scene::Camera& camera = ui.bench.document().camera;
    const SeenPane seen = seenIn(pane, camera);
    NamePlates plates(list, pane, theme);
    for (const Handle& handle : lab::handles(*ui.bench.shownScene(), ui.bench.bounds(), camera)) {
        const Look look{handle.what == ui.selection, handle.what == ui.hovered, flashes(ui, handle.what)};
        // Objects show theirs when the mouse is near: a picture full of dots would be no picture.
        if (handle.what.kind == Selection::Kind::object && !look.stands()) continue;
        drawHandle(list, plates, seen, handle, look, theme);
    }
}

} // namespace shadowlab::window
