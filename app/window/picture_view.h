// From where the picture of a pane is taken, and where the picked point is in it: seen by the eye, by the second camera, or by a light.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/window/free_places.h"

namespace shadowlab::window {

/// A picture of a size of its own, a light's view of the scene, as large as fits into the pane, in the middle.
PlaceBox fittedPicture(ImVec2 size, const Area& area);

/// A picture by a camera.
class PictureView {
public:
    /// `picture`: the whole of it, pixels of the window.
    PictureView(const scene::Camera& camera, const PlaceBox& picture);
    [[nodiscard]] const PlaceBox& picture() const { return picture_; }
    /// Of a point of the scene, pixels of the window; nothing behind the camera.
    [[nodiscard]] std::optional<ImVec2> place(const dvec3& positionWorld) const;

private:
    PlaceBox picture_;
    lab::PictureProjection projection_;
};
/// Of the eye or of the second camera; nothing where the picture is a light's, or there is none.
std::optional<PictureView> pictureView(const WindowState& ui, const ShownPane& shown);

/// Where the picked point is in the pane's picture: the pixel itself; seen from outside the point; in a picture taken from the light
/// the place at which it is looked up. Nothing where the picture does not show it, or its place is not known.
std::optional<ImVec2> pickedPlace(const WindowState& ui, const ShownPane& shown);

} // namespace shadowlab::window
