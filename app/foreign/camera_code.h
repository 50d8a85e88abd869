// A camera as sixteen bits, which the calibration board shows as cells: so a board is known to belong to its camera.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "techniques/foundation/scene/model/camera.h"

namespace shadowlab::foreign {

/// Equal for equal cameras and shapes of the picture, and of two others once in 65536: of the eye's place, its axes, its angle of view and
/// the picture's width over its height. Numbers are rounded first, places to a tenth of a millimetre, so that a camera that was written and
/// read again keeps its code. Pixels, the target's distance, near and far plane do not count.
std::uint16_t cameraCode(const scene::Camera& camera, ivec2 size);

} // namespace shadowlab::foreign
