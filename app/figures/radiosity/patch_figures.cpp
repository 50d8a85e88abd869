// The lecture's two figures of radiosity, each alone: the form factor of two surfaces, and a Lambertian reflector.
// SPDX-License-Identifier: MIT
#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/probed/patch_exchange.h"

namespace shadowlab::figures {

namespace {

const PatchExchange& exchangeOf(const FigureSource& source) {
    eyeRayOf(source);
    if (source.technique != "radiosity")
        throw Error(ExitStatus::badInput, std::string(source.technique) + " has no patches to draw; ask radiosity");
    if (!source.probe.find<PatchExchange>())
        throw Error(ExitStatus::badInput, "no patch is there: a light, or the inside of a closed body; choose another "
                                          "pixel");
    return *source.probe.find<PatchExchange>();
}

} // namespace

Diagram drawFormFactorFigure(const FigureSource& source) {
    const PatchExchange& exchange = exchangeOf(source);
    if (!exchange.k)
        throw Error(ExitStatus::badInput, "no second patch is there that exchanges light with the first; choose two "
                                          "other pixels");
    drawing::Drawing drawing(source.size);
    drawFormFactor(drawing, roomOf(source), exchange, source.font);
    return {std::move(drawing), "The form factor of two surfaces: their normals, r, and the angles"};
}

Diagram drawReflectorFigure(const FigureSource& source) {
    const PatchExchange& exchange = exchangeOf(source);
    drawing::Drawing drawing(source.size);
    drawReflector(drawing, roomOf(source), exchange, source.probe.geometry.front().fromWorld, source.font);
    return {std::move(drawing), "The radiosity of a Lambertian reflector: its light in all directions"};
}

} // namespace shadowlab::figures
