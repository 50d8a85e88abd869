// The camera that saw the calibration board's squares where they are seen, if it is not the scene's.
//
// The squares stand at two distances from the eye (calibration_board.h). A change of angle, aspect or pixel centres moves, stretches or turns all of
// them alike; another place moves near ones against far ones. So a place, a way and an angle are searched for, by Gauss and Newton with Levenberg's
// damping, only where no such change suffices.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "app/foreign/calibration_reading.h"
#include "app/foreign/seen_squares.h"

namespace shadowlab::foreign {

/// Nothing for fewer than five squares: seven numbers need ten.
std::optional<FittedCamera> fittedCamera(const std::vector<SeenSquare>& seen, const BoardLayout& board, const scene::Camera& camera, ivec2 size);

/// Are the squares seen as if the board were moved, stretched or turned in the picture, as `placed` says? From elsewhere they are not.
bool isPlane(const std::vector<SeenSquare>& seen, const Placement& placed, ivec2 size);

} // namespace shadowlab::foreign
