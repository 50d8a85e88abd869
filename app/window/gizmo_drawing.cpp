// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "app/window/free_places.h"
#include "app/window/gizmo.h"
#include "app/window/handle_places.h"
#include "app/window/widget_renderer.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

using lab::Handle;
using lab::Selection;

constexpr ImU32 kDark = IM_COL32(16, 16, 18, 255);
constexpr double kFlashTurnSeconds = 0.35; ///< on, and off

// One colour an axis (Okabe and Ito): x vermilion, y bluish green, z blue; the letters say it too.
const std::array<vec3, 3> kAxisColors = {look::linearFromSrgb8(0xD5, 0x5E, 0x00),
                                         look::linearFromSrgb8(0x00, 0x9E, 0x73),
                                         look::linearFromSrgb8(0x56, 0xB4, 0xE9)};

/// The names of what has an icon in one pane. They find their places when all icons are known: each beside its own, on the first
/// side that is free of icons, of other names and of objects.
class NamePlates {
public:
    NamePlates(ImDrawList& list, FreePlaces& places, const Theme& theme) : list_(list), places_(places), theme_(theme) {}

    /// The icon and its name. `radius`: of the icon with its rays.
    void add(ImVec2 icon, float radius, const std::string& name, ImU32 color) {
        names_.push_back({icon, radius, name, color});
        places_.take(boxAround(icon, radius), FreePlaces::kSign);
    }

    /// What belongs to an icon and must stay as free as it: the point of an edge mark.
    void keepFree(ImVec2 at, float radius) { places_.take(boxAround(at, radius), FreePlaces::kSign); }

    void draw() {
        for (const Name& name : names_) {
            const float pad = theme_.em * 0.3f;
            const ImVec2 text = theme_.text->CalcTextSizeA(theme_.em, FLT_MAX, 0, name.text.c_str());
            const PlaceBox plate = bestPlace(name, {text.x + 2 * pad, text.y + pad});
            places_.take(plate, FreePlaces::kSign);
            const ImVec2 nearest(std::clamp(name.icon.x, plate.low.x, plate.high.x), std::clamp(name.icon.y, plate.low.y, plate.high.y));
            if (std::hypot(nearest.x - name.icon.x, nearest.y - name.icon.y) > name.radius + theme_.em) { // not beside it: a line leads to it
                list_.AddLine(name.icon, nearest, kDark, theme_.em * 0.2f);
                list_.AddLine(name.icon, nearest, name.color, theme_.em * 0.1f);
            }
            list_.AddRectFilled(plate.low, plate.high, kPlateColor);
            list_.AddText(theme_.text, theme_.em, {plate.low.x + pad, plate.low.y + pad / 2}, name.color, name.text.c_str());
        }
    }

private:
    struct Name {
        ImVec2 icon;
        float radius;
        std::string text;
        ImU32 color;
    };
    static PlaceBox boxAround(ImVec2 at, float radius) { return {{at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}}; }

    /// Right, left, below and above it, then at its corners; where several lamps stand together, farther away. Of places that cost the
    /// same the first is taken.
    [[nodiscard]] PlaceBox bestPlace(const Name& name, ImVec2 size) const {
        constexpr int kFarther = 4;
        // Rather over an object than farther away, and rather farther away than over a sign.
        const float farCost = 4 * FreePlaces::kObject * size.x * size.y;
        PlaceBox best{};
        float least = FLT_MAX;
        for (int i = 0; i < kFarther; ++i) {
            const float r = name.radius + theme_.em * 0.15f + static_cast<float>(i) * size.y;
            const float right = name.icon.x + r, left = name.icon.x - r - size.x, middle = name.icon.x - size.x / 2;
            const float below = name.icon.y + r, above = name.icon.y - r - size.y, beside = name.icon.y - size.y / 2;
            for (const ImVec2& corner : {ImVec2(right, beside), ImVec2(left, beside), ImVec2(middle, below), ImVec2(middle, above),
                                         ImVec2(right, below), ImVec2(left, below), ImVec2(right, above), ImVec2(left, above)}) {
                const PlaceBox box = places_.within(corner, size);
                const float cost = places_.cost(box) + static_cast<float>(i) * farCost;
                if (cost >= least) continue;
                best = box;
                least = cost;
            }
        }
        return best;
    }

    ImDrawList& list_;
    FreePlaces& places_;
    const Theme& theme_;
    std::vector<Name> names_;
};

/// How a handle is drawn.
struct Look {
    bool selected = false, hovered = false, flashes = false;
    bool isCurrent = false; ///< of several lights the one that stages and verdicts are about
    [[nodiscard]] bool stands() const { return selected || hovered || flashes; }
    [[nodiscard]] ImU32 color() const { return stands() ? kAccent : kPlateText; }
    [[nodiscard]] ImU32 nameColor() const { return isCurrent ? kAccent : color(); }
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

/// A disc behind the icon, larger than it: seen from the last row.
void drawFlash(ImDrawList& list, ImVec2 place, const Theme& theme) {
    list.AddCircleFilled(place, theme.em * 1.7f, kDark);
    list.AddCircleFilled(place, theme.em * 1.6f, kAccent);
    list.AddCircleFilled(place, theme.em * 1.25f, kDark);
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
    list.AddTriangleFilled(at(1.75, 0), at(0.85, -0.75), at(0.85, 0.75), kDark);
    list.AddTriangleFilled(at(1.6, 0), at(0.95, -0.5), at(0.95, 0.5), look.color());
    list.AddCircleFilled(at(0, 0), r + 2, kDark);
    if (handle.what.kind == Selection::Kind::light) drawRays(list, at(0, 0), r, look.color(), theme);
    list.AddCircleFilled(at(0, 0), r, look.color());
    plates.keepFree(at(1.3, 0), theme.em * 0.5f);
    plates.add(at(0, 0), theme.em * 0.9f, handle.label, look.nameColor());
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
    const float r = theme.em * (light ? 0.5f : 0.32f);
    if (look.flashes) drawFlash(list, *place, theme);
    if (look.selected) drawArrows(list, seen, handle, *place, theme);
    list.AddCircleFilled(*place, r + 2, kDark);
    if (light) drawRays(list, *place, r, look.color(), theme);
    list.AddCircleFilled(*place, r, look.color());
    if (light || look.stands()) plates.add(*place, light ? 2 * r : r + 2, handle.label, look.nameColor());
}

/// The light that stages are about, for a moment after it was chosen: on and off, first on.
bool flashes(const WindowState& ui, const Selection& what) {
    const double left = ui.flashUntil - ImGui::GetTime();
    return left > 0 && what == Selection{Selection::Kind::light, ui.bench.document().light} &&
           static_cast<int>((kFlashSeconds - left) / kFlashTurnSeconds) % 2 == 0;
}

} // namespace

void drawGizmos(ImDrawList& list, WindowState& ui, const ShownPane& pane, FreePlaces& places, const Theme& theme) {
    if (!ui.shown.handles || !showsHandles(ui, pane)) return;
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
    plates.draw();
}

} // namespace shadowlab::window
