// SPDX-License-Identifier: MIT
#include "app/figures/figures.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/pixel_diagram.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::figures {

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
    const double width = std::clamp(source.size.x, leastWidth(probe), kSheetWidth);
    return pixelDiagram(probe, source.scene, source.font, source.size.y * std::max(1.0, width / source.size.x), width);
}

constexpr std::array kFigures{
    Figure{
        "pixel", "every technique that tells how it decided",
        "all that the technique has to draw of the pixel: shadow volumes, texels or the projected shadow in the plane "
        "through eye, light and point; rays and their tree; two patches and their form factor",
        drawPixel},
    Figure{"shadow-ray", "planar, shadow-map and shadow volumes",
           "the segment from the pixel's point to the light, and the object that it meets", drawShadowRay, kSectionBorder},
    Figure{"projection", "planar",
           "the light P_L, a point P of the caster, its projection P' in the receiver's plane, and the plane's normal N",
           drawProjection, kSectionBorder},
    Figure{
        "cameras", "shadow-map",
        "the axes of eye and light, the shadow map across the light's frustum, and w(u,v), d(u,v), z(u,v) of the point",
        drawCamerasFigure, kSectionBorder},
    Figure{"passes", "shadow-map", "the passes of a frame, and how many polygons each of them draws", drawPassesFigure},
    Figure{"count", "shadow volumes",
           "the line that z-pass or z-fail follows, the faces of volumes that it crosses, n_f and n_b",
           drawCountFigure, kSectionBorder},
    Figure{"plus-one", "shadow volumes",
           "the silhouette polygons between the eye and the pixel, +1 or −1, and the scene polygon", drawPlusOneFigure, kSectionBorder},
    Figure{"polygon", "shadow volumes",
           "N, L and the sign of N·L of the polygon that the pixel shows, and of one that is turned to the other side",
           drawPolygonFigure, kSectionBorder},
    Figure{
        "edge", "shadow volumes",
        "the outline edge nearest to the pixel between the two polygons that share it, and an edge that is no outline",
        drawEdgeFigure, kSectionBorder},
    Figure{"extrusion", "shadow volumes", "P_L, P, P' and d of a vertex of the outline", drawExtrusionFigure, kSectionBorder},
    Figure{"volume", "shadow volumes",
           "the volume of one caster, its caps and sides, and the curve along which it cuts other objects",
           drawVolumeFigure, kSectionBorder},
    Figure{"form-factor", "radiosity", "two patches with their normals, the line r between them and its angles; F_jk",
           drawFormFactorFigure},
    Figure{"reflector", "radiosity", "the light of a patch in all directions, I dA cos phi", drawReflectorFigure},
    Figure{"equations", "radiosity",
           "the radiosity equations as a matrix, some rows with the scene's numbers, the solution", drawEquations},
    Figure{"pixel-ray", "ray-traced",
           "projection reference point, projection plane, the pixel's centre and its ray to the first surface",
           drawPixelRay},
    Figure{"paths", "ray-traced", "paths of the pixel's rays, in the plane of incidence", drawPathsFigure},
    Figure{"tree", "ray-traced", "the tree of the same rays, with intensities", drawTreeFigure},
    Figure{"vectors", "ray-traced", "u, V, N, R, T, L and H at the first surface", drawVectorsFigure},
    Figure{"bounding-volumes", "ray-traced with a structure of volumes",
           "the volumes with the pixel's ray, and their tree", drawBoundingVolumes},
    Figure{"grid", "ray-traced with the structure grid", "the cells on the pixel's ray, and what each lists", drawGrid},
    Figure{"jitter", "ray-traced with several samples", "the pixel's subpixels, where rays pass, and their mean",
           drawJitter},
    Figure{"lens", "ray-traced with samples and an aperture",
           "the pixel's rays through the lens, which meet in the object plane", drawLens},
    Figure{"gloss", "ray-traced with samples", "reflected rays around R", drawGloss},
    Figure{"translucency", "ray-traced with samples", "refracted rays around T", drawTranslucency},
    Figure{"lamp", "ray-traced with samples", "shadow rays over the area of a light, and the share that is seen",
           drawLamp},
    Figure{"penumbra", "ray-traced", "umbra and penumbra of an extended light source in a plane", drawPenumbra},
    Figure{"shutter", "ray-traced with samples", "a moving object at the times of the pixel's rays", drawShutter},
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

} // namespace shadowlab::figures
