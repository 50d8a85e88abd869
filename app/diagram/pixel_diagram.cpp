// SPDX-License-Identifier: MIT
#include "app/diagram/pixel_diagram.h"

#include "app/diagram/panels.h"
#include "techniques/foundation/look.h"

namespace shadowlab::diagram {

namespace {

constexpr double kUpperHeight = 760, kPathsWidth = 1090, kBorder = 24;

} // namespace

Stroke strokeOf(Probe::Role role) {
    switch (role) {
    case Probe::Role::eye: return {"#1a1a1a", 4, false};
    case Probe::Role::reflection: return {colorText(look::kReflectionRay), 4, false};
    case Probe::Role::refraction: return {colorText(look::kRefractionRay), 4, false};
    case Probe::Role::arriving: return {colorText(look::kEqualDepth), 2.5, true};
    case Probe::Role::blocked: return {colorText(look::kOccluded), 2.5, true};
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

std::string percent(double share) {
    const double rounded = share < 0.0995 ? std::round(share * 1000) / 10 : std::round(share * 100);
    if (share > 0 && rounded < 0.1) return "< 0.1 %";
    const std::string text = std::to_string(rounded);
    return text.substr(0, text.find('.') + (rounded < 10 ? 2 : 0)) + " %";
}

std::string pixelDiagram(const Probe& probe, const scene::Scene& scene, const image::Font& font) {
    const ShownTree shown = shownTree(probe);
    const double height = kUpperHeight + treeHeight(probe, shown) + kBorder;
    Svg svg({kSheetWidth, height});
    drawPaths(svg, {{kBorder, kBorder}, {kPathsWidth - 2 * kBorder, kUpperHeight - 2 * kBorder}}, probe, shown, scene,
              font);
    drawVectors(
        svg, {{kPathsWidth + kBorder, kBorder}, {kSheetWidth - kPathsWidth - 2 * kBorder, kUpperHeight - 2 * kBorder}},
        probe, font);
    drawTree(svg, {{kBorder, kUpperHeight}, {kSheetWidth - 2 * kBorder, height - kUpperHeight - kBorder}}, probe, shown,
             font);
    svg.line({kPathsWidth, kBorder}, {kPathsWidth, kUpperHeight - kBorder}, {"#bfbfbf", 2, false});
    svg.line({kBorder, kUpperHeight - kBorder / 2}, {kSheetWidth - kBorder, kUpperHeight - kBorder / 2},
             {"#bfbfbf", 2, false});
    return svg.document("Paths of pixel rays, the ray-tracing tree, and the vectors at its first surface");
}

} // namespace shadowlab::diagram
