// The calibration board: a picture that another renderer draws beside the scene, from the same camera and in the same size, and by
// which size, orientation, pixel centres, angle of view and the encoding of light are checked (calibration_reading.h) before any
// shadow is judged.
//
// All of it shines by itself, so no light and no shading model matters. Four squares, each of another size and turned by ten
// degrees, stand near the corners: they tell flips and turns apart, and since their edges pass pixel centres at all distances,
// their centres of gravity are known to some hundredths of a pixel, whether the renderer takes one sample a pixel or many. Four small ones stand
// nearer to the middle: they remain where the picture shows half of the view only. A wedge of ten greys in the middle shows the
// encoding, three patches below it the order of the channels, and cells at the bottom the code of the camera (camera_code.h). A black
// rectangle behind them fills the view.
//
// Neighbouring squares stand at two distances from the eye. From the right camera that is not seen; from another place they move against each
// other, so that a wrong place is told apart from a wrong angle or direction.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::foreign {

/// Linear radiances of the wedge, from left to right. The dark ones tell sRGB from a power of 2.2.
inline constexpr std::array kWedge{0.005, 0.02, 0.05, 0.1, 0.18, 0.3, 0.45, 0.6, 0.8, 1.0};
inline constexpr std::array<std::array<double, 3>, 3> kChannelPatches{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr double kTurnedDegrees = 10; ///< of the squares, counter-clockwise as seen
constexpr int kLeastBoardSide = 64;   ///< pixels; in a smaller picture the squares are too small to be measured
constexpr int kCodeBits = 16;         ///< of the camera

/// A rectangle of the board. Pixels count from the upper left corner, (x + 0.5, y + 0.5) is a pixel's centre.
struct BoardPatch {
    dvec2 centrePx{0.0}, sizePx{0.0};
    double turnedDegrees = 0;
    dvec3 radiance{0.0}; ///< linear RGB
    bool isFar = false;  ///< it stands farther behind, and is larger by as much
};

struct BoardLayout {
    std::array<BoardPatch, 8> squares;             ///< upper left, upper right, lower left, lower right; then the small ones
    std::array<BoardPatch, kWedge.size()> wedge;   ///< from left to right; edges between pixels
    std::array<BoardPatch, 3> channels;            ///< red, green, blue
    /// Of each bit, the lowest first, an upper and a lower cell. If the bit is 1 the upper one is white, else the lower, and the other is not
    /// there: so a bit is read without asking how bright white is.
    std::array<std::array<BoardPatch, 2>, kCodeBits> code;
    /// All that is the same for every camera: no cells.
    [[nodiscard]] std::vector<BoardPatch> all() const;
};
/// Throws Error (badInput) for a picture with a side below kLeastBoardSide.
BoardLayout boardLayout(ivec2 size);

/// Where the patch's middle is in the camera's view space, metres.
dvec3 placeInView(const BoardPatch& patch, const scene::Camera& camera, ivec2 size);

/// The board as a scene: its camera is the given one, it has no light, no ambient light and a black background, and each patch is
/// a quad (makeQuad) that faces the camera and shines to both sides. It stands as far away as the camera's target, or just
/// beyond the near plane, and its far squares half as far again, or half-way to the far plane. Named "calibration". Throws as boardLayout().
scene::Scene calibrationBoard(const scene::Camera& camera, ivec2 size);

} // namespace shadowlab::foreign
