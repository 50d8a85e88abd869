// What a picture of the calibration board (calibration_board.h) says about the renderer that drew it.
//
// First the board is searched for, in all orientations and at scales from a half to two. Then the squares' centres of gravity are
// compared with where they should be, which gives shift, scale and turn, or where these do not suffice the place and the way of the camera that
// saw them so (camera_fit.h); then the wedge gives the encoding, and the cells the camera that the board was made for. A filter for
// antialiasing is symmetric, so it moves no centre of gravity. What is cut off by the picture's edge is not measured.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/foreign/calibration_board.h"
#include "app/foreign/tone_curve.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::foreign {

enum class CalibrationFault {
    notTheBoard, ///< nothing like it is seen
    size,        ///< the picture has another size
    orientation, ///< mirrored or turned by quarters
    shift,       ///< moved, as when pixel centres are taken for corners
    view,        ///< another angle of view, aspect, or step from pixel to pixel
    turn,        ///< turned or sheared by a small angle
    camera,      ///< seen from elsewhere, or as by no pinhole
    otherBoard,  ///< made for another camera, or of none that is known
    cut,         ///< too little of it lies in the picture to be measured
    encoding,    ///< another curve than sRGB, or none that is known
    channels,    ///< red, green and blue in another order
};

std::string_view toText(CalibrationFault fault);

struct FoundFault {
    CalibrationFault fault = CalibrationFault::notTheBoard;
    std::string what;   ///< with its number: "shifted by 0.50 pixels to the right"
    std::string remedy; ///< what to change in the renderer
};

/// How the picture lies: a point of the board at (x, y) from its middle is seen at (x, y) with these changes, in their order.
struct Orientation {
    bool swapsAxes = false; ///< asked for in square pictures only
    bool mirrorsX = false, mirrorsY = false;
    friend bool operator==(const Orientation&, const Orientation&) = default;
};
/// "mirrored left to right", "upside down", "turned by 180 degrees" ...; empty: as it should be.
std::string toText(const Orientation& orientation);
/// The picture put upright, if it lies so.
image::Image putUpright(const image::Image& picture, const Orientation& orientation);

/// A camera from which the squares are seen where the picture has them.
struct FittedCamera {
    dvec3 movedWorld{0.0};    ///< metres, from the scene's camera
    double awayDegrees = 0;   ///< between the two directions of view
    double rolledDegrees = 0; ///< counter-clockwise, about the direction of view
    double fovYDegrees = 0;   ///< vertical
    double worstPx = 0;       ///< largest distance of a square from where this camera would see it
};

struct Calibration {
    std::vector<FoundFault> faults; ///< the first is to be mended first; none: it is right
    double likeness = 0;            ///< correlation with the board, -1 to 1
    Orientation orientation;
    std::optional<dvec2> shiftPx;       ///< right and down, of the picture put upright; none: too few squares are whole in it, so scale and turn are not known either
    dvec2 scale{1.0};                   ///< seen size over the right one
    double turnDegrees = 0;             ///< counter-clockwise
    int wholeSquares = 0;               ///< of the board's eight
    std::optional<FittedCamera> camera; ///< only where shift, scale and turn do not say why the squares are where they are
    std::optional<std::uint16_t> code;  ///< of the camera (camera_code.h) as its cells have it; none: they cannot be read
    std::optional<ToneCurve> curve;     ///< none: no curve that is known fits
    double curveError = 0;              ///< of the nearest curve, levels of 255, root of the mean square
    double exposure = 1;                ///< light that is shown over light that should be; of that curve
    [[nodiscard]] bool isRight() const { return faults.empty(); }
};

/// Shifts of less are taken for what measuring leaves.
constexpr double kLeastShiftPx = 0.15;
/// And so is what moves the picture's corner by less.
constexpr double kLeastCornerPx = 0.3;

/// The camera is that of the board, for the angles in what is said. Throws as boardLayout().
Calibration readCalibration(const image::Image& picture, const scene::Camera& camera, ivec2 size);

} // namespace shadowlab::foreign
