// Faults of a calibration in words, each with its number and its remedy.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "app/foreign/calibration_reading.h"

namespace shadowlab::foreign {

FoundFault sizeFault(ivec2 seen, ivec2 wanted);
FoundFault strangerFault(double likeness);
FoundFault orientationFault(const Orientation& orientation);

/// Of the code that the board shows, and that which the camera has.
FoundFault otherBoardFault(std::uint16_t seen, std::uint16_t wanted);
FoundFault noCodeFault();
/// Of a board of which so many squares of all lie in the picture as a whole.
FoundFault cutFault(int whole, int all);

// Nothing where what was found is within what measuring leaves.
std::optional<FoundFault> viewFault(const Calibration& found, const scene::Camera& camera, ivec2 size);
/// Of what fittedCamera() found; `missPx`: how far a square is from where shift, scale and turn have it.
std::optional<FoundFault> cameraFault(const std::optional<FittedCamera>& fit, double missPx, const scene::Camera& camera, ivec2 size);
/// `perX` and `perY`: what a pixel of the board to the right, and down, is in the picture.
std::optional<FoundFault> turnFault(const Calibration& found, const dvec2& perX, const dvec2& perY, ivec2 size);
std::optional<FoundFault> shiftFault(const Calibration& found);
std::optional<FoundFault> encodingFault(const Calibration& found);
/// The numbers, 0 to 1, of the red, the green and the blue patch.
std::optional<FoundFault> channelFault(const std::array<dvec3, 3>& patches);

/// "0.50 pixels to the right and 0.50 down"; of a shift in pixels, right and down.
std::string shiftText(const dvec2& shiftPx);
/// Of a picture that is shifted so.
std::string shiftRemedy(const dvec2& shiftPx);

} // namespace shadowlab::foreign
