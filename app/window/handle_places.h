// Where the handles of lights and objects are seen in a pane.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/window/pane_frames.h"

namespace shadowlab::window {

inline constexpr float kIconEm = 1.25f; ///< radius of a light's icon, with all that may stand around it

/// A pane and the camera its picture was made with. Places are pixels of the window.
struct SeenPane {
    const ShownPane& pane;
    const scene::Camera& camera;
    ivec2 size;

    [[nodiscard]] std::optional<ImVec2> place(const dvec3& positionWorld) const;
    /// Where the icon is drawn: at its place, or so far beside it that the pane's edge or the split line does not cut it.
    [[nodiscard]] ImVec2 iconPlace(ImVec2 place, const Theme& theme) const;
    /// Of what the picture does not show: a light, or what is selected.
    [[nodiscard]] std::optional<lab::EdgeMark> edgeMark(const lab::Handle& handle, bool selected, const Theme& theme) const;
    /// The end of an axis arrow of a selected thing; nothing when it points at the eye.
    [[nodiscard]] std::optional<ImVec2> arrowEnd(const lab::Handle& handle, int axis, const Theme& theme) const;
    /// From the picture's upper left corner.
    [[nodiscard]] dvec2 pixel(ImVec2 mouse) const {
        return {mouse.x - pane.pictureCorner.x, mouse.y - pane.pictureCorner.y};
    }
};
SeenPane seenIn(const ShownPane& pane, const scene::Camera& camera);

/// What is seen from elsewhere, by the second camera or by a light, has other places for them.
bool showsHandles(const WindowState& ui, const ShownPane& pane);

} // namespace shadowlab::window
