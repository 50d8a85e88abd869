// SPDX-License-Identifier: MIT
#include "app/foreign/calibration_words.h"

#include <algorithm>
#include <cmath>

#include "app/foreign/causes.h"
#include "app/picture/verdict_reasons.h"

namespace shadowlab::foreign {

namespace {

using picture::fixed;

std::string sizeText(ivec2 size) { return std::to_string(size.x) + " x " + std::to_string(size.y); }

std::string codeText(std::uint16_t code) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 12; shift >= 0; shift -= 4)
        text += kDigits[code >> shift & 15];
    return text;
}

} // namespace

std::string_view toText(CalibrationFault fault) {
    switch (fault) {
    case CalibrationFault::notTheBoard: return "not-the-board";
    case CalibrationFault::size: return "size";
    case CalibrationFault::orientation: return "orientation";
    case CalibrationFault::shift: return "shift";
    case CalibrationFault::view: return "view";
    case CalibrationFault::turn: return "turn";
    case CalibrationFault::camera: return "camera";
    case CalibrationFault::otherBoard: return "other-board";
    case CalibrationFault::cut: return "cut";
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

FoundFault otherBoardFault(std::uint16_t seen, std::uint16_t wanted) {
    return {CalibrationFault::otherBoard,
            "is of a board that was made for another camera or another shape of the picture (its cells say " + codeText(seen) + "; this camera has " + codeText(wanted) + ")",
            "export the scene again, with the view and the size that are judged, and draw the board that is written beside it"};
}

FoundFault noCodeFault() {
    return {CalibrationFault::otherBoard, "shows no code of a camera: of each two cells at its bottom one should be white and one black",
            "draw the board that this version of `shadowlab export` writes, as it is"};
}

FoundFault cutFault(int whole, int all) {
    return {CalibrationFault::cut, "shows the board too large or too far aside to be measured: of its " + std::to_string(all) + " squares " + std::to_string(whole) +
                                       (whole == 1 ? " lies" : " lie") + " in it as a whole, the picture's edge cuts off the others",
            "see first that the vertical angle of view and the aspect are those of the scene's camera, and where the camera stands and looks"};
}

FoundFault orientationFault(const Orientation& orientation) {
    std::string remedy = "write its rows from the top and its columns from the left";
    if (!orientation.swapsAxes && orientation.mirrorsY && !orientation.mirrorsX) remedy = "write its rows from the top: OpenGL reads them from the bottom";
    if (!orientation.swapsAxes && orientation.mirrorsX && !orientation.mirrorsY) remedy = "let x run to the right: view space is right-handed, the camera looks down -z";
    return {CalibrationFault::orientation, "is " + toText(orientation), remedy};
}

std::optional<FoundFault> viewFault(const Calibration& found, const scene::Camera& camera, ivec2 size) {
    const dvec2 scale = found.scale, corner = glm::abs(scale - 1.0) * 0.5 * dvec2(size);
    if (corner.x < kLeastCornerPx && corner.y < kLeastCornerPx) return std::nullopt;
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

std::optional<FoundFault> cameraFault(const std::optional<FittedCamera>& fit, double missPx, const scene::Camera& camera, ivec2 size) {
    const std::string misses = "has the board's squares up to " + fixed(missPx, 1) + " pixels from where ";
    constexpr const char* kStraight = "draw it by straight rays from one point: no lens, no depth of field, no distortion";
    if (!fit) {
        if (missPx < kLeastCornerPx) return std::nullopt; // a shear is said as such
        return FoundFault{CalibrationFault::camera, misses + "a camera at the right place would show them", std::string("take the position of the scene's camera, and ") + kStraight};
    }
    if (fit->worstPx >= kLeastCornerPx) {
        if (missPx < kLeastCornerPx) return std::nullopt;
        return FoundFault{CalibrationFault::camera, misses + "a pinhole camera would show them", kStraight};
    }
    const double distance = glm::length(camera.targetWorld - camera.positionWorld), metres = glm::length(fit->movedWorld);
    // What is less is what measuring leaves of the seven numbers: so much in a picture of 180 rows, and more in a smaller one.
    const double smaller = std::max(180.0 / std::min(size.x, size.y), 1.0);
    const double leastShare = 0.004 * smaller, leastDegrees = 0.15 * smaller;
    std::vector<std::string> parts;
    if (metres > leastShare * distance)
        parts.push_back("it stands " + metresText(metres) + " from the scene's, moved by (" + fixed(fit->movedWorld.x, 3) + ", " + fixed(fit->movedWorld.y, 3) + ", " +
                        fixed(fit->movedWorld.z, 3) + ") m");
    if (fit->awayDegrees > leastDegrees) parts.push_back("it looks " + fixed(fit->awayDegrees, 1) + " degrees past where it should");
    if (std::abs(fit->rolledDegrees) > leastDegrees) parts.push_back("it is rolled by " + fixed(fit->rolledDegrees, 1) + " degrees");
    if (std::abs(fit->fovYDegrees - camera.fovYDegrees) > 2 * leastDegrees)
        parts.push_back("its vertical angle of view is about " + fixed(fit->fovYDegrees, 1) + " degrees instead of " + fixed(camera.fovYDegrees, 1));
    if (parts.empty()) return std::nullopt;
    FoundFault fault{CalibrationFault::camera, "was drawn from another camera:", "take the position, the target, the up vector and the angle of the scene's camera"};
    for (std::size_t i = 0; i < parts.size(); ++i)
        fault.what += (i == 0 ? " " : i + 1 == parts.size() ? ", and " : ", ") + parts[i];
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
