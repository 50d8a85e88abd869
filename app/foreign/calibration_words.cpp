// SPDX-License-Identifier: MIT
#include "app/foreign/calibration_words.h"

#include <algorithm>
#include <cmath>

#include "app/picture/verdict_reasons.h"

namespace shadowlab::foreign {

namespace {

using picture::fixed;

std::string sizeText(ivec2 size) { return std::to_string(size.x) + " x " + std::to_string(size.y); }

/// What is seen in the picture's corner instead of what belongs there moves by more pixels than this: less is measuring.
constexpr double kLeastCornerPx = 0.3;

} // namespace

std::string_view toText(CalibrationFault fault) {
    switch (fault) {
    case CalibrationFault::notTheBoard: return "not-the-board";
    case CalibrationFault::size: return "size";
    case CalibrationFault::orientation: return "orientation";
    case CalibrationFault::shift: return "shift";
    case CalibrationFault::view: return "view";
    case CalibrationFault::turn: return "turn";
    case CalibrationFault::encoding: return "encoding";
    case CalibrationFault::channels: return "channels";
    }
    return "";
}

std::string toText(const Orientation& orientation) {
    const auto [swaps, x, y] = orientation;
    if (!swaps) return x && y ? "turned by 180 degrees" : x ? "mirrored left to right" : y ? "upside down" : "";
    return x && y ? "mirrored at the diagonal from the lower left"
           : x    ? "turned by 90 degrees clockwise"
           : y    ? "turned by 90 degrees counter-clockwise"
                  : "mirrored at the diagonal from the upper left";
}

FoundFault sizeFault(ivec2 seen, ivec2 wanted) {
    const bool swapped = seen.x == wanted.y && seen.y == wanted.x;
    return {CalibrationFault::size, "is " + sizeText(seen) + " pixels, not " + sizeText(wanted) + (swapped ? ": width and height are swapped" : ""),
            "draw it with " + std::to_string(wanted.x) + " columns and " + std::to_string(wanted.y) +
                " rows, or name its size with --size"};
}

FoundFault strangerFault(double likeness) {
    return {CalibrationFault::notTheBoard, "does not look like the calibration board (correlation " + fixed(likeness, 2) + ")",
            "draw the scene 'calibration' that `shadowlab export` writes beside the scene, from the same camera"};
}

FoundFault orientationFault(const Orientation& orientation) {
    std::string remedy = "write its rows from the top and its columns from the left";
    if (!orientation.swapsAxes && orientation.mirrorsY && !orientation.mirrorsX) remedy = "write its rows from the top: OpenGL reads them from the bottom";
    if (!orientation.swapsAxes && orientation.mirrorsX && !orientation.mirrorsY) remedy = "let x run to the right: view space is right-handed, the camera looks down -z";
    return {CalibrationFault::orientation, "is " + toText(orientation), remedy};
}

std::optional<FoundFault> viewFault(const Calibration& found, const scene::Camera& camera, ivec2 size) {
    const dvec2 scale = found.scale, corner = glm::abs(scale - 1.0) * 0.5 * dvec2(size);
    // Without squares the scale is only known to a hundredth.
    const double least = found.shiftPx ? kLeastCornerPx : 0.01 * size.x;
    if (corner.x < least && corner.y < least) return std::nullopt;
    const double aspect = static_cast<double>(size.x) / size.y, even = std::sqrt(scale.x * scale.y);
    const auto isNear = [](double a, double b) { return std::abs(a / b - 1) < 0.02; }; // of scales as far apart as these
    FoundFault fault{CalibrationFault::view, "", ""};
    // A picture whose pixels are a step of (size - 1) apart is larger by one pixel over its whole width.
    const dvec2 extra = (scale - 1.0) * dvec2(size);
    const auto isOne = [](double pixels) { return std::abs(std::abs(pixels) - 1) < 0.35; };
    if (isOne(extra.x) && isOne(extra.y) && extra.x * extra.y > 0) {
        fault.what = std::string("is one pixel ") + (extra.x > 0 ? "larger" : "smaller") + " than it should be over its whole width and height";
        fault.remedy = "divide by the number of pixels, not by one less: pixel x has its centre at (x + 0.5) / width";
        return fault;
    }
    const double fovY = glm::degrees(2 * std::atan(std::tan(glm::radians(camera.fovYDegrees) / 2) / scale.y));
    if (!isNear(scale.x, scale.y)) {
        fault.what = "is stretched: " + fixed(scale.x, 3) + " times as wide and " + fixed(scale.y, 3) + " times as high as it should be";
        fault.remedy = "the aspect is width over height, " + fixed(aspect, 4) + ", and pixels are square";
    } else if (isNear(even, aspect) && aspect > 1) {
        fault.what = "shows everything " + fixed(even, 3) + " times too large: " + fixed(camera.fovYDegrees, 2) + " degrees were taken for the horizontal angle of view";
        fault.remedy = "they are the vertical one; the horizontal one is " +
                       fixed(glm::degrees(2 * std::atan(std::tan(glm::radians(camera.fovYDegrees) / 2) * aspect)), 4) + " degrees";
    } else {
        fault.what = "shows everything " + fixed(even, 3) + " times as large as it should be: the vertical angle of view is about " + fixed(fovY, 1) + " degrees";
        fault.remedy = "use a vertical angle of view of " + fixed(camera.fovYDegrees, 4) + " degrees, and the scene's camera position";
    }
    return fault;
}

std::optional<FoundFault> turnFault(const Calibration& found, const dvec2& perX, const dvec2& perY, ivec2 size) {
    if (std::abs(perX.y) * size.x / 2 < kLeastCornerPx && std::abs(perY.x) * size.y / 2 < kLeastCornerPx) return std::nullopt;
    return FoundFault{CalibrationFault::turn, "is turned by " + fixed(found.turnDegrees, 2) + " degrees or sheared",
                      "point the camera at the scene's target with the scene's up vector"};
}

std::string shiftText(const dvec2& shiftPx) {
    const auto part = [](double pixels, const char* more, const char* less) {
        return fixed(std::abs(pixels), 2) + (pixels > 0 ? more : less);
    };
    const bool x = std::abs(shiftPx.x) >= 0.05, y = std::abs(shiftPx.y) >= 0.05; // what would be written as 0.0
    if (x && y) return part(shiftPx.x, " pixels to the right", " pixels to the left") + " and " + part(shiftPx.y, " down", " up");
    if (x || !y) return part(shiftPx.x, " pixels to the right", " pixels to the left");
    return part(shiftPx.y, " pixels down", " pixels up");
}

std::string shiftRemedy(const dvec2& shiftPx) {
    const auto isHalf = [](double pixels) { return std::abs(pixels) < kLeastShiftPx || std::abs(std::abs(pixels) - 0.5) < kLeastShiftPx; };
    if (isHalf(shiftPx.x) && isHalf(shiftPx.y))
        return "send the ray of pixel (x, y) through (x + 0.5, y + 0.5): pixels have their centres there, not their corners";
    return "take the camera's axis through the middle of the picture, without lens shift";
}

std::optional<FoundFault> shiftFault(const Calibration& found) {
    if (!found.shiftPx || (std::abs(found.shiftPx->x) < kLeastShiftPx && std::abs(found.shiftPx->y) < kLeastShiftPx))
        return std::nullopt;
    return FoundFault{CalibrationFault::shift, "is shifted by " + shiftText(*found.shiftPx), shiftRemedy(*found.shiftPx)};
}

std::optional<FoundFault> encodingFault(const Calibration& found) {
    if (found.curve == ToneCurve::srgb) return std::nullopt;
    FoundFault fault{CalibrationFault::encoding, "", ""};
    if (!found.curve) {
        fault.what = "has greys that fit no curve that is known (the nearest is " + fixed(found.curveError, 1) + " levels of 255 off)";
        fault.remedy = "turn tone mapping off (Blender: view transform Standard; three.js: NoToneMapping), and write sRGB";
        return fault;
    }
    fault.what = "is encoded with " + std::string(toText(*found.curve)) + ", not with sRGB";
    switch (*found.curve) {
    case ToneCurve::linear: fault.remedy = "encode the light as sRGB before the PNG is written"; break;
    case ToneCurve::doubleSrgb: fault.remedy = "encode once: the frame buffer or the writer already encodes"; break;
    case ToneCurve::decoded: fault.remedy = "encode the light as sRGB: here it was decoded instead"; break;
    default: fault.remedy = "use the sRGB curve (IEC 61966-2-1), which is no power of 2.2 in the dark"; break;
    }
    return fault;
}

std::optional<FoundFault> channelFault(const std::array<dvec3, 3>& patches) {
    std::array<int, 3> brightest{};
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3& patch = patches[i];
        brightest[i] = patch.y > patch.x && patch.y >= patch.z ? 1 : patch.z > patch.x ? 2 : 0;
        // A grey picture has no order of channels.
        if (patch[brightest[i]] - std::min({patch.x, patch.y, patch.z}) < 0.1) return std::nullopt;
    }
    if (brightest == std::array{0, 1, 2}) return std::nullopt;
    const bool reversed = brightest == std::array{2, 1, 0};
    return FoundFault{CalibrationFault::channels, reversed ? "has red and blue exchanged" : "has its channels in another order",
                      "write red, green and blue in this order"};
}

} // namespace shadowlab::foreign
