// SPDX-License-Identifier: MIT
#include "app/figures/pixel_diagram.h"

#include <array>
#include <charconv>
#include <cmath>

#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/map_probe.h"
#include "techniques/probed/patch_exchange.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

constexpr double kUpperHeight = 760, kPathsWidth = 1090, kBorder = 24;
constexpr double kPairHeight = 660, kReflectorHeight = 420; ///< a slide in all

const drawing::Stroke kRule{"#bfbfbf", 2, false};

Diagram drawTreePanels(const Probe& probe, const scene::Scene& scene, const image::Font& font) {
    const ShownTree shown = shownTree(probe);
    const double height = kUpperHeight + treeHeight(probe, shown) + kBorder;
    drawing::Drawing drawing({kSheetWidth, height});
    drawPaths(drawing, {{kBorder, kBorder}, {kPathsWidth - 2 * kBorder, kUpperHeight - 2 * kBorder}}, probe, shown,
              scene, font);
    drawVectors(
        drawing,
        {{kPathsWidth + kBorder, kBorder}, {kSheetWidth - kPathsWidth - 2 * kBorder, kUpperHeight - 2 * kBorder}},
        probe, font);
    drawTree(drawing, {{kBorder, kUpperHeight}, {kSheetWidth - 2 * kBorder, height - kUpperHeight - kBorder}}, probe,
             shown, font);
    drawing.line({kPathsWidth, kBorder}, {kPathsWidth, kUpperHeight - kBorder}, kRule);
    drawing.line({kBorder, kUpperHeight - kBorder / 2}, {kSheetWidth - kBorder, kUpperHeight - kBorder / 2}, kRule);
    return {std::move(drawing), "Paths of pixel rays, the ray-tracing tree, and the vectors at its first surface"};
}

Diagram drawPatchPanels(const Probe& probe, const image::Font& font) {
    const PatchExchange& exchange = *probe.find<PatchExchange>();
    const double upper = exchange.k ? kPairHeight : 0, height = upper + kReflectorHeight;
    drawing::Drawing drawing({kSheetWidth, height});
    const double width = kSheetWidth - 2 * kBorder;
    if (exchange.k) {
        drawFormFactor(drawing, {{kBorder, kBorder}, {width, upper - 2 * kBorder}}, exchange, font);
        drawing.line({kBorder, upper - kBorder / 2}, {kSheetWidth - kBorder, upper - kBorder / 2}, kRule);
    }
    drawReflector(drawing, {{kBorder, upper + kBorder / 2}, {width, height - upper - kBorder}}, exchange,
                  probe.geometry.front().fromWorld, font);
    return {std::move(drawing), exchange.k
                                    ? "The form factor of two surfaces, and the radiosity of a Lambertian reflector"
                                    : "The radiosity of a Lambertian reflector"};
}

Diagram drawSection(const Probe& probe, const scene::Scene& scene, const image::Font& font, const dvec2& size) {
    drawing::Drawing drawing(size);
    const drawing::Box area{dvec2(kBorder), size - 2 * kBorder};
    if (probe.find<VolumeProbe>()) {
        drawVolume(drawing, area, probe, scene, font);
        return {std::move(drawing),
                "Shadow volumes in the plane through eye, light and point, and the faces that the eye's line crosses"};
    }
    if (probe.find<MapProbe>()) {
        drawMap(drawing, area, probe, scene, font);
        return {std::move(drawing),
                "The shadow map's texels in the plane through eye, light and point, and those beside the point"};
    }
    drawPlane(drawing, area, probe, scene, font);
    return {std::move(drawing),
            "The light, the caster, and its shadow on the receiver plane, in the plane through eye, light and point"};
}

} // namespace

drawing::Stroke strokeOf(Probe::Role role) {
    switch (role) {
    case Probe::Role::eye: return {"#1a1a1a", 4, false};
    case Probe::Role::reflection: return {drawing::colorText(look::kReflectionRay), 4, false};
    case Probe::Role::refraction: return {drawing::colorText(look::kRefractionRay), 4, false};
    case Probe::Role::arriving: return {drawing::colorText(look::kEqualDepth), 2.5, true};
    case Probe::Role::blocked: return {drawing::colorText(look::kOccluded), 2.5, true};
    }
    return {};
}

std::string colorNumbers(const dvec3& intensity) {
    const auto digits = [](double value) {
        const std::string text = std::to_string(value < 9.995 ? std::round(value * 100) / 100 : std::round(value));
        return text.substr(0, value < 9.995 ? 4 : text.find('.')); // "0.42", "137"
    };
    return digits(intensity.r) + " " + digits(intensity.g) + " " + digits(intensity.b);
}

std::string degreesText(double angle) {
    const std::string text = std::to_string(std::round(glm::degrees(angle) * 10) / 10);
    return text.substr(0, text.find('.') + 2) + "\u00b0";
}

std::string percent(double share) {
    const double rounded = share < 0.0995 ? std::round(share * 1000) / 10 : std::round(share * 100);
    if (share > 0 && rounded < 0.1) return "< 0.1 %";
    const std::string text = std::to_string(rounded);
    return text.substr(0, text.find('.') + (rounded < 10 ? 2 : 0)) + " %";
}

std::string fourDigits(double value) {
    std::array<char, 32> text{};
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value + 0.0, std::chars_format::general, 4); // no "-0"
    std::string digits = error == std::errc{} ? std::string(text.data(), end) : "?";
    if (digits.starts_with('-')) digits = "\u2212" + digits.substr(1);
    const std::size_t power = digits.find('e');
    if (power == std::string::npos) return digits;
    static constexpr std::array kRaised{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string raised = digits[power + 1] == '-' ? "\u207b" : "";
    for (std::size_t i = power + 2; i < digits.size(); ++i)
        if (digits[i] != '0' || i + 1 == digits.size() || digits[i - 1] != digits[power + 1])
            raised += kRaised[static_cast<std::size_t>(digits[i] - '0')];
    return digits.substr(0, power) + "\u00b710" + raised;
}

bool canDraw(const Probe& probe) { return !probe.tree.empty() || probe.find<PatchExchange>() || hasSection(probe); }

double leastWidth(const Probe& probe) {
    constexpr double kOfMap = 1200; // below it the texels beside the point and their numbers have no room beside the whole
    const bool isPlainMap = hasSection(probe) && probe.find<MapProbe>() && !hasTaps(*probe.find<MapProbe>());
    return isPlainMap ? kOfMap : kSheetWidth;
}

Diagram pixelDiagram(const Probe& probe, const scene::Scene& scene, const image::Font& font, double sectionHeight,
                     double sectionWidth) {
    if (hasSection(probe)) return drawSection(probe, scene, font, {sectionWidth, sectionHeight});
    return probe.find<PatchExchange>() ? drawPatchPanels(probe, font) : drawTreePanels(probe, scene, font);
}

} // namespace shadowlab::figures
