// SPDX-License-Identifier: MIT
#include "app/diagram/figures.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/diagram/panels.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/nearest_names.h"

namespace shadowlab::diagram {

namespace {

Diagram drawPixel(const FigureSource& source) {
    const Probe& probe = source.probe;
    if (!canDraw(probe))
        throw Error(ExitStatus::badInput, probe.geometry.empty() ? "the pixel shows the background; choose another"
                                          : source.scene.lights.empty()
                                              ? "scene '" + source.scene.name +
                                                    "' has no lights, so no shadow is there to draw; choose "
                                                    "another scene"
                                              : std::string(source.technique) +
                                                    " has nothing to draw there; ask another, as "
                                                    "shadow-volume or ray-traced");
    // As wide as its own sheet is, and so high that it fills the room when it is scaled.
    const double fit = std::min(1.0, source.size.x / kSheetWidth);
    return pixelDiagram(probe, source.scene, source.font, source.size.y / fit);
}

constexpr std::array kFigures{
    Figure{
        "pixel", "every technique that tells how it decided",
        "all that the technique has to draw of the pixel: shadow volumes, texels or the projected shadow in the plane "
        "through eye, light and point; rays and their tree; two patches and their form factor",
        drawPixel},
};

} // namespace

std::span<const Figure> figures() { return kFigures; }

const Figure& findFigure(std::string_view name) {
    std::vector<std::string> known;
    for (const Figure& figure : kFigures) {
        if (figure.name == name) return figure;
        known.emplace_back(figure.name);
    }
    throw Error(ExitStatus::usage, "no figure is called '" + std::string(name) + "'; " + suggestion(name, known));
}

} // namespace shadowlab::diagram
