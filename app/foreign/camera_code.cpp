// SPDX-License-Identifier: MIT
#include "app/foreign/camera_code.h"

#include <cmath>

#include "techniques/foundation/base/fnv.h"

namespace shadowlab::foreign {

namespace {

std::uint64_t withRounded(double value, double step, std::uint64_t hash) {
    // Bytes from the lowest up, on every machine.
    const auto steps = static_cast<std::uint64_t>(std::llround(value / step));
    for (int shift = 0; shift < 64; shift += 8) {
        const auto byte = static_cast<std::uint8_t>(steps >> shift);
        hash = fnv(&byte, 1, hash);
    }
    return hash;
}

} // namespace

std::uint16_t cameraCode(const scene::Camera& camera, ivec2 size) {
    // Finer than single precision would be noise of files; a step of axes is seen as less than a hundredth of a pixel.
    constexpr double kMetresStep = 1e-4, kAxisStep = 1e-5, kDegreesStep = 1e-4, kAspectStep = 1e-3;
    std::uint64_t hash = kFnvBasis;
    const dmat4 viewFromWorld = scene::viewFromWorld(camera);
    for (int axis = 0; axis < 3; ++axis) {
        hash = withRounded(camera.positionWorld[axis], kMetresStep, hash);
        // Up and back: what is right of both follows from them.
        for (const int row : {1, 2})
            hash = withRounded(viewFromWorld[axis][row], kAxisStep, hash);
    }
    hash = withRounded(camera.fovYDegrees, kDegreesStep, hash);
    hash = withRounded(static_cast<double>(size.x) / size.y, kAspectStep, hash);
    constexpr int kBits = 16;
    return static_cast<std::uint16_t>(hash ^ hash >> kBits ^ hash >> 2 * kBits ^ hash >> 3 * kBits);
}

} // namespace shadowlab::foreign
